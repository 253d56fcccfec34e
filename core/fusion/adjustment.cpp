#include "core/fusion/adjustment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/base/parallel.h"
#include "core/fusion/line_field.h"
#include "core/fusion/rigid_fit.h"

namespace graftsman {
namespace {

// |k − 1| of an iteration up to which k counts as 1: what the scaling would still move is a ten-thousandth
// of what the line field or the eye could tell.
constexpr double kScaleSettled = 1e-6;

// Correlation of the two loops below which no scale relates them: it would be rounding error, and shrink the
// part to a speck.
constexpr double kUnrelated = 1e-9;

// A CV pair's distance, in units of its greatest coordinate, up to which the two are one point: an ulp or two
// of rounding.
constexpr double kCoordinateRounding = 4 * 2.220446049250313e-16;

// Points per task: a millisecond for a loop of ordinary size.
constexpr std::size_t kPointGrain = 1 << 14;

/// x ↦ scale · rotation · (x − from) + to, where x is a part's point and the image is relative to the base's
/// centroid.
struct Placement {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Point from = Point::Zero();
  Point to = Point::Zero();

  [[nodiscard]] Point operator()(const Point& x) const { return scale * (rotation * (x - from)) + to; }
};

std::optional<Error> checkSettings(const AdjustmentSettings& settings) {
  const auto wrong = [](const std::string& what) { return Error{ErrorCode::SettingOutOfRange, what}; };
  if (!(settings.epsilon >= 0 && std::isfinite(settings.epsilon))) {
    return wrong("The adjustment's epsilon is " + std::to_string(settings.epsilon) +
                 "; set it to 0 or more.");
  }
  if (!(settings.falloff > 0 && std::isfinite(settings.falloff))) {
    return wrong("The line field's falloff n is " + std::to_string(settings.falloff) +
                 "; set it to a number greater than 0 (the paper uses 5).");
  }
  if (settings.maxIterations < 1) {
    return wrong("The adjustment's greatest number of iterations is " +
                 std::to_string(settings.maxIterations) + "; set it to 1 or more.");
  }
  return std::nullopt;
}

double greatestDistance(std::span<const Point> cvs) {
  double greatest = 0;
  for (std::size_t i = 0; i < cvs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      greatest = std::max(greatest, (cvs[i] - cvs[j]).squaredNorm());
    }
  }
  return std::sqrt(greatest);
}

double meanDistance(std::span<const Point> a, std::span<const Point> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]).norm();
  }
  return sum / static_cast<double>(a.size());
}

bool coincide(std::span<const Point> cvs) {
  return std::all_of(cvs.begin(), cvs.end(), [&](const Point& p) { return p == cvs[0]; });
}

Error degenerate(std::string message, std::optional<Side> side = {}) {
  return Error{ErrorCode::LoopDegenerate, std::move(message), side};
}

/// The steps on the CVs alone: `part` moves, `base` stays; both relative to the base's centroid.
class Steps {
 public:
  Steps(std::span<const Point> partCvs, std::span<const Point> baseCvs, const AdjustmentSettings& settings)
      : settings_(settings), partCvs_(partCvs), baseCvs_(baseCvs), baseCentroid_(centroid(baseCvs)) {
    placement_.from = centroid(partCvs);
    placement_.to = placement_.from - baseCentroid_;
    for (std::size_t i = 0; i < partCvs.size(); ++i) {
      centred_.push_back(partCvs[i] - placement_.from);
      base_.push_back(baseCvs[i] - baseCentroid_);
    }
    part_.resize(partCvs.size());
    place();
    report_.loopDiameter = greatestDistance(baseCvs);
    report_.distanceBefore = distance();
    report_.distanceAfterRigid = report_.distanceBefore;
    report_.distanceAfterScale = report_.distanceBefore;
    report_.distanceAfterLineField = report_.distanceBefore;
  }

  /// STEPs 1 and 2. True if STEP 3 is still wanted.
  [[nodiscard]] Result<bool> run() {
    if (coincides()) {
      return false;  // a best rotation would only add rounding errors
    }
    if (settings_.rigid) {
      fitRigid();
      report_.reached = AdjustmentStep::Rigid;
      report_.distanceAfterRigid = report_.distanceAfterScale = report_.distanceAfterLineField = distance();
    }
    bool close = isClose();
    bool settled = false;
    while (settings_.scale && !close && !settled && report_.iterations < settings_.maxIterations) {
      const double k = bestScale();
      if (!(k > 0)) {
        return fail(degenerate(
            "No scale greater than 0 fits the loops to each other, they are too different; pick the CVs of "
            "both in the same order and direction, or turn the adjustment's scaling off."));
      }
      placement_.scale *= k;
      settings_.rigid ? fitRigid() : place();
      ++report_.iterations;
      report_.reached = AdjustmentStep::Scale;
      report_.distanceAfterScale = report_.distanceAfterLineField = distance();
      settled = std::abs(k - 1) <= kScaleSettled;
      close = isClose();
    }
    return settings_.lineField && !close;
  }

  /// STEP 3's field.
  [[nodiscard]] Result<LineField> lineField() const {
    const Eigen::Matrix3d turn =
        settings_.rigid ? Eigen::Matrix3d::Identity() : bestRotation(centred_, base_);
    std::vector<BoundaryLine> lines = boundaryLines(part_, base_, turn);
    if (lines.empty()) {
      return fail(
          degenerate("No two neighbouring CVs lie apart on both meshes, so that the line field has no line; "
                     "move the CVs "
                     "that share a position, or turn the line field off."));
    }
    return LineField(std::move(lines), report_.loopDiameter, settings_.falloff);
  }

