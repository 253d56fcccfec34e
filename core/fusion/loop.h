#pragma once

#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// A corresponding vertex pair (Kanai et al. 1999, §2.1): one picked surface point on each mesh.
struct CVP {
  SurfacePoint part;
  SurfacePoint base;
  friend bool operator==(const CVP&, const CVP&) = default;
};

/// The closed loop CV 0 → CV 1 → … → CV 0, counter-clockwise seen from outside: the tile lies on its left.
using Loop = std::vector<CVP>;

/// One mesh with every CV of the loop at a vertex.
struct AnchoredLoop {
  /// The mesh itself where all CVs are vertices; otherwise a copy in which the faces (and, for a CV on an
  /// edge, the faces beside it) are divided. Old vertices keep their numbers and bits, new ones follow; old
  /// faces keep their numbers unless divided, a divided face's first piece takes its number and the other
  /// pieces follow at the end.
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<Index> cvs;  // n; vertex of `mesh` for each CV
  std::vector<Index>
      parents;  // of each face of `mesh`, the face of the given mesh; empty where mesh is the given one
};

/// Checks the CVs of one side and puts each at a vertex. A bary weight of exactly 0 or 1 means edge or
/// vertex. Errors: LoopTooShort (n < 3), LoopIndexOutOfRange, LoopPointInvalid (a weight negative, not
/// finite, or the sum not within 1e-6 of 1; smaller deviations are normalised), LoopRepeatsPoint,
/// LoopPointSingular. Each names CV and side.
[[nodiscard]] Result<AnchoredLoop> anchorLoop(const std::shared_ptr<const TriangleMesh>& mesh,
                                              const Loop& loop, Side side);

/// The same for any number of pairs, that make no loop yet.
[[nodiscard]] Result<AnchoredLoop> anchorPoints(const std::shared_ptr<const TriangleMesh>& mesh,
                                                const Loop& pairs, Side side);

}  // namespace graftsman
