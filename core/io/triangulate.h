#pragma once

#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Appends the n − 2 triangles of a polygon to `faces`, oriented as the polygon is; nothing for n < 3.
///
/// corners: vertex numbers in order; points: V×3. A quadrilateral is divided by the diagonal that leaves no
/// triangle turned over and has the larger smallest angle, a larger polygon by cutting off its best ear again
/// and again, a very large one by a constrained Delaunay triangulation in its plane. Where the polygon
/// crosses itself or has no area, a fan from a corner fills what is left. Every decision on the shape is an
/// exact predicate on coordinates; the same polygon always gets the same triangles. A corner may occur more
/// than once; then some triangles may have a repeated vertex. Cost: quadratic for up to kMostEars corners, n
/// log n beyond.
void triangulate(std::span<const Index> corners, const std::vector<Point>& points, std::vector<Face>& faces);

/// Up to so many corners ears are cut; beyond, the Delaunay triangulation is faster.
inline constexpr std::size_t kMostEars = 100;

/// The vector area of a polygon, twice (Newell): normal to its mean plane.
[[nodiscard]] Point newellNormal(std::span<const Index> corners, const std::vector<Point>& points);

/// The constrained Delaunay triangulation of a polygon given in the plane, counter-clockwise; triangles as
/// corner numbers, ordered by their smallest. Empty if the polygon is not simple.
[[nodiscard]] std::vector<Face> delaunayTriangles(const std::vector<Eigen::Vector2d>& polygon);

}  // namespace graftsman
