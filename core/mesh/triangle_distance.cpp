#include "core/mesh/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace graftsman {
namespace {

// A cross product's error, in units of both lengths' product.
constexpr double kProductRounding = 4 * 2.220446049250313e-16;

// From the nearest point of the segment a, b to p.
Eigen::Vector3d fromSegment(const Point& p, const Point& a, const Point& b) {
  const Eigen::Vector3d ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0 ? std::clamp(ab.dot(p - a) / squared, 0.0, 1.0) : 0;
  return (p - a) - t * ab;
}

}  // namespace

double distanceToTriangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const std::array<Eigen::Vector3d, 3> fromEdges = {fromSegment(p, a, b), fromSegment(p, b, c),
                                                    fromSegment(p, c, a)};
  const Eigen::Vector3d nearest = *std::min_element(
      fromEdges.begin(), fromEdges.end(),
      [](const auto& one, const auto& other) { return one.squaredNorm() < other.squaredNorm(); });
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto inside = [&](const Point& from, const Point& to) {
    return (to - from).cross(p - from).dot(normal) >= 0;
  };
  if (normal.squaredNorm() == 0 || !inside(a, b) || !inside(b, c) || !inside(c, a)) {
    return nearest.norm();
  }
  // The height above the plane, from the edge's point: inside a needle that one is so near that the normal's
  // error does not matter, as it would from a corner. Far above one it does.
  const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const double height = std::abs(nearest.dot(normal)) / normal.norm();
  const double normalError = kProductRounding * longest2 / normal.norm();
  return std::min(nearest.norm(), height + normalError * nearest.norm());
}

}  // namespace graftsman
