#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// The shortest way on the surface from `from` to `to` over non-singular vertices, if it is shorter than
/// `bound` and found with at most `budget` windows; otherwise empty. Its length is that of the shortest way
/// but for rounding; its points may need withoutDetours().
///
/// A window is a stretch of an edge that is seen from a vertex over one strip of faces. Windows are led over
/// the surface in the order of the least length of a way through them, and dropped where that exceeds the
/// bound, or where a vertex beside them is known to be nearer. Exact, but dear: about ten times a search over
/// the edges on a mesh of good triangles, if nothing bounds it.
/// Source: Chen & Han 1990; Xin & Wang 2009 (order and filter).
[[nodiscard]] std::vector<EdgePoint> shortestByWindows(const TriangleMesh& mesh, Index from, Index to,
                                                       double bound, std::size_t budget,
                                                       const Progress& progress);

}  // namespace graftsman
