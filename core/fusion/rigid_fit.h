#pragma once

#include <Eigen/Core>
#include <span>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// The centroid of `points` (n×3, n ≥ 1). Summed relative to the first, so that a model far from the origin
/// loses nothing.
[[nodiscard]] Point centroid(std::span<const Point> points);

/// The rotation R (det +1) that minimises Σ |to[i] − R from[i]|² (Arun, Huang, Blostein 1987). Both n×3,
/// relative to their centroids. Where the points leave the rotation about a line free (collinear on either
/// side): the smallest of the best rotations. Never a reflection. Identity if all points of a side are 0.
[[nodiscard]] Eigen::Matrix3d bestRotation(std::span<const Point> from, std::span<const Point> to);

/// The smallest rotation that takes the direction `from` to the direction `to` (both of unit length);
/// opposite directions: half a turn about an axis that depends on `from` alone.
[[nodiscard]] Eigen::Matrix3d smallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// A unit vector perpendicular to `direction` (of unit length): the projection of the coordinate axis that
/// is farthest from it.
[[nodiscard]] Eigen::Vector3d perpendicularTo(const Eigen::Vector3d& direction);

}  // namespace graftsman
