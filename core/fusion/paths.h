#pragma once

#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// How a path between two CVs is found.
enum class PathMode {
  Paper,         // selective refinement of the edge graph (Kanai et al. 1999, §2.1)
  Straightened,  // locally shortest on the surface
};

/// A polyline on a mesh from one vertex to another. Each segment lies within one face or along one edge; two
/// consecutive points are never equal; no three consecutive points lie on the same edge; no point occurs
/// twice.
struct Path {
  std::vector<EdgePoint> points;  // at least 2; the first and the last are vertices (the CVs)
  double length = 0;              // model length
};

/// The paths of one mesh's loop: path i leads from CV i to CV (i + 1) mod n. Together they are a simple
/// closed curve.
struct LoopPaths {
  std::vector<std::shared_ptr<const Path>>
      direct;                                      // n; each as if it were alone: depends on its two CVs only
  std::vector<std::shared_ptr<const Path>> paths;  // n; direct[i] itself unless another path stood in the way
};

/// The path from vertex `from` to vertex `to`, as if it were alone. Never passes a singular vertex.
/// Errors: PathImpossible (no way over non-singular vertices), Cancelled.
[[nodiscard]] Result<std::shared_ptr<const Path>> findPath(const TriangleMesh& mesh, Index from, Index to,
                                                           PathMode mode, const Progress& progress);

/// The paths of the loop through `cvs`. `previous` may hold the paths of the same mesh and mode for the CVs
/// `previousCvs`: a direct path between the same two vertices is taken over as the same object, and the whole
/// of `previous->paths` where no direct path changed.
///
/// A path meets another only in their shared CV, and never passes another CV. Where the direct path would,
/// the shortest that was found not to is taken; the longer path gives way. Errors: PathImpossible, PathsCross
/// (names the two paths, their CVs, and what to do), Cancelled.
[[nodiscard]] Result<std::shared_ptr<const LoopPaths>> findPaths(const TriangleMesh& mesh,
                                                                 const std::vector<Index>& cvs, PathMode mode,
                                                                 Side side, const LoopPaths* previous,
                                                                 const std::vector<Index>& previousCvs,
                                                                 const Progress& progress);

}  // namespace graftsman
