#pragma once

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/adjustment.h"
#include "core/fusion/boundary_lines.h"
#include "core/fusion/line_field.h"
#include "core/fusion/rigid_fit.h"

namespace graftsman {

using Points = std::vector<Point>;

inline constexpr double kPi = std::numbers::pi;

inline Points randomPoints(std::uint32_t seed, std::size_t count, double size = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-size, size);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(unit(random), unit(random), unit(random));
  }
  return points;
}

inline Eigen::Matrix3d rotation(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

inline Points moved(const Points& points, const Eigen::Matrix3d& linear, const Point& shift) {
  Points result;
  for (const Point& p : points) {
    result.emplace_back(linear * p + shift);
  }
  return result;
}

// A circle of radius 1 in the plane z = 0, bent by `bump` out of it.
inline Points ring(int count, double bump = 0) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double a = 2 * kPi * i / count;
    points.emplace_back(std::cos(a), std::sin(a), bump * std::sin(2 * a));
  }
  return points;
}

inline double greatestDifference(const Points& a, const Points& b) {
  double greatest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    greatest = std::max(greatest, (a[i] - b[i]).norm());
  }
  return greatest;
}

inline Adjustment adjusted(const Points& points, const Points& part, const Points& base,
                           const AdjustmentSettings& settings = {}) {
  return adjust(points, part, base, settings, Progress()).value();
}

inline Error errorOf(const Points& part, const Points& base, const AdjustmentSettings& settings = {}) {
  const Result<Adjustment> result = adjust(part, part, base, settings, Progress());
  return result ? Error{ErrorCode::Unexpected, "no error"} : result.error();
}

}  // namespace graftsman
