#pragma once

#include <span>
#include <vector>

#include "core/fusion/embedding.h"

namespace graftsman {

/// Where the boundary's vertices lie on the n-gon: corners[i] at corner i, those between in proportion to the
/// lengths of the boundary's edges (Kanai et al. 1999, §2.2). Strictly ascending, and their boundaryPoint()s
/// are far enough apart to be told apart: an edge counts as at least kShortestEdge of its side's mean edge.
/// points: V×3, the first boundarySize the boundary.
[[nodiscard]] std::vector<BoundaryPosition> layOutBoundary(std::span<const Point> points, Index boundarySize,
                                                           std::span<const Index> corners);

}  // namespace graftsman
