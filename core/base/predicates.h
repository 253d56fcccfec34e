#pragma once

#include <Eigen/Core>
#include <cmath>

namespace graftsman {

/// The exact sign of the signed area of a, b, c: see orient2d(). Slow path, any finite doubles.
[[nodiscard]] int orient2dExact(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// +1 if a, b, c turn counter-clockwise, −1 if clockwise, 0 if they lie on one line: exact for all finite
/// doubles.
[[nodiscard]] inline int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                  const Eigen::Vector2d& c) {
  // Shewchuk 1997, the first stage of orient2d; the absolute term covers products that underflow.
  constexpr double kErrorBound = 3.3306690738754716e-16;
  constexpr double kUnderflow = 1e-290;
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = kErrorBound * (std::abs(left) + std::abs(right)) + kUnderflow;
  if (det > bound) {
    return 1;
  }
  if (-det > bound) {
    return -1;
  }
  return orient2dExact(a, b, c);
}

}  // namespace graftsman
