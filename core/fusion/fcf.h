#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace graftsman {

/// A point of the fusion curve.
struct FCFPoint {
  double s = 0;
  double f = 0;
  friend bool operator==(const FCFPoint&, const FCFPoint&) = default;
};

/// The fusion control function f(s) (Kanai et al. 1999, §2.3): a non-uniform cubic B-spline through four or
/// more points, knots at their s-values, so that s(t) = t and f is a function of s. Ends: second derivative
/// 0. Values outside [0, 1] are clamped. A value; always valid.
class FCF {
 public:
  enum class Preset { Linear, Paste, KeepBaseSlope, Half };

  /// Linear.
  FCF();

  /// The curve through `points`; `monotone`: never above or below both neighbours' f between two points (its
  /// slopes are limited after Fritsch & Carlson 1980; the curve is then C¹ only). Errors: CurveTooShort,
  /// CurveEndsWrong, CurveNotIncreasing, CurveOutOfRange; each names the point by its number.
  [[nodiscard]] static Result<FCF> through(std::vector<FCFPoint> points, bool monotone = false);

  /// After Fig. 4 (a)–(d).
  [[nodiscard]] static FCF preset(Preset preset);

  [[nodiscard]] const std::vector<FCFPoint>& points() const { return points_; }
  [[nodiscard]] bool monotone() const { return monotone_; }

  /// f(s), in [0, 1], for s in [0, 1]; s outside is clamped.
  [[nodiscard]] double operator()(double s) const;

  /// f of many: out[i] = f(s[i]). Same bits as one by one. Allocates nothing.
  void evaluate(std::span<const double> s, std::span<double> out) const;

  friend bool operator==(const FCF& a, const FCF& b) {
    return a.points_ == b.points_ && a.monotone_ == b.monotone_;
  }

 private:
  FCF(std::vector<FCFPoint> points, bool monotone);

  std::vector<FCFPoint> points_;
  std::vector<double> slopes_;  // f′ at the points
  bool monotone_ = false;
};

/// "linear", "paste", "keep-base-slope" or "half".
[[nodiscard]] std::string_view name(FCF::Preset preset);

}  // namespace graftsman
