#pragma once

#include <set>

#include "core/base/error.h"
#include "core/project/fusion.h"

/// The edits of a fusion that can be illegal or need thought: each gives the fusion after it, or an Error
/// that says why not and what to do. Pure. Those of a whole document are in document_edits.h.
namespace graftsman::edits {

/// With the mesh of one side replaced. The loop is emptied, since its CVs on that side name points of the old
/// mesh, unless there was no mesh before.
[[nodiscard]] Fusion loadMesh(Fusion fusion, Side side, std::shared_ptr<const MeshAsset> asset);

/// With the pair inserted before pair `at` (0 … n; n appends). A CV on another fusion's result remembers its
/// place. Errors: LoopRepeatsPoint, LoopIndexOutOfRange.
[[nodiscard]] Result<Fusion> insertPair(Fusion fusion, std::size_t at, const CVP& pair);

/// With CV `number` of one side elsewhere. Errors: as insertPair.
[[nodiscard]] Result<Fusion> moveCV(Fusion fusion, std::size_t number, Side side, const SurfacePoint& to);

/// Without these pairs; a loop left with fewer than three is open again. Precondition: each < n.
[[nodiscard]] Fusion removePairs(Fusion fusion, const std::set<int>& numbers);

/// Error: LoopTooShort.
[[nodiscard]] Result<Fusion> closeLoop(Fusion fusion);
[[nodiscard]] Fusion openLoop(Fusion fusion);

/// The pairs in the other direction, pair 0 first as before: what was right of the loop is left of it.
[[nodiscard]] Fusion reverseLoop(Fusion fusion);
/// CV i of the part becomes the partner of the base's CV i + 1 (mod n).
[[nodiscard]] Fusion shiftCorrespondence(Fusion fusion);
/// The part's CVs are paired in the other direction, CV 0 as before; the base's stay.
[[nodiscard]] Fusion mirrorCorrespondence(Fusion fusion);

/// Empties the loop.
[[nodiscard]] Fusion clearLoop(Fusion fusion);

}  // namespace graftsman::edits
