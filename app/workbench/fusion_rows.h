#pragma once

#include <QString>
#include <map>
#include <vector>

#include "core/project/document.h"
#include "widgets/panels/fusion_tree_model.h"

namespace graftsman {

/// What is known of a fusion's result.
struct KnownResult {
  std::size_t faces = 0;
  QString problem;  // why there is none; empty: there is one
};
using KnownResults = std::map<FusionId, KnownResult>;

/// A fusion's name as a person sees it: its own, or made of the present names of its part and base ("cone on
/// head"). Empty: there is no such fusion.
[[nodiscard]] QString fusionName(const FusionList& fusions, FusionId id);

/// The mesh that the base of fusion `id` goes back to, through the results that it is made of; null: none.
[[nodiscard]] std::shared_ptr<const MeshAsset> firstBase(const FusionList& fusions, FusionId id);

/// The fusions as a tree: at the top those that no other is made of, in the order of the list, under each its
/// part and its base, and under one that is another's result that one's own. One that is used twice is there
/// twice.
[[nodiscard]] std::vector<FusionRow> fusionRows(const FusionList& fusions, FusionId shown,
                                                const KnownResults& known);

}  // namespace graftsman
