#include "core/fusion/embedding_weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace graftsman {
namespace {

/// Twice the area over the longest edge squared, below which a triangle counts as this flat. The element
/// matrix stays a Gram matrix over a positive number, thus positive semidefinite; weights stay below 10⁷.
constexpr double kFlat = 1e-7;

/// Added to each cotangent weight (which are about 1), so that a vertex whose triangles all have a point for
/// the opposite edge still hangs on its neighbours.
constexpr double kStiffness = 1e-9;

/// Range of tan(angle / 2) in mean value weights, so that angles of 0 and π keep positive, finite weights.
constexpr double kLeastTangent = 1e-6;
constexpr double kGreatestTangent = 1e6;

/// Share of a star's longest edge that an edge counts as at least.
constexpr double kShortestSpoke = 1e-6;

/// A number per corner of each face, at 3f + k.
template <class PerFace>
std::vector<double> perCorner(const EmbeddingTile& tile, PerFace&& perFace) {
  std::vector<double> out(3 * tile.faces.size());
  for (std::size_t f = 0; f < tile.faces.size(); ++f) {
    const auto point = [&](std::size_t k) -> const Point& {
      return tile.points[static_cast<std::size_t>(tile.faces[f][k])];
    };
    perFace(point(0), point(1), point(2), &out[3 * f]);
  }
  return out;
}

void cotangents(const Point& a, const Point& b, const Point& c, double* out) {
  const Point bc = c - b;
  const Point ca = a - c;
  const Point ab = b - a;
  const double longest = std::max({bc.squaredNorm(), ca.squaredNorm(), ab.squaredNorm()});
  if (longest < std::numeric_limits<double>::min()) {
    std::fill(out, out + 3, std::numbers::inv_sqrt3);
    return;
  }
  const double twiceArea = std::max(ab.cross(ca).norm(), kFlat * longest);
  out[0] = -ca.dot(ab) / twiceArea;
  out[1] = -ab.dot(bc) / twiceArea;
  out[2] = -bc.dot(ca) / twiceArea;
}

double tangentOfHalf(const Point& u, const Point& v) {
  const double cross = u.cross(v).norm();
  const double dot = u.dot(v);
  const double product = u.norm() * v.norm();
  const double tangent = dot >= 0 ? cross / (product + dot) : (product - dot) / cross;
  return std::isnan(tangent) ? std::numbers::inv_sqrt3 : std::clamp(tangent, kLeastTangent, kGreatestTangent);
}

void halfTangents(const Point& a, const Point& b, const Point& c, double* out) {
  out[0] = tangentOfHalf(b - a, c - a);
  out[1] = tangentOfHalf(c - b, a - b);
  out[2] = tangentOfHalf(a - c, b - c);
}

Index nextCorner(Index h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}

Index previousCorner(Index h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

}  // namespace

SlotWeights cotangentWeights(const EmbeddingTile& tile, const Stars& stars) {
  const std::vector<double> cotangent = perCorner(tile, cotangents);
  SlotWeights weights(stars.ring.size());
  for (std::size_t r = 0; r + 1 < stars.offsets.size(); ++r) {
    const auto begin = static_cast<std::size_t>(stars.offsets[r]);
    const auto end = static_cast<std::size_t>(stars.offsets[r + 1]);
    Index before = stars.halfedges[end - 1];
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Index h = stars.halfedges[slot];
      weights[slot] = cotangent[static_cast<std::size_t>(previousCorner(h))] +
                      cotangent[static_cast<std::size_t>(nextCorner(before))] + kStiffness;
      before = h;
    }
  }
  return weights;
}

SlotWeights meanValueWeights(const EmbeddingTile& tile, const Stars& stars) {
  const std::vector<double> tangent = perCorner(tile, halfTangents);
  SlotWeights weights(stars.ring.size());
  for (std::size_t r = 0; r + 1 < stars.offsets.size(); ++r) {
    const auto begin = static_cast<std::size_t>(stars.offsets[r]);
    const auto end = static_cast<std::size_t>(stars.offsets[r + 1]);
    const Point& centre = tile.points[r + static_cast<std::size_t>(tile.boundarySize)];
    double longest = 0;
    for (std::size_t slot = begin; slot < end; ++slot) {
      weights[slot] = (tile.points[static_cast<std::size_t>(stars.ring[slot])] - centre).norm();
      longest = std::max(longest, weights[slot]);
    }
    Index before = stars.halfedges[end - 1];
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Index h = stars.halfedges[slot];
      const double length = longest > 0 ? std::max(weights[slot] / longest, kShortestSpoke) : 1;
      weights[slot] =
          (tangent[static_cast<std::size_t>(h)] + tangent[static_cast<std::size_t>(before)]) / length;
      before = h;
    }
  }
  return weights;
}

SlotWeights uniformWeights(const Stars& stars) {
  return SlotWeights(stars.ring.size(), 1.0);
}

}  // namespace graftsman
