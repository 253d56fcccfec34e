#pragma once

#include <CGAL/Exact_rational.h>
#include <QtTest>
#include <algorithm>
#include <map>
#include <numeric>

#include "core/base/parallel.h"
#include "core/fusion/combined_tile.h"
#include "core/fusion/overlay_cells.h"
#include "core/fusion/overlay_predicates.h"
#include "core/fusion/overlay_vertices.h"
#include "core/fusion/seam_merge.h"
#include "core/fusion/vertex_snap.h"
#include "tests/support/embeddings.h"

namespace graftsman {

using shapes::TestTile;

using Rational = CGAL::Exact_rational;

struct ExactPoint {
  Rational x;
  Rational y;
};

inline Rational doubleArea(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline ExactPoint exact(const Point2& p) {
  return {Rational(p.x()), Rational(p.y())};
}

/// The overlay with what it was made from.
struct Overlaid {
  overlay_detail::Layers layers;
  overlay_detail::Trace trace;
  overlay_detail::VertexNumbers numbers;
  CombinedTile combined;
};

template <class T>
T valueOf(Result<T> result) {
  if (!result) {
    throw std::runtime_error(result.error().message);
  }
  return std::move(*result);
}

// Without the snapping of interior vertices: near ones are apart.
inline Overlaid overlaidAsTheyAre(const TestTile& part, const TestTile& base) {
  Overlaid o;
  o.layers = valueOf(overlay_detail::mergeSeams(part.embedding, base.embedding));
  o.trace = valueOf(overlay_detail::traceBase(o.layers, {}));
  o.numbers = overlay_detail::numberVertices(o.layers, o.trace);
  overlay_detail::placeVertices(part.view(), base.view(), o.layers, o.trace, o.numbers, o.combined);
  if (const auto filled = overlay_detail::fillCells(o.layers, o.trace, o.numbers, o.combined, {}); !filled) {
    throw std::runtime_error(filled.error().message);
  }
  return o;
}

inline Overlaid overlaid(const TestTile& part, const TestTile& base) {
  Overlaid o;
  o.layers = valueOf(overlay_detail::mergeSeams(part.embedding, base.embedding));
  o.trace = valueOf(overlay_detail::snapAndTrace(o.layers, {}));
  o.numbers = overlay_detail::numberVertices(o.layers, o.trace);
  o.combined = valueOf(overlay(part.view(), base.view(), {}));
  return o;
}

/// Each combined vertex's position in rational numbers: the layers' vertices as stored, crossings where the
/// two edges' lines meet, without any shift.
inline std::vector<ExactPoint> exactPositions(const Overlaid& o) {
  std::vector<ExactPoint> positions(static_cast<std::size_t>(o.numbers.count));
  for (Index v = 0; v < o.layers.base.vertexCount(); ++v) {
    positions[static_cast<std::size_t>(v)] = exact(o.layers.base.at(v));
  }
  for (Index w = 0; w < o.layers.part.vertexCount(); ++w) {
    positions[static_cast<std::size_t>(o.numbers.ofPart[static_cast<std::size_t>(w)])] =
        exact(o.layers.part.at(w));
  }
  for (std::size_t c = 0; c < o.trace.crossings.size(); ++c) {
    const overlay_detail::Crossing& crossing = o.trace.crossings[c];
    const ExactPoint a = exact(o.layers.base.at(o.layers.base.from(crossing.base)));
    const ExactPoint b = exact(o.layers.base.at(o.layers.base.to(crossing.base)));
    const ExactPoint p = exact(o.layers.part.at(o.layers.part.from(crossing.part)));
    const ExactPoint q = exact(o.layers.part.at(o.layers.part.to(crossing.part)));
    const Rational ofA = doubleArea(p, q, a);
    const Rational t = ofA / (ofA - doubleArea(p, q, b));
    const ExactPoint at{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    ExactPoint& known = positions[static_cast<std::size_t>(crossing.vertex)];
    if (crossing.vertex < o.numbers.firstCrossing) {
      if (known.x != at.x || known.y != at.y) {
        throw std::runtime_error("a crossing was put at a vertex where it is not");
      }
    }
    known = at;
  }
  return positions;
}

// What a valid combined tile is, decided without rounding: all triangles turn left, they fill the polygon,
// and they form a disk whose border is the seam.
inline void verifyExactly(const Overlaid& o) {
  const CombinedTile& c = o.combined;
  const std::vector<ExactPoint> at = exactPositions(o);
  Rational sum = 0;
  Rational polygon = 0;
  for (const auto& [i, j, k] : c.faces) {
    const Rational area = doubleArea(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)],
                                     at[static_cast<std::size_t>(k)]);
    QVERIFY(area > 0);
    sum += area;
  }
  for (Index k = 1; k + 1 < c.seamSize; ++k) {
    polygon += doubleArea(at[0], at[static_cast<std::size_t>(k)], at[static_cast<std::size_t>(k) + 1]);
  }
  QVERIFY(sum == polygon);
}

inline void verifyDisk(const CombinedTile& c) {
  const TriangleMesh mesh(c.base, c.faces);
  std::size_t border = 0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.twin(h) < 0) {
      ++border;
      QVERIFY(mesh.from(h) < c.seamSize);
      QCOMPARE(mesh.to(h), (mesh.from(h) + 1) % c.seamSize);
    }
  }
  QCOMPARE(border, static_cast<std::size_t>(c.seamSize));
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    QVERIFY(!mesh.singular(v));
  }
  const long edges = (3L * mesh.faceCount() + c.seamSize) / 2;
  QCOMPARE(mesh.vertexCount() - edges + mesh.faceCount(), 1L);
}

