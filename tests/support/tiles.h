#pragma once

#include <Eigen/Geometry>
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

/// The tile over (m + 1)×(n + 1) points in rows, two triangles per cell, corners at the four corners.
inline DiscTile gridDisc(Index m, Index n, const std::vector<Point>& points) {
  const Index w = m + 1;
  std::vector<Index> order;
  const auto walk = [&](Index from, Index step, Index count) {
    for (Index i = 0; i < count; ++i) {
      order.push_back(from + i * step);
    }
  };
  walk(0, 1, m);
  walk(m, w, n);
  walk(n * w + m, -1, m);
  walk(n * w, -w, n);
  for (Index j = 1; j < n; ++j) {
    walk(j * w + 1, 1, m - 1);
  }
  DiscTile tile;
  std::vector<Index> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
    tile.points.push_back(points[static_cast<std::size_t>(order[i])]);
  }
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < m; ++i) {
      const auto at = [&](Index x, Index y) { return number[static_cast<std::size_t>(y * w + x)]; };
      tile.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      tile.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  tile.boundarySize = 2 * (m + n);
  tile.corners = {0, m, m + n, 2 * m + n};
  return tile;
}

/// A unit disc with bumps of the given height, of about 6 count² faces; vertices shifted, edges flipped at
/// random.
inline DiscTile bumpyDisc(Index count, Index sides, double height, unsigned seed) {
  std::mt19937 random(seed);
  const auto shift = [&] { return 0.35 / count * (static_cast<double>(random() % 2001) / 1000 - 1); };
  DiscTile tile = rings(discSizes(count), sides, [&](double depth, double angle) {
    const double x = (1 - depth) * std::cos(angle) + (depth > 0 ? shift() : 0);
    const double y = (1 - depth) * std::sin(angle) + (depth > 0 ? shift() : 0);
    return Point(x, y, height * (std::sin(9 * x) * std::cos(8 * y) + 0.4 * std::sin(31 * x + 5 * y)));
  });
  const auto isUpright = [&](const Face& f) {
    const auto at = [&](std::size_t k) { return tile.points[static_cast<std::size_t>(f[k])]; };
    const Point ab = at(1) - at(0);
    const Point ac = at(2) - at(0);
    return ab.x() * ac.y() - ab.y() * ac.x() > 0.1 / (count * count);
  };
  flipAtRandom(tile, 0.2, seed, [&](const Face& a, const Face& b) { return isUpright(a) && isUpright(b); });
  return tile;
}

/// A flat square of about 24×12 that carries two tubes of radius 1 and the given heights, closed by lids.
inline DiscTile twoHorns(double left, double right) {
  constexpr Index kPerRadius = 3;  // cells of the grid per radius
  const Index m = 24 * kPerRadius;
  const Index n = 12 * kPerRadius;
  // Each grid vertex near a tube's axis moves up the tube: rings of the square r = max(|x|, |y|) < 4 become
  // circles; from r = 4 to 3 they close in on the tube, from 3 to 1 they climb, below 1 they form the lid.
  const auto lift = [&](double x, double y, double middle, double height) {
    const double r = std::max(std::abs(x - middle), std::abs(y));
    const double length = std::hypot(x - middle, y);
    const Eigen::Vector2d direction =
        length > 0 ? Eigen::Vector2d(Eigen::Vector2d(x - middle, y) / length) : Eigen::Vector2d(1, 0);
    const double radius = r >= 3 ? 1 + 3 * (r - 3) : std::min(1.0, r);
    const double blend = r >= 3 ? r - 3 : 0;  // square at r = 4, circle from r = 3 inwards
    const Eigen::Vector2d flat = (1 - blend) * radius * direction + blend * Eigen::Vector2d(x - middle, y);
    return Point(middle + flat.x(), flat.y(), height * std::clamp((3 - r) / 2, 0.0, 1.0));
  };
  std::vector<Point> points;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= m; ++i) {
      const double x = static_cast<double>(i) / kPerRadius - 12;
      const double y = static_cast<double>(j) / kPerRadius - 6;
      const double middle = x < 0 ? -6 : 6;
      const bool isNear = std::max(std::abs(x - middle), std::abs(y)) < 4;
      points.push_back(isNear ? lift(x, y, middle, x < 0 ? left : right) : Point(x, y, 0));
    }
  }
  return gridDisc(m, n, points);
}

}  // namespace graftsman::shapes
