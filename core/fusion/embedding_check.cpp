#include "core/fusion/embedding_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/predicates.h"

namespace graftsman {
namespace {

/// The overlay puts points on a boundary edge ab at a distance of at least |ab| / 1000 from its ends, rounded
/// by less than 5e-16 (the n-gon lies in the unit circle). So that a, p, c and p, b, c turn the same way,
/// twice the area of a, b, c must exceed 5e-13 times the longer of ac, bc; here with a margin.
constexpr double kFlattest = 1e-12;

double cross(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

bool isGoodTriangle(const Point2& a, const Point2& b, const Point2& c, bool onBoundary) {
  return orient2d(a, b, c) > 0 &&
         (!onBoundary || cross(a, b, c) > kFlattest * std::max((c - a).norm(), (c - b).norm()));
}

bool isGoodFace(const EmbeddingTile& tile, const std::vector<Point2>& uv, Index f) {
  auto [a, b, c] = tile.faces[static_cast<std::size_t>(f)];
  if (a >= tile.boundarySize) {  // turned so that a boundary edge, where there is one, leads from a to b
    std::tie(a, b, c) = std::tuple(b, c, a);
  } else if (b >= tile.boundarySize) {
    std::tie(a, b, c) = std::tuple(c, a, b);
  }
  const auto at = [&](Index v) -> const Point2& { return uv[static_cast<std::size_t>(v)]; };
  return isGoodTriangle(at(a), at(b), at(c), a < tile.boundarySize && b < tile.boundarySize);
}

LayoutCheck checkLayout(const EmbeddingTile& tile, const std::vector<Point2>& uv, Index sides) {
  LayoutCheck check;
  const double total = sides * std::sin(2 * std::numbers::pi / sides);  // twice the n-gon's area
  double least = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < tile.faces.size(); ++f) {
    const auto [i, j, k] = tile.faces[f];
    const Point2& a = uv[static_cast<std::size_t>(i)];
    const Point2& b = uv[static_cast<std::size_t>(j)];
    const Point2& c = uv[static_cast<std::size_t>(k)];
    if (orient2d(a, b, c) <= 0) {
      ++check.flippedFaces;
      check.badFaces.push_back(static_cast<Index>(f));
    } else if (std::min({i, j, k}) < tile.boundarySize && !isGoodFace(tile, uv, static_cast<Index>(f))) {
      check.badFaces.push_back(static_cast<Index>(f));
    }
    const double area = cross(a, b, c) / total;
    if (tile.areas[f] > 0 && area < least * tile.areas[f]) {
      least = area / tile.areas[f];
    }
    if (std::abs(area) < LayoutCheck::kSqueezed * tile.areas[f]) {
      check.squeezedShare += tile.areas[f];
    }
  }
  check.smallestAreaRatio = least;
  return check;
}

}  // namespace graftsman
