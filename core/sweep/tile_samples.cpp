#include "core/sweep/tile_samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace graftsman {
namespace {

double crossProduct(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

TileSamples::TileSamples(const CombinedTile& combined, std::size_t count) {
  const auto first = static_cast<std::size_t>(combined.seamSize);
  const std::size_t interior = combined.uv.size() - first;
  const std::size_t taken = std::min(count, interior);
  for (std::size_t i = 0; i < taken; ++i) {
    uv_.push_back(combined.uv[first + i * interior / taken]);
  }
  if (uv_.empty()) {
    uv_.push_back(Point2::Zero());
  }
  std::sort(uv_.begin(), uv_.end(), [](const Point2& a, const Point2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
}

// Rounding may leave a sample on the edge of two faces outside both: it belongs to where it is deepest.
void TileSamples::locate(const std::shared_ptr<const CombinedTile>& in) {
  if (locatedIn_ == in) {
    return;
  }
  locatedIn_ = in;
  const CombinedTile& combined = *in;
  places_.assign(uv_.size(), {});
  std::vector<double> depths(uv_.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t f = 0; f < combined.faces.size(); ++f) {
    const Face& face = combined.faces[f];
    const std::array<Point2, 3> corner = {combined.uv[static_cast<std::size_t>(face[0])],
                                          combined.uv[static_cast<std::size_t>(face[1])],
                                          combined.uv[static_cast<std::size_t>(face[2])]};
    const auto [left, right] = std::minmax({corner[0].x(), corner[1].x(), corner[2].x()});
    const auto [low, high] = std::minmax({corner[0].y(), corner[1].y(), corner[2].y()});
    const double area = crossProduct(corner[0], corner[1], corner[2]);
    auto sample =
        std::lower_bound(uv_.begin(), uv_.end(), left, [](const Point2& uv, double u) { return uv.x() < u; });
    for (; sample != uv_.end() && sample->x() <= right; ++sample) {
      if (sample->y() < low || sample->y() > high || !(area > 0)) {
        continue;
      }
      const Eigen::Vector3d weights = Eigen::Vector3d(crossProduct(*sample, corner[1], corner[2]),
                                                      crossProduct(corner[0], *sample, corner[2]),
                                                      crossProduct(corner[0], corner[1], *sample)) /
                                      area;
      const auto i = static_cast<std::size_t>(sample - uv_.begin());
      if (weights.minCoeff() > depths[i]) {
        depths[i] = weights.minCoeff();
        const Eigen::Vector3d inside = weights.cwiseMax(0);
        places_[i] = {f, inside / inside.sum()};
      }
    }
  }
}

template <class PointOf>
std::vector<Point> TileSamples::interpolated(const PointOf& pointOf) const {
  std::vector<Point> points;
  points.reserve(places_.size());
  for (const Place& place : places_) {
    Point point = Point::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = locatedIn_->faces[place.face][k];
      point += place.weights[static_cast<Eigen::Index>(k)] * pointOf(static_cast<std::size_t>(v));
    }
    points.push_back(point);
  }
  return points;
}

std::vector<Point> TileSamples::positions(const FusionResults& results) {
  assert(results.fused);
  locate(results.combined);
  return interpolated([&](std::size_t v) -> const Point& {
    return results.fused->points[static_cast<std::size_t>(results.join->tileVertices[v])];
  });
}

double TileSamples::partDistance(const FusionResults& results) {
  locate(results.combined);
  const CombinedTile& combined = *results.combined;
  return rootMeanSquareDistance(
      interpolated([&](std::size_t v) -> const Point& { return combined.part[v]; }),
      interpolated([&](std::size_t v) -> const Point& { return combined.base[v]; }));
}

double rootMeanSquareDistance(const std::vector<Point>& a, const std::vector<Point>& b) {
  assert(a.size() == b.size() && !a.empty());
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace graftsman