  void noteLineField(const LineField& field) {
    std::vector<Point> moved = part_;
    field.move(moved);
    report_.reached = AdjustmentStep::LineField;
    report_.distanceAfterLineField = meanDistance(moved, base_);
  }

  /// The report, with the transform in the models' coordinates.
  [[nodiscard]] AdjustmentReport report() const {
    AdjustmentReport report = report_;
    report.scale = placement_.scale;
    if (report.reached != AdjustmentStep::None) {
      report.transform.rotation = placement_.rotation;
      report.transform.translation =
          baseCentroid_ + placement_.to - placement_.scale * (placement_.rotation * placement_.from);
    }
    return report;
  }

  [[nodiscard]] const Placement& placement() const { return placement_; }
  [[nodiscard]] const Point& baseCentroid() const { return baseCentroid_; }

 private:
  void fitRigid() {
    // From the CVs as given, not as they stand: rounding does not add up, and scaling changes no rotation.
    placement_.rotation = bestRotation(centred_, base_);
    placement_.to = Point::Zero();
    place();
  }

  void place() {
    for (std::size_t i = 0; i < part_.size(); ++i) {
      part_[i] = placement_(partCvs_[i]);
    }
  }

  // k of Eq. 3, both loops about their centroids: ∂E/∂k = 0. 0 if there is no positive one.
  [[nodiscard]] double bestScale() const {
    double products = 0;
    double squares = 0;
    double baseSquares = 0;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      const Eigen::Vector3d x = part_[i] - placement_.to;
      products += x.dot(base_[i]);
      squares += x.squaredNorm();
      baseSquares += base_[i].squaredNorm();
    }
    const double k = products / squares;
    return products > kUnrelated * std::sqrt(squares * baseSquares) && std::isfinite(k) ? k : 0;
  }

  [[nodiscard]] bool coincides() const {
    for (std::size_t i = 0; i < partCvs_.size(); ++i) {
      const Point& a = partCvs_[i];
      const Point& b = baseCvs_[i];
      const double greatest = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
      if ((a - b).cwiseAbs().maxCoeff() > kCoordinateRounding * greatest) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] double distance() const { return meanDistance(part_, base_); }
  [[nodiscard]] bool isClose() const { return distance() <= settings_.epsilon * report_.loopDiameter; }

  const AdjustmentSettings& settings_;
  std::span<const Point> partCvs_;
  std::span<const Point> baseCvs_;
  Point baseCentroid_;
  std::vector<Point> centred_;  // the part's CVs as given, relative to their centroid
  std::vector<Point> part_;     // the part's CVs as they stand
  std::vector<Point> base_;
  Placement placement_;
  AdjustmentReport report_;
};

// Moves all points. False if cancelled.
bool movePoints(std::span<const Point> points, const Placement& placement, const Point& origin,
                const LineField* field, const Progress& progress, std::vector<Point>& moved) {
  std::atomic<std::size_t> done = 0;
  parallelRanges(points.size(), kPointGrain, [&](std::size_t begin, std::size_t end) {
    if (!progress.keepGoing(static_cast<double>(done) / static_cast<double>(points.size()))) {
      return;
    }
    for (std::size_t i = begin; i < end; ++i) {
      moved[i] = placement(points[i]);
    }
    if (field != nullptr) {
      field->move(std::span(moved).subspan(begin, end - begin));
    }
    for (std::size_t i = begin; i < end; ++i) {
      moved[i] += origin;
    }
    done += end - begin;
  });
  return progress.keepGoing(1);
}

}  // namespace

Result<Adjustment> adjust(std::span<const Point> points, std::span<const Point> partCvs,
                          std::span<const Point> baseCvs, const AdjustmentSettings& settings,
                          const Progress& progress) {
  assert(partCvs.size() == baseCvs.size() && partCvs.size() >= 3);
  if (std::optional<Error> fault = checkSettings(settings)) {
    return fail(std::move(*fault));
  }
  for (const Side side : {Side::Part, Side::Base}) {
    if (coincide(side == Side::Part ? partCvs : baseCvs)) {
      return fail(degenerate(std::string("All CVs of the ") + name(side) +
                                 " lie at the same position; spread them round the tile.",
                             side));
    }
  }
  Steps steps(partCvs, baseCvs, settings);
  const Result<bool> deform = steps.run();
  if (!deform) {
    return fail(deform.error());
  }
  std::optional<LineField> field;
  if (*deform) {
    Result<LineField> made = steps.lineField();
    if (!made) {
      return fail(std::move(made.error()));
    }
    field = std::move(*made);
    steps.noteLineField(*field);
  }
  Adjustment adjustment{std::vector<Point>(points.begin(), points.end()), steps.report()};
  const bool moves = adjustment.report.reached != AdjustmentStep::None;
  if (moves && !movePoints(points, steps.placement(), steps.baseCentroid(), field ? &*field : nullptr,
                           progress, adjustment.points)) {
    return fail(ErrorCode::Cancelled, "The adjustment was cancelled.");
  }
  return adjustment;
}

}  // namespace graftsman
