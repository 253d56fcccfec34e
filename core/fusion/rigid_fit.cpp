#include "core/fusion/rigid_fit.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace graftsman {
namespace {

// Second singular value relative to the first below which the points count as collinear: what coordinates
// far from the origin leave of a straight line, 1e6 sizes away, is noise of about this height.
constexpr double kCollinear = 1e-10;

// Sine of an angle below which two directions count as the same or opposite: rounding error of unit vectors.
constexpr double kParallel = 1e-15;

// First singular value, relative to its greatest possible, below which two loops have nothing in common: it
// is rounding error then, and would give a rotation by chance.
constexpr double kUnrelatedAxes = 1e-12;

double greatestNorm(std::span<const Point> points) {
  double greatest = 0;
  for (const Point& p : points) {
    greatest = std::max(greatest, p.norm());
  }
  return greatest;
}

}  // namespace

Point centroid(std::span<const Point> points) {
  Point sum = Point::Zero();
  for (const Point& p : points) {
    sum += p - points[0];
  }
  return points[0] + sum / static_cast<double>(points.size());
}

Eigen::Vector3d perpendicularTo(const Eigen::Vector3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().minCoeff(&axis);
  const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
  return (unit - unit.dot(direction) * direction).normalized();
}

Eigen::Matrix3d smallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  // Within the plane of both, spanned by `from` and `side`; taking `side` perpendicular once more keeps the
  // result exact for directions that are nearly opposite.
  const Eigen::Vector3d across = to - to.dot(from) * from;
  Eigen::Vector3d side = perpendicularTo(from);
  if (across.norm() > kParallel) {
    side = across.normalized();
    side = (side - side.dot(from) * from).normalized();
  }
  const Eigen::Vector2d turned = Eigen::Vector2d(to.dot(from), to.dot(side)).normalized();
  const Eigen::Vector3d axis = from.cross(side);
  return turned.x() * (from * from.transpose() + side * side.transpose()) +
         turned.y() * (side * from.transpose() - from * side.transpose()) + axis * axis.transpose();
}

Eigen::Matrix3d bestRotation(std::span<const Point> from, std::span<const Point> to) {
  assert(from.size() == to.size());
  const double fromSize = greatestNorm(from);
  const double toSize = greatestNorm(to);
  if (!(fromSize > 0 && toSize > 0)) {
    return Eigen::Matrix3d::Identity();
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    covariance += (from[i] / fromSize) * (to[i] / toSize).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.info() != Eigen::Success) {  // not finite
    return Eigen::Matrix3d::Identity();
  }
  const Eigen::Vector3d& singular = svd.singularValues();
  const Eigen::Matrix3d& u = svd.matrixU();
  const Eigen::Matrix3d& v = svd.matrixV();
  if (singular[0] <= kUnrelatedAxes * static_cast<double>(from.size())) {
    return Eigen::Matrix3d::Identity();
  }
  if (singular[1] <= kCollinear * singular[0]) {
    return smallestRotation(u.col(0), v.col(0));
  }
  // The third directions as cross products instead of the SVD's: that is Arun's correction of the sign in
  // the least significant direction, and holds for planar points, too.
  Eigen::Matrix3d fromFrame = u;
  Eigen::Matrix3d toFrame = v;
  fromFrame.col(2) = u.col(0).cross(u.col(1));
  toFrame.col(2) = v.col(0).cross(v.col(1));
  return toFrame * fromFrame.transpose();
}

}  // namespace graftsman
