#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/fusion/path_obstacles.h"

namespace graftsman {

/// The path that selective refinement makes of `points`: keeps the faces around the path, puts additional
/// points on their edges, searches again there, and so on, until the length settles; never longer than given.
/// Cancelled: the best so far. Source: Kanai et al. 1999, §2.1; Lanthier et al. 1997; Kanai & Suzuki 2001.
[[nodiscard]] std::vector<EdgePoint> refined(const TriangleMesh& mesh, const PathObstacles& obstacles,
                                             std::vector<EdgePoint> points, const Progress& progress);

}  // namespace graftsman
