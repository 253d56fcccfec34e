#pragma once

#include <cmath>

#include "core/base/predicates.h"
#include "core/fusion/embedding.h"

/// Signs that the overlay decides by, and the areas that it measures with.
namespace graftsman::overlay_detail {

/// a − b = value + error, exactly.
struct ExactSum {
  double value;
  double error;
};

[[nodiscard]] inline ExactSum exactDifference(double a, double b) {
  const double value = a - b;
  const double bVirtual = a - value;
  const double aVirtual = value + bVirtual;
  return {value, (a - aVirtual) + (bVirtual - b)};
}

/// a · b = value + error, exactly unless it underflows.
[[nodiscard]] inline ExactSum exactProduct(double a, double b) {
  const double value = a * b;
  return {value, std::fma(a, b, -value)};
}

/// orient2d() with a short way for what is frequent here and hard for its filter: points that coincide or lie
/// on one line of a grid, where the differences of coordinates are doubles.
[[nodiscard]] inline int orientation(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kErrorBound = 3.3306690738754716e-16;  // Shewchuk 1997
  constexpr double kNoUnderflow = 1e-250;  // products above have exact errors; below, the slow way decides
  const double acx = a.x() - c.x();
  const double bcy = b.y() - c.y();
  const double acy = a.y() - c.y();
  const double bcx = b.x() - c.x();
  const double left = acx * bcy;
  const double right = acy * bcx;
  const double det = left - right;
  const double bound = kErrorBound * (std::abs(left) + std::abs(right)) + kNoUnderflow;
  if (det > bound) {
    return 1;
  }
  if (-det > bound) {
    return -1;
  }
  if ((acx == 0 && acy == 0) || (bcx == 0 && bcy == 0) || (acx == 0 && bcx == 0) || (acy == 0 && bcy == 0)) {
    return 0;  // a difference of doubles is zero only where they are equal
  }
  const bool exactDifferences =
      exactDifference(a.x(), c.x()).error == 0 && exactDifference(b.y(), c.y()).error == 0 &&
      exactDifference(a.y(), c.y()).error == 0 && exactDifference(b.x(), c.x()).error == 0;
  if (exactDifferences && std::abs(left) > kNoUnderflow && std::abs(right) > kNoUnderflow) {
    // The filter failed, so left and right are close: det and the sum below lose nothing that has a sign.
    const ExactSum tail = exactDifference(exactProduct(acx, bcy).error, exactProduct(acy, bcx).error);
    const double sum = det + tail.value;
    const double decides = sum != 0 ? sum : tail.error;
    return (decides > 0) - (decides < 0);
  }
  return orient2d(a, b, c);
}

/// Twice the signed area of a, b, c with a relative error below 1e-12 wherever doubles can hold it;
/// `orientation()` has the exact sign. Embeddings contain valid triangles down to 1e-24.
[[nodiscard]] inline double doubleArea(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kCancellation = 1e-3;  // less of the products left than this: compensate
  const double acx = a.x() - c.x();
  const double bcy = b.y() - c.y();
  const double acy = a.y() - c.y();
  const double bcx = b.x() - c.x();
  const double left = acx * bcy;
  const double right = acy * bcx;
  const double det = left - right;
  if (std::abs(det) > kCancellation * (std::abs(left) + std::abs(right))) {
    return det;
  }
  // Shewchuk 1997: the products' and the differences' errors to first order.
  const double acxError = exactDifference(a.x(), c.x()).error;
  const double bcyError = exactDifference(b.y(), c.y()).error;
  const double acyError = exactDifference(a.y(), c.y()).error;
  const double bcxError = exactDifference(b.x(), c.x()).error;
  const double products = exactProduct(acx, bcy).error - exactProduct(acy, bcx).error;
  const double differences = (acx * bcyError + bcy * acxError) - (acy * bcxError + bcx * acyError);
  return det + (products + differences);
}

}  // namespace graftsman::overlay_detail
