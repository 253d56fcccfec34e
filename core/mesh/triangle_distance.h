#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// The distance of p from the segment from a to b, which may be a point.
[[nodiscard]] inline double distanceToSegment(const Point& p, const Point& a, const Point& b) {
  const Eigen::Vector3d ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0 ? std::clamp(ab.dot(p - a) / squared, 0.0, 1.0) : 0;
  return (p - (a + t * ab)).norm();
}

/// The distance of p from a triangle: of the nearest of its edges, or its plane where p is above the inside.
/// Needles keep their accuracy, and a triangle without area is its edges.
[[nodiscard]] inline double distanceToTriangle(const Point& p, const Point& a, const Point& b,
                                               const Point& c) {
  const double edges =
      std::min({distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto inside = [&](const Point& from, const Point& to) {
    return (to - from).cross(p - from).dot(normal) >= 0;
  };
  if (normal.squaredNorm() == 0 || !inside(a, b) || !inside(b, c) || !inside(c, a)) {
    return edges;
  }
  return std::min(edges, std::abs((p - a).dot(normal)) / normal.norm());
}

}  // namespace graftsman
