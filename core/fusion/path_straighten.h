#pragma once

#include <vector>

#include "core/fusion/path_obstacles.h"

namespace graftsman {

/// The locally shortest path that the polyline `points` shrinks to on the surface without passing over an
/// obstacle: at no vertex that it may cross is the angle on either side below π. Near obstacles it stays
/// inside the intervals, off their blocked ends. Never longer than given. The result is free of detours and
/// loops (see path_points.h) and, if `points` meets no obstacle, so does the result.
///
/// The strip of faces along the path is unfolded in the plane, a funnel finds the shortest way in it, and
/// where that bends round a vertex with less than π on the other side, the strip is led round there; again
/// until nothing is gained. Each round is strictly shorter, and their number is bounded.
/// A round that gains less than the part `worth` of the length is the last: 0 for all, more for a quick
/// bound. Precondition: `points` has no detours; each point but the ends is free. Source: Xin & Wang 2007;
/// Lee & Preparata 1984.
[[nodiscard]] std::vector<EdgePoint> straightened(const TriangleMesh& mesh, const PathObstacles& obstacles,
                                                  std::vector<EdgePoint> points, double worth = 0);

}  // namespace graftsman
