#include "core/fusion/fcf.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

namespace graftsman {
namespace {

constexpr std::array<FCF::Preset, 4> kPresets = {FCF::Preset::Linear, FCF::Preset::Paste,
                                                 FCF::Preset::KeepBaseSlope, FCF::Preset::Half};

std::string decimal(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string pointName(std::size_t i) {
  return "point " + std::to_string(i) + " of the fusion curve";
}

// What is wrong with the points, if anything is.
std::optional<Error> findFault(const std::vector<FCFPoint>& points) {
  if (points.size() < 4) {
    return Error{ErrorCode::CurveTooShort,
                 "The fusion curve has " + std::to_string(points.size()) + " points; give at least four."};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [s, f] = points[i];
    if (!(f >= 0 && f <= 1)) {
      return Error{ErrorCode::CurveOutOfRange,
                   "f = " + decimal(f) + " at " + pointName(i) + " is outside 0 to 1; move it inside."};
    }
    if (i == 0 ? s != 0 : i + 1 == points.size() && s != 1) {
      return Error{ErrorCode::CurveEndsWrong,
                   "s = " + decimal(s) + " at " + pointName(i) + "; its " +
                       (i == 0 ? "first point must have s = 0." : "last point must have s = 1.")};
    }
    if (i > 0 && !(s - points[i - 1].s >= FCF::kSmallestStep)) {
      return Error{ErrorCode::CurveNotIncreasing,
                   "s = " + decimal(s) + " at " + pointName(i) +
                       " is not greater than s = " + decimal(points[i - 1].s) +
                       " of the point before it; every s must be greater than the " + "one before."};
    }
  }
  return std::nullopt;
}

// Slopes f′ of the C² cubic through the points with f″ = 0 at both ends: a tridiagonal system, solved by
// elimination without pivoting (it is diagonally dominant).
std::vector<double> naturalSlopes(const std::vector<FCFPoint>& points) {
  const std::size_t last = points.size() - 1;
  const auto step = [&](std::size_t i) { return points[i + 1].s - points[i].s; };
  const auto secant = [&](std::size_t i) { return (points[i + 1].f - points[i].f) / step(i); };
  std::vector<double> slopes(points.size());
  std::vector<double> upper(points.size());
  upper[0] = 0.5;
  slopes[0] = 1.5 * secant(0);
  for (std::size_t i = 1; i <= last; ++i) {
    const bool end = i == last;
    const double left = end ? 1 : step(i);
    const double right = end ? 0 : step(i - 1);
    const double known = end ? 3 * secant(i - 1) : 3 * (step(i) * secant(i - 1) + step(i - 1) * secant(i));
    const double pivot = (end ? 2 : 2 * (left + right)) - left * upper[i - 1];
    upper[i] = right / pivot;
    slopes[i] = (known - left * slopes[i - 1]) / pivot;
  }
  for (std::size_t i = last; i-- > 0;) {
    slopes[i] -= upper[i] * slopes[i + 1];
  }
  return slopes;
}

// Brings each slope to the sign of the secants beside it and to at most three times the flatter one: enough
// for a Hermite cubic to be monotone (Fritsch & Carlson 1980), and the same from left and from right.
void limitSlopes(const std::vector<FCFPoint>& points, std::vector<double>& slopes) {
  const auto limit = [&](double slope, std::size_t i) {
    const double bound = 3 * (points[i + 1].f - points[i].f) / (points[i + 1].s - points[i].s);
    return bound > 0 ? std::clamp(slope, 0.0, bound) : std::clamp(slope, bound, 0.0);
  };
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (i > 0) {
      slopes[i] = limit(slopes[i], i - 1);
    }
    if (i + 1 < slopes.size()) {
      slopes[i] = limit(slopes[i], i);
    }
  }
}

}  // namespace

FCF::FCF() : FCF(preset(Preset::Linear)) {}

FCF::FCF(std::vector<FCFPoint> points, bool monotone) : points_(std::move(points)), monotone_(monotone) {
  std::vector<double> slopes = naturalSlopes(points_);
  if (monotone_) {
    limitSlopes(points_, slopes);
  }
  segments_.resize(points_.size());
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const double step = points_[i + 1].s - points_[i].s;
    const double secant = (points_[i + 1].f - points_[i].f) / step;
    segments_[i] = {points_[i].s, points_[i].f, slopes[i],
                    (3 * secant - 2 * slopes[i] - slopes[i + 1]) / step,
                    (slopes[i] + slopes[i + 1] - 2 * secant) / (step * step)};
  }
  segments_.back() = {1, points_.back().f, 0, 0, 0};
  for (std::size_t cell = 0; cell <= kCells; ++cell) {
    const double start = static_cast<double>(cell) / kCells;
    firstOfCell_[cell] = static_cast<std::uint32_t>(searchSegment(0, segments_.size() - 1, start));
  }
  firstOfCell_.back() = firstOfCell_[kCells];
}

Result<FCF> FCF::through(std::vector<FCFPoint> points, bool monotone) {
  if (std::optional<Error> fault = findFault(points)) {
    return fail(std::move(*fault));
  }
  return FCF(std::move(points), monotone);
}

FCF FCF::preset(Preset preset) {
  switch (preset) {
    case Preset::Linear:
      return {{{0, 0}, {1.0 / 3, 1.0 / 3}, {2.0 / 3, 2.0 / 3}, {1, 1}}, true};
    case Preset::Paste:
      return {{{0, 0}, {0.02, 0.9}, {0.08, 1}, {1, 1}}, true};
    case Preset::KeepBaseSlope:
      return {{{0, 0}, {0.35, 0.02}, {0.65, 0.98}, {1, 1}}, true};
    case Preset::Half:
      break;
  }
  return {{{0, 0.5}, {1.0 / 3, 0.5}, {2.0 / 3, 0.5}, {1, 0.5}}, true};
}

std::size_t FCF::searchSegment(std::size_t first, std::size_t last, double s) const {
  const auto from = segments_.begin() + static_cast<std::ptrdiff_t>(first) + 1;
  const auto to = segments_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
  const auto above =
      std::upper_bound(from, to, s, [](double value, const Segment& segment) { return value < segment.s; });
  return static_cast<std::size_t>(above - segments_.begin()) - 1;
}

std::string_view name(FCF::Preset preset) {
  switch (preset) {
    case FCF::Preset::Linear:
      return "linear";
    case FCF::Preset::Paste:
      return "paste";
    case FCF::Preset::KeepBaseSlope:
      return "keep-base-slope";
    case FCF::Preset::Half:
      break;
  }
  return "half";
}

std::optional<FCF::Preset> presetNamed(std::string_view wanted) {
  const auto* const found = std::find_if(kPresets.begin(), kPresets.end(),
                                         [&](FCF::Preset preset) { return name(preset) == wanted; });
  return found == kPresets.end() ? std::nullopt : std::optional(*found);
}

}  // namespace graftsman
