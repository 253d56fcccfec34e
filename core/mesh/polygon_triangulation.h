#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Triangulates a weakly convex polygon inside one triangle, the *parent*: corner k is ids[k] at points[k],
/// and sides[k] is a bit mask of the parent's edges that it lies on (bit 0: edge 0→1, bit 1: edge 1→2, bit 2:
/// edge 2→0; a corner of the parent has two bits, an interior point none). Appends k − 2 triangles to `out`,
/// counter-clockwise as the polygon.
///
/// No triangle has its three vertices on one edge of the parent, whatever the positions: validity is decided
/// by the masks alone. Among valid ears, the one with the largest smallest angle is cut off first (ties: the
/// lowest corner); the last four corners get the better of their two diagonals.
///
/// Precondition: the polygon is convex, its corners of one side of the parent are consecutive, and they are
/// not all on one side. Interior points on one line are not told apart from others: where a chord is divided,
/// take each triangle beside it as a parent of its own. Cost O(k log k), no allocation for k ≤ 4.
void triangulatePolygon(std::span<const Index> ids, std::span<const Point> points,
                        std::span<const std::uint8_t> sides, std::vector<Face>& out);

}  // namespace graftsman
