#pragma once

#include <functional>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/project/document.h"

/// The edits of a whole document: its fusions and its variants. Each gives the document after it, or an Error
/// that says why not and what to do. Pure.
namespace graftsman::edits {

/// With the fusion of that id in place of the one that has it. Precondition: there is one.
[[nodiscard]] Document withFusion(Document document, Fusion fusion);

/// The id of the next fusion: greater than any that a fusion of the document or of a variant has.
[[nodiscard]] FusionId nextFusion(const Document& document);

/// With another fusion at the end, of this part and base (null: not loaded), its id nextFusion().
[[nodiscard]] Document addFusion(Document document, std::shared_ptr<const MeshAsset> part,
                                 std::shared_ptr<const MeshAsset> base);

/// The result of fusion `id` as a part or base of others; its mesh is computed later.
[[nodiscard]] std::shared_ptr<const MeshAsset> resultAsset(const Fusion& fusion);

/// With the result of fusion `upstream` as the part or base of fusion `id`; its loop is emptied if there was
/// a mesh on that side. Error: SourcesInCircle. Precondition: both are there.
[[nodiscard]] Result<Document> takeResult(Document document, FusionId id, Side side, FusionId upstream);

/// Without the fusion. Those that its result was a part or base of take its own base instead, with the CVs on
/// it found again by their places. The last fusion that goes leaves an empty one.
[[nodiscard]] Document removeFusion(Document document, FusionId id);

/// A fusion's name; empty: none of its own.
[[nodiscard]] Document renameFusion(Document document, FusionId id, const std::string& name);

/// The present state of the fusions as a variant at the end of the list, named `name` or, where that is
/// empty, "Variant 3". Its id is greater than any that the document has.
[[nodiscard]] Document addVariant(Document document, FusionId shown, const std::string& name = {});
/// The same for another state of the fusions (as one in the undo history).
[[nodiscard]] Document addVariant(Document document, const FusionList& fusions, FusionId shown,
                                  const std::string& name = {});

/// With the variant of that id in place of the one that has it. Precondition: there is one.
[[nodiscard]] Document withVariant(Document document, Variant variant);
[[nodiscard]] Document removeVariants(Document document, const std::set<VariantId>& ids);
/// The fusions as they are in the variant. Precondition: it is there.
[[nodiscard]] Document applyVariant(Document document, VariantId id);

/// With `change` made to the fusion that each of these variants shows.
[[nodiscard]] Document changeVariants(Document document, const std::set<VariantId>& ids,
                                      const std::function<void(Fusion&)>& change);

/// A new variant at the end: all of `first`, but the fusion curve of what `second` shows.
/// Precondition: both are there.
[[nodiscard]] Document crossVariants(Document document, VariantId first, VariantId second);

}  // namespace graftsman::edits
