#pragma once

#include <set>

#include "core/base/error.h"
#include "core/project/document.h"

/// The edits of a document that can be illegal or need thought: each gives the document after it, or an Error
/// that says why not and what to do. Pure.
namespace graftsman::edits {

/// With the mesh of one side replaced. The loop is emptied, since its CVs on that side name points of the old
/// mesh, unless there was no mesh before.
[[nodiscard]] Document loadMesh(Document document, Side side, std::shared_ptr<const MeshAsset> asset);

/// With the pair inserted before pair `at` (0 … n; n appends). Errors: LoopRepeatsPoint, LoopIndexOutOfRange.
[[nodiscard]] Result<Document> insertPair(Document document, std::size_t at, const CVP& pair);

/// With CV `number` of one side elsewhere. Errors: as insertPair.
[[nodiscard]] Result<Document> moveCV(Document document, std::size_t number, Side side,
                                      const SurfacePoint& to);

/// Without these pairs; a loop left with fewer than three is open again. Precondition: each < n.
[[nodiscard]] Document removePairs(Document document, const std::set<int>& numbers);

/// Error: LoopTooShort.
[[nodiscard]] Result<Document> closeLoop(Document document);
[[nodiscard]] Document openLoop(Document document);

/// The pairs in the other direction, pair 0 first as before: what was right of the loop is left of it.
[[nodiscard]] Document reverseLoop(Document document);
/// CV i of the part becomes the partner of the base's CV i + 1 (mod n).
[[nodiscard]] Document shiftCorrespondence(Document document);
/// The part's CVs are paired in the other direction, CV 0 as before; the base's stay.
[[nodiscard]] Document mirrorCorrespondence(Document document);

/// Empties the loop.
[[nodiscard]] Document clearLoop(Document document);

}  // namespace graftsman::edits
