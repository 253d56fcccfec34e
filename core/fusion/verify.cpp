#include "core/fusion/verify.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/fusion/seam_angles.h"
#include "core/mesh/triangle_distance.h"

namespace graftsman {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
// Rounding of a corner in the unit circle moves it by at most 2⁻⁵³ in x and y: a face whose doubled area is
// above minus this times its longest edge may be counter-clockwise before rounding.
constexpr double kCornerRounding = 4 * 2.220446049250313e-16;
// A position's rounding, in units of the greatest coordinate: a sum of three products, each rounded.
constexpr double kPositionRounding = 8 * 2.220446049250313e-16;

// The vertices of an embedding in space: the tile's, then the added ones.
std::vector<Point> embeddedPoints(std::span<const Point> tile, const Embedding& embedding) {
  std::vector<Point> points(tile.begin(), tile.end());
  for (const AddedVertex& added : embedding.added) {
    const Point& origin = points[static_cast<std::size_t>(added.corners[0])];
    Point p = origin;
    for (int k = 1; k < 3; ++k) {
      if (added.weights[k] != 0) {
        p += added.weights[k] *
             (points[static_cast<std::size_t>(added.corners[static_cast<std::size_t>(k)])] - origin);
      }
    }
    points.push_back(p);
  }
  return points;
}

double greatestDistance(const CombinedTile& combined, std::span<const Point> positions,
                        std::span<const Index> parents, std::span<const Point> tilePoints,
                        std::span<const Face> tileFaces) {
  double greatest = 0;
  for (std::size_t f = 0; f < combined.faces.size(); ++f) {
    const Face& parent = tileFaces[static_cast<std::size_t>(parents[f])];
    const auto corner = [&](std::size_t k) -> const Point& {
      return tilePoints[static_cast<std::size_t>(parent[k])];
    };
    for (const Index v : combined.faces[f]) {
      const Point& p = positions[static_cast<std::size_t>(v)];
      greatest = std::max(greatest, distanceToTriangle(p, corner(0), corner(1), corner(2)));
    }
  }
  return greatest;
}

Eigen::Vector3d areaVector(std::span<const Point> points, const Face& face) {
  const Point& a = points[static_cast<std::size_t>(face[0])];
  return (points[static_cast<std::size_t>(face[1])] - a)
             .cross(points[static_cast<std::size_t>(face[2])] - a) /
         2;
}

double area(std::span<const Point> points, std::span<const Face> faces) {
  double sum = 0;
  for (const Face& face : faces) {
    sum += areaVector(points, face).norm();
  }
  return sum;
}

void measureEmbedding(const CombinedTile& combined, Index sides, Verification& verification) {
  double sum = 0;
  for (const auto& [a, b, c] : combined.faces) {
    const Point2& p = combined.uv[static_cast<std::size_t>(a)];
    const Point2 u = combined.uv[static_cast<std::size_t>(b)] - p;
    const Point2 v = combined.uv[static_cast<std::size_t>(c)] - p;
    const double doubled = u.x() * v.y() - u.y() * v.x();
    const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
    verification.invertedFaces += doubled < -kCornerRounding * longest ? 1 : 0;
    sum += doubled / 2;
  }
  const double whole = sides * std::sin(2 * std::numbers::pi / sides) / 2;
  verification.embeddedAreaError = std::abs(sum - whole) / whole;
}

Index countChanged(const FusionResults& results) {
  const Join& join = *results.join;
  const TriangleMesh& base = *results.inputs.base;
  std::vector<bool> onSeam(results.fused->points.size(), false);
  for (Index i = 0; i < results.combined->seamSize; ++i) {
    onSeam[static_cast<std::size_t>(join.tileVertices[static_cast<std::size_t>(i)])] = true;
  }
  Index changed = 0;
  for (std::size_t v = 0; v < join.baseVertices.size(); ++v) {
    const Index original = join.baseVertices[v];
    if (original >= base.vertexCount() || onSeam[v]) {
      continue;
    }
    using Bits = std::array<std::uint64_t, 3>;
    const auto bits = [](const Point& p) { return std::bit_cast<Bits>(std::array{p.x(), p.y(), p.z()}); };
    const bool equal = bits(base.point(original)) == bits(results.fused->points[v]);
    changed += equal ? 0 : 1;
  }
  return changed;
}

// Three digits, whatever the locale.
std::string shortText(double value) {
  constexpr int kDigits = 3;
  std::array<char, 32> text = {};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kDigits);
  return std::string(text.data(), end.ptr);
}

}  // namespace

bool Verification::topologyKept() const {
  return (result.manifold || !base.manifold) && (result.oriented || !base.oriented) &&
         result.closed == base.closed && result.eulerCharacteristic == base.eulerCharacteristic &&
         result.borderLoops == base.borderLoops;
}

std::string Verification::broken() const {
  constexpr double kAreaTolerance = 1e-12;
  std::string list;
  const auto expect = [&list](bool holds, const std::string& otherwise) {
    if (!holds) {
      list += (list.empty() ? "" : ", ") + otherwise;
    }
  };
  expect(baseUnchanged(),
         std::to_string(changedBaseVertices) + " vertices of the base outside the tile moved");
  expect(topologyKept(), "the result is not as closed, manifold or oriented as the base");
  expect(invertedFaces == 0, std::to_string(invertedFaces) + " faces of the combined tile are turned over");
  expect(embeddedAreaError <= kAreaTolerance,
         "the combined tile's area is off by " + shortText(embeddedAreaError) + " of it");
  expect(baseDistance <= tolerance,
         "the combined tile leaves the base by " + shortText(baseDistance) + " of its diagonal");
  expect(partDistance <= tolerance, "the combined tile leaves the adjusted part by " +
                                        shortText(partDistance) + " of the base's diagonal");
  return list;
}

Verification verify(const FusionResults& results) {
  const CombinedTile& combined = *results.combined;
  const TriangleMesh& base = *results.inputs.base;
  const Tile& baseTile = *results.base.tile;
  const TriangleMesh mesh(results.fused->points, results.fused->faces());

  Verification verification;
  verification.base = checkMesh(base);
  verification.result = checkMesh(mesh);
  const std::vector<Point> basePoints = embeddedPoints(baseTile.points, *results.base.embedding);
  const std::vector<Point> partPoints = embeddedPoints(results.fitted->points, *results.part.embedding);
  const double diagonal = base.diagonal();
  verification.baseDistance = greatestDistance(combined, combined.base, combined.baseFaces, basePoints,
                                               results.base.embedding->faces) /
                              diagonal;
  verification.partDistance = greatestDistance(combined, combined.part, combined.partFaces, partPoints,
                                               results.part.embedding->faces) /
                              diagonal;
  const double tileArea = area(baseTile.points, baseTile.faces);
  verification.baseAreaError = std::abs(area(combined.base, combined.faces) - tileArea) / tileArea;
  double farthest = 0;
  for (const auto* points : {&basePoints, &partPoints}) {
    for (const Point& p : *points) {
      farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    }
  }
  verification.tolerance = std::max(1e-12, kPositionRounding * farthest / diagonal);
  measureEmbedding(combined, results.base.embedding->sides, verification);
  const SeamAngles angles = seamAngles(results.fused->points, *results.join, combined.seamSize);
  verification.meanSeamAngle = angles.mean * kDegrees;
  verification.greatestSeamAngle = angles.greatest * kDegrees;
  verification.changedBaseVertices = countChanged(results);
  return verification;
}

}  // namespace graftsman
