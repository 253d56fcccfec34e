#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
///
/// Differs: monotone by default (the knots where slopes are limited count as double knots of the B-spline).
/// The plain spline through Fig. 4's curves swings far out of [0, 1]: that of (b) falls from 1 to below 0
/// between s = 0.08 and 1, that of (c) leaves 0 with a kink at s = 0.34 once clamped. Where the plain spline
/// is monotone between its points, both are the same curve.
class FCF {
 public:
  enum class Preset { Linear, Paste, KeepBaseSlope, Half };

  /// Points closer than this in s cannot be told apart by a hand or a mesh; their slope has no use either.
  static constexpr double kSmallestStep = 1e-9;

  /// Linear.
  FCF();

  /// The curve through `points`; `monotone`: never above or below both neighbours' f between two points (its
  /// slopes are limited after Fritsch & Carlson 1980; the curve is then C¹ only). Errors: CurveTooShort,
  /// CurveEndsWrong, CurveNotIncreasing (also by less than kSmallestStep), CurveOutOfRange; each names the
  /// point by its number, from 0.
  [[nodiscard]] static Result<FCF> through(std::vector<FCFPoint> points, bool monotone = true);

  /// After Fig. 4 (a)–(d): Linear f = s; Paste f = 1 from s = 0.08 on; KeepBaseSlope f′(0) = f′(1) = 0;
  /// Half f = 0.5.
  [[nodiscard]] static FCF preset(Preset preset);

  [[nodiscard]] const std::vector<FCFPoint>& points() const { return points_; }
  [[nodiscard]] bool monotone() const { return monotone_; }

  /// f(s), in [0, 1], for s in [0, 1]; s outside is clamped (and NaN taken for 0). Exactly the points' f at
  /// their s.
  [[nodiscard]] double operator()(double s) const {
    s = inUnit(s);
    return segments_[segmentAt(s)](s);
  }

  /// f of many: out[i] = f(s[i]). Same bits as one by one. Allocates nothing. Precondition: equal sizes.
  void evaluate(std::span<const double> s, std::span<double> out) const;

  friend bool operator==(const FCF& a, const FCF& b) {
    return a.points_ == b.points_ && a.monotone_ == b.monotone_;
  }

 private:
  /// f + c1 t + c2 t² + c3 t³ with t = (s − this s), up to the next segment's s.
  struct Segment {
    double s = 0;
    double f = 0;
    double c1 = 0;
    double c2 = 0;
    double c3 = 0;

    [[nodiscard]] double operator()(double at) const {
      const double t = at - s;
      return inUnit(f + t * (c1 + t * (c2 + t * c3)));
    }
  };
  static constexpr int kCells = 64;

  FCF(std::vector<FCFPoint> points, bool monotone);

  [[nodiscard]] static double inUnit(double x) {
    x = x > 0 ? x : 0;
    return x < 1 ? x : 1;
  }

  template <std::size_t N>
  void evaluateFew(std::span<const double> s, std::span<double> out) const;

  [[nodiscard]] std::size_t segmentAt(double s) const {
    const auto cell = static_cast<std::size_t>(s * kCells);
    const std::uint32_t first = firstOfCell_[cell];
    const std::uint32_t last = firstOfCell_[cell + 1];
    return first == last ? first : searchSegment(first, last, s);
  }
  [[nodiscard]] std::size_t searchSegment(std::size_t first, std::size_t last, double s) const;

  std::vector<FCFPoint> points_;
  std::vector<Segment> segments_;  // one a point; the last is the constant at s = 1
  /// Of each of kCells equal cells of [0, 1]: the segment in force at its start; then 1's own, twice.
  std::array<std::uint32_t, kCells + 2> firstOfCell_ = {};
  bool monotone_ = true;
};

/// "linear", "paste", "keep-base-slope" or "half".
[[nodiscard]] std::string_view name(FCF::Preset preset);

/// The preset of that name.
[[nodiscard]] std::optional<FCF::Preset> presetNamed(std::string_view name);

/// The curve that a text names: a preset's name, or its points as "s,f;s,f;…" (spaces around numbers are
/// allowed; monotone). Errors: as FCF::through(), and CurveOutOfRange naming the point that is no pair of
/// numbers.
[[nodiscard]] Result<FCF> parseFCF(std::string_view text);

}  // namespace graftsman
