#pragma once

#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman::overlay_detail {

/// A cell of the overlay has at most this many corners: it is where two triangles meet.
inline constexpr std::size_t kMostCorners = 6;

/// Appends the k − 2 triangles of a strictly convex cell with k ≥ 3 corners, counter-clockwise as the cell.
/// Any diagonal is valid; chosen are those whose triangles have the best shapes on both surfaces together.
/// part, base: every vertex's positions.
void triangulateCell(std::span<const Index> corners, std::span<const Point> part, std::span<const Point> base,
                     std::vector<Face>& out);

}  // namespace graftsman::overlay_detail
