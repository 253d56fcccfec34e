#include "widgets/curve/curve_edit.h"

#include <algorithm>
#include <cmath>

namespace graftsman {
namespace {

int lastOf(const FCF& curve) {
  return static_cast<int>(curve.points().size()) - 1;
}

}  // namespace

AllowedS allowedS(const FCF& curve, int point) {
  const std::vector<FCFPoint>& points = curve.points();
  const auto i = static_cast<std::size_t>(point);
  const double own = points[i].s;
  if (point == 0 || point == lastOf(curve)) {
    return {own, own};
  }
  const double from = points[i - 1].s + kPointGap;
  const double to = points[i + 1].s - kPointGap;
  return from <= to ? AllowedS{from, to} : AllowedS{own, own};
}

FCF withPointMoved(const FCF& curve, int point, const FCFPoint& wanted) {
  std::vector<FCFPoint> points = curve.points();
  FCFPoint& moved = points[static_cast<std::size_t>(point)];
  if (wanted.s != moved.s) {  // a point that a file put closer than the gap stays while only its f changes
    const AllowedS allowed = allowedS(curve, point);
    moved.s = std::clamp(wanted.s, allowed.from, allowed.to);
  }
  moved.f = std::clamp(wanted.f, 0.0, 1.0);
  return FCF::through(std::move(points), curve.monotone()).value_or(curve);
}

tl::expected<AddedPoint, QString> withPointAdded(const FCF& curve, const FCFPoint& at) {
  std::vector<FCFPoint> points = curve.points();
  for (const FCFPoint& point : points) {
    if (std::abs(point.s - at.s) < kPointGap) {
      return tl::unexpected(QStringLiteral(
          "There is no room for another point so close to this one. Add it a little farther away."));
    }
  }
  const auto next =
      std::find_if(points.begin(), points.end(), [&](const FCFPoint& point) { return point.s > at.s; });
  const auto added = static_cast<int>(next - points.begin());
  points.insert(next, {at.s, std::clamp(at.f, 0.0, 1.0)});
  Result<FCF> result = FCF::through(std::move(points), curve.monotone());
  if (!result) {
    return tl::unexpected(QString::fromStdString(result.error().message));
  }
  return AddedPoint{*std::move(result), added};
}

tl::expected<FCF, QString> withPointRemoved(const FCF& curve, int point) {
  if (point == 0) {
    return tl::unexpected(QStringLiteral("The first point stays: the curve begins at the seam, s = 0."));
  }
  if (point == lastOf(curve)) {
    return tl::unexpected(QStringLiteral("The last point stays: the curve ends at the centre, s = 1."));
  }
  std::vector<FCFPoint> points = curve.points();
  if (points.size() <= 4) {
    return tl::unexpected(
        QStringLiteral("A fusion curve has at least four points. Add another one before you remove this."));
  }
  points.erase(points.begin() + point);
  Result<FCF> result = FCF::through(std::move(points), curve.monotone());
  if (!result) {
    return tl::unexpected(QString::fromStdString(result.error().message));
  }
  return *std::move(result);
}

}  // namespace graftsman
