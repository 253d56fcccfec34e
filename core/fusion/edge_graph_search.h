#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// Some short way from `from` to `to` along edges over non-singular vertices; empty if there is none, or if
/// cancelled. A* that trusts the straight distance more than it is right to: the way may be longer than the
/// shortest by half at most, but few vertices beside it are visited.
[[nodiscard]] std::vector<EdgePoint> quickWayAlongEdges(const TriangleMesh& mesh, Index from, Index to,
                                                        const Progress& progress);

}  // namespace graftsman