inline Point positionOf(const TileLocation& location, const TestTile& tile) {
  const auto corner = [&](std::size_t k) -> Point {
    return tile.points[static_cast<std::size_t>(location.corners[k])];
  };
  Point p = corner(0);
  for (std::size_t k = 1; k < 3; ++k) {
    if (location.corners[k] >= 0) {
      p += location.weights[static_cast<Eigen::Index>(k)] * (corner(k) - corner(0));
    }
  }
  return p;
}

inline double area(const Point& a, const Point& b, const Point& c) {
  return (b - a).cross(c - a).norm() / 2;
}

// Every face lies on the face of the tile that it names, and together they fill the tile's surface.
inline void verifyOnSide(const CombinedTile& c, const TestTile& tile, const TileLocations& locations,
                         const std::vector<Point>& positions, const std::vector<Index>& parents) {
  double diagonal = 0;
  for (const Point& p : tile.points) {
    diagonal = std::max(diagonal, 2 * (p - tile.points[0]).norm());
  }
  double sum = 0;
  for (std::size_t f = 0; f < c.faces.size(); ++f) {
    const Face& parent = tile.embedding.faces[static_cast<std::size_t>(parents[f])];
    std::array<Point, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(c.faces[f][k]);
      corners[k] = positions[v];
      const TileLocation location = locations[v];
      for (const Index corner : location.corners) {
        QVERIFY(corner < 0 || std::find(parent.begin(), parent.end(), corner) != parent.end());
      }
    }
    sum += area(corners[0], corners[1], corners[2]);
  }
  double whole = 0;
  for (const auto& [i, j, k] : tile.embedding.faces) {
    whole += area(tile.points[static_cast<std::size_t>(i)], tile.points[static_cast<std::size_t>(j)],
                  tile.points[static_cast<std::size_t>(k)]);
  }
  QVERIFY(std::abs(sum - whole) < 1e-9 * whole);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const TileLocation location = locations[v];
    QVERIFY(location.weights.minCoeff() >= 0 && location.weights.maxCoeff() <= 1);
    QVERIFY(std::abs(location.weights.sum() - 1) < 1e-15 * 8);
    QVERIFY((positionOf(location, tile) - positions[v]).norm() <= 1e-15 * diagonal);
    if (location.kind == TileLocation::Kind::OnVertex) {
      QCOMPARE(positions[v], tile.points[static_cast<std::size_t>(location.corners[0])]);
    }
  }
}

// Where two faces meet, they meet in one cell.
inline void verifyCellsConnected(const CombinedTile& c) {
  const TriangleMesh mesh(c.base, c.faces);
  std::vector<Index> leader(c.faces.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](Index f) {
    while (leader[static_cast<std::size_t>(f)] != f) {
      f = leader[static_cast<std::size_t>(f)] =
          leader[static_cast<std::size_t>(leader[static_cast<std::size_t>(f)])];
    }
    return f;
  };
  const auto cell = [&](Index f) {
    return std::pair(c.partFaces[static_cast<std::size_t>(f)], c.baseFaces[static_cast<std::size_t>(f)]);
  };
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.twin(h) >= 0 && cell(h / 3) == cell(mesh.twin(h) / 3)) {
      leader[static_cast<std::size_t>(find(h / 3))] = find(mesh.twin(h) / 3);
    }
  }
  std::map<std::pair<Index, Index>, Index> ofCell;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const auto [it, isNew] = ofCell.try_emplace(cell(f), find(f));
    QVERIFY(isNew || it->second == find(f));
  }
}

inline void verifyUV(const CombinedTile& c, Index sides) {
  double sum = 0;
  for (const auto& [i, j, k] : c.faces) {
    const Point2 ij = c.uv[static_cast<std::size_t>(j)] - c.uv[static_cast<std::size_t>(i)];
    const Point2 ik = c.uv[static_cast<std::size_t>(k)] - c.uv[static_cast<std::size_t>(i)];
    sum += (ij.x() * ik.y() - ij.y() * ik.x()) / 2;
  }
  const double polygon = sides * std::sin(2 * std::numbers::pi / sides) / 2;
  QVERIFY(std::abs(sum - polygon) < 1e-12 * polygon);
  for (std::size_t v = 0; v < c.s.size(); ++v) {
    QVERIFY(c.s[v] <= 1);
    QCOMPARE(c.s[v], v < static_cast<std::size_t>(c.seamSize) ? 0 : seamDistance(sides, c.uv[v]));
  }
}

inline void verify(const TestTile& part, const TestTile& base) {
  const Overlaid o = overlaid(part, base);
  verifyExactly(o);
  verifyExactly(overlaidAsTheyAre(part, base));
  verifyDisk(o.combined);
  verifyOnSide(o.combined, part, o.combined.onPart, o.combined.part, o.combined.partFaces);
  verifyOnSide(o.combined, base, o.combined.onBase, o.combined.base, o.combined.baseFaces);
  verifyCellsConnected(o.combined);
  verifyUV(o.combined, part.embedding.sides);
}

}  // namespace graftsman
