#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "core/mesh/triangle_mesh.h"

/// Generated tiles for tests and benchmarks: discs whose first vertices are the boundary, counter-clockwise.
namespace graftsman::shapes {

struct DiscTile {
  std::vector<Point> points;
  std::vector<Face> faces;
  Index boundarySize = 0;
  std::vector<Index> corners;
};

/// `sides` corners spread evenly over the boundary.
inline std::vector<Index> evenCorners(Index boundarySize, Index sides) {
  std::vector<Index> corners;
  for (Index i = 0; i < sides; ++i) {
    corners.push_back(static_cast<Index>(static_cast<std::int64_t>(boundarySize) * i / sides));
  }
  return corners;
}

/// Concentric rings of sizes[0] (the boundary), sizes[1], … vertices round one vertex in the middle.
/// at(depth, angle): the position, depth from 0 on the boundary to 1 in the middle, angle in [0, 2π).
inline DiscTile rings(const std::vector<Index>& sizes, Index sides,
                      const std::function<Point(double, double)>& at) {
  DiscTile tile;
  std::vector<Index> starts;
  const auto depth = [&](std::size_t ring) {
    return static_cast<double>(ring) / static_cast<double>(sizes.size());
  };
  for (std::size_t ring = 0; ring < sizes.size(); ++ring) {
    starts.push_back(static_cast<Index>(tile.points.size()));
    for (Index i = 0; i < sizes[ring]; ++i) {
      tile.points.push_back(at(depth(ring), 2 * std::numbers::pi * i / sizes[ring]));
    }
  }
  const auto middle = static_cast<Index>(tile.points.size());
  tile.points.push_back(at(1, 0));
  for (std::size_t ring = 0; ring + 1 < sizes.size(); ++ring) {
    const Index a = sizes[ring];
    const Index b = sizes[ring + 1];
    Index i = 0;
    Index j = 0;
    while (i < a || j < b) {
      const Index outer = starts[ring] + i % a;
      const Index inner = starts[ring + 1] + j % b;
      // Advance on the ring whose next vertex comes first.
      if (j == b || (i < a && std::int64_t{2 * i + 1} * b <= std::int64_t{2 * j + 1} * a)) {
        tile.faces.push_back({outer, starts[ring] + (i + 1) % a, inner});
        ++i;
      } else {
        tile.faces.push_back({outer, starts[ring + 1] + (j + 1) % b, inner});
        ++j;
      }
    }
  }
  for (Index i = 0; i < sizes.back(); ++i) {
    tile.faces.push_back({starts.back() + i, starts.back() + (i + 1) % sizes.back(), middle});
  }
  tile.boundarySize = sizes[0];
  tile.corners = evenCorners(sizes[0], sides);
  return tile;
}

/// Ring sizes 6 count, 6 (count − 1), …, 6: about 6 count² faces of about one size on a disc.
inline std::vector<Index> discSizes(Index count) {
  std::vector<Index> sizes;
  for (Index i = count; i > 0; --i) {
    sizes.push_back(6 * i);
  }
  return sizes;
}

/// The unit hemisphere over the plane z = 0.
inline DiscTile hemisphere(Index count, Index sides) {
  return rings(discSizes(count), sides, [](double depth, double angle) {
    const double latitude = depth * std::numbers::pi / 2;
    return Point(std::cos(latitude) * std::cos(angle), std::cos(latitude) * std::sin(angle),
                 std::sin(latitude));
  });
}

/// A tube of radius 1 and the given height, closed by a flat lid, of about equilateral faces, `around`
/// vertices a ring.
inline DiscTile horn(double height, Index around, Index sides) {
  const double edge = 2 * std::numbers::pi / around;
  const auto rows = static_cast<Index>(std::ceil(height / (edge * 0.87)));
  const Index lid = std::max<Index>(1, around / 6);
  std::vector<Index> sizes(static_cast<std::size_t>(rows), around);
  for (Index i = lid; i > 0; --i) {
    sizes.push_back(around * i / lid);
  }
  const double bend = static_cast<double>(rows) / static_cast<double>(sizes.size());
  return rings(sizes, sides, [=](double depth, double angle) {
    const double r = depth <= bend ? 1 : (1 - depth) / (1 - bend);
    return Point(r * std::cos(angle), r * std::sin(angle), height * std::min(1.0, depth / bend));
  });
}

/// Flips interior edges at random, `rounds` times as many tries as edges, without making double edges or
/// dividing what `flips` forbids (a test on the two new faces). Deterministic for a seed.
inline void flipAtRandom(DiscTile& tile, double rounds, unsigned seed,
                         const std::function<bool(const Face&, const Face&)>& mayMake) {
  std::map<std::pair<Index, Index>, Index> halfedges;  // (from, to) → 3f + k
  const auto put = [&](Index f) {
    for (Index k = 0; k < 3; ++k) {
      const Face& face = tile.faces[static_cast<std::size_t>(f)];
      halfedges[{face[static_cast<std::size_t>(k)], face[static_cast<std::size_t>((k + 1) % 3)]}] = 3 * f + k;
    }
  };
  for (Index f = 0; f < static_cast<Index>(tile.faces.size()); ++f) {
    put(f);
  }
  std::mt19937 random(seed);
  const auto tries = static_cast<std::size_t>(rounds * 1.5 * static_cast<double>(tile.faces.size()));
  for (std::size_t i = 0; i < tries; ++i) {
    const auto h = static_cast<Index>(random() % (3 * tile.faces.size()));
    Face& one = tile.faces[static_cast<std::size_t>(h / 3)];
    const auto k = static_cast<std::size_t>(h % 3);
    const Index a = one[k];
    const Index b = one[(k + 1) % 3];
    const Index c = one[(k + 2) % 3];
    const auto twin = halfedges.find({b, a});
    if (twin == halfedges.end()) {
      continue;
    }
    const Index g = twin->second / 3;
    Face& other = tile.faces[static_cast<std::size_t>(g)];
    const Index d = other[static_cast<std::size_t>((twin->second % 3 + 2) % 3)];
    if (halfedges.contains({c, d}) || halfedges.contains({d, c}) || !mayMake({a, d, c}, {b, c, d})) {
      continue;
    }
    halfedges.erase({a, b});
    halfedges.erase({b, a});
    one = {a, d, c};
    other = {b, c, d};
    put(h / 3);
    put(g);
  }
}

}  // namespace graftsman::shapes
