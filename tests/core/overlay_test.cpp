#include <CGAL/Exact_rational.h>

#include <QtTest>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "core/base/parallel.h"
#include "core/fusion/combined_tile.h"
#include "core/fusion/overlay_cells.h"
#include "core/fusion/overlay_predicates.h"
#include "core/fusion/overlay_vertices.h"
#include "core/fusion/seam_merge.h"
#include "core/fusion/vertex_snap.h"
#include "tests/support/embeddings.h"

using namespace graftsman;
using shapes::TestTile;

namespace {

using Rational = CGAL::Exact_rational;

struct ExactPoint {
  Rational x;
  Rational y;
};

Rational doubleArea(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

ExactPoint exact(const Point2& p) {
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
Overlaid overlaidAsTheyAre(const TestTile& part, const TestTile& base) {
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

Overlaid overlaid(const TestTile& part, const TestTile& base) {
  Overlaid o;
  o.layers = valueOf(overlay_detail::mergeSeams(part.embedding, base.embedding));
  o.trace = valueOf(overlay_detail::snapAndTrace(o.layers, {}));
  o.numbers = overlay_detail::numberVertices(o.layers, o.trace);
  o.combined = valueOf(overlay(part.view(), base.view(), {}));
  return o;
}

/// Each combined vertex's position in rational numbers: the layers' vertices as stored, crossings where the
/// two edges' lines meet, without any shift.
std::vector<ExactPoint> exactPositions(const Overlaid& o) {
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
void verifyExactly(const Overlaid& o) {
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

void verifyDisk(const CombinedTile& c) {
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

Point positionOf(const TileLocation& location, const TestTile& tile) {
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

double area(const Point& a, const Point& b, const Point& c) {
  return (b - a).cross(c - a).norm() / 2;
}

// Every face lies on the face of the tile that it names, and together they fill the tile's surface.
void verifyOnSide(const CombinedTile& c, const TestTile& tile, const TileLocations& locations,
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
void verifyCellsConnected(const CombinedTile& c) {
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

void verifyUV(const CombinedTile& c, Index sides) {
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

void verify(const TestTile& part, const TestTile& base) {
  const Overlaid o = overlaid(part, base);
  verifyExactly(o);
  verifyExactly(overlaidAsTheyAre(part, base));
  verifyDisk(o.combined);
  verifyOnSide(o.combined, part, o.combined.onPart, o.combined.part, o.combined.partFaces);
  verifyOnSide(o.combined, base, o.combined.onBase, o.combined.base, o.combined.baseFaces);
  verifyCellsConnected(o.combined);
  verifyUV(o.combined, part.embedding.sides);
}

/// The square of four corners, 0 to 3, with these interior vertices, from 4 on.
TestTile square(const std::vector<Point2>& interior, std::vector<Face> faces) {
  Embedding embedding;
  embedding.sides = 4;
  for (Index i = 0; i < 4; ++i) {
    embedding.boundary.push_back({i, 0});
    embedding.uv.push_back(boundaryPoint(4, {i, 0}));
  }
  embedding.uv.insert(embedding.uv.end(), interior.begin(), interior.end());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    embedding.parents.push_back(static_cast<Index>(f));
  }
  embedding.faces = std::move(faces);
  return shapes::lifted(std::move(embedding), 1);
}

/// The tile with its interior vertices moved at random by up to `size`.
TestTile shaken(TestTile tile, double size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-size, size);
  for (std::size_t v = tile.embedding.boundary.size(); v < tile.embedding.uv.size(); ++v) {
    tile.embedding.uv[v] += Point2(noise(random), noise(random));
  }
  if (!shapes::isValid(tile.embedding)) {
    throw std::runtime_error("shaken too much");
  }
  return tile;
}

bool sameBits(const CombinedTile& a, const CombinedTile& b) {
  return a.part == b.part && a.base == b.base && a.uv == b.uv && a.s == b.s && a.faces == b.faces &&
         a.partFaces == b.partFaces && a.baseFaces == b.baseFaces;
}

}  // namespace

class OverlayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void randomTilesGiveExactOverlays_data() {
    QTest::addColumn<int>("sides");
    QTest::addColumn<int>("partPerSide");
    QTest::addColumn<int>("partInterior");
    QTest::addColumn<int>("basePerSide");
    QTest::addColumn<int>("baseInterior");
    for (int n = 3; n <= 12; ++n) {
      QTest::addRow("%d-gon", n) << n << 4 << 40 << 7 << 90;
    }
    QTest::newRow("finer part") << 5 << 30 << 900 << 1 << 5;
    QTest::newRow("finer base") << 5 << 1 << 5 << 30 << 900;
    QTest::newRow("equal") << 6 << 12 << 500 << 12 << 500;
    QTest::newRow("no interior vertex but on chords") << 4 << 3 << 0 << 5 << 0;
    QTest::newRow("a lone triangle and others") << 3 << 0 << 0 << 5 << 80;
    QTest::newRow("others and a lone triangle") << 3 << 5 << 80 << 0 << 0;
    QTest::newRow("two lone triangles") << 3 << 0 << 0 << 0 << 0;
    QTest::newRow("thousands on the boundary") << 4 << 300 << 60 << 250 << 60;
  }
  void randomTilesGiveExactOverlays() {
    QFETCH(int, sides);
    QFETCH(int, partPerSide);
    QFETCH(int, partInterior);
    QFETCH(int, basePerSide);
    QFETCH(int, baseInterior);
    for (unsigned seed = 1; seed <= 2; ++seed) {
      verify(shapes::randomTile(2 * seed, sides, partPerSide, partInterior),
             shapes::randomTile(2 * seed + 1, sides, basePerSide, baseInterior));
    }
  }

  void verticesAreThoseOfBothAndTheCrossings() {
    const Overlaid o = overlaid(shapes::randomTile(1, 5, 6, 200), shapes::randomTile(2, 5, 9, 300));
    const auto shared = o.layers.base.seamSize();
    QCOMPARE(static_cast<std::size_t>(o.numbers.count),
             static_cast<std::size_t>(o.layers.part.vertexCount() + o.layers.base.vertexCount() - shared) +
                 o.trace.crossings.size());
  }

  void aTileOverlaidWithItselfIsItself() {
    const TestTile tile = shapes::randomTile(7, 5, 9, 300);
    const Overlaid o = overlaid(tile, tile);
    verifyExactly(o);
    QCOMPARE(o.combined.faces.size(), tile.embedding.faces.size());
    QCOMPARE(o.combined.uv.size(), tile.embedding.uv.size());
    QCOMPARE(o.combined.partFaces, o.combined.baseFaces);
    QCOMPARE(o.combined.part, o.combined.base);
  }

  void nearlyEqualTilesGiveTheTileBack() {
    const TestTile tile = shapes::randomTile(7, 5, 9, 300);
    const Overlaid o = overlaid(shaken(tile, 1e-14), tile);
    verifyExactly(o);
    QCOMPARE(o.combined.uv, tile.embedding.uv);
    QCOMPARE(o.combined.faces.size(), tile.embedding.faces.size());
    QCOMPARE(o.combined.partFaces, o.combined.baseFaces);
  }

  // The part's face w, p, corner 0 is a needle along the line y = 0, to whose other side w would go.
  void aVertexIsNotPutWhereATriangleWouldTurnOver() {
    const double height = 1e-6;
    const Index w = 4;
    const Index p = 5;
    const TestTile part =
        square({{0, height}, {0.5, 0}}, {{w, 0, 1}, {w, 1, 2}, {w, 2, 3}, {w, 3, p}, {w, p, 0}, {p, 3, 0}});
    const TestTile base = square({{0, -height}}, {{w, 0, 1}, {w, 1, 2}, {w, 2, 3}, {w, 3, 0}});
    verify(part, base);
    QCOMPARE(overlaid(part, base).layers.part.at(w), part.embedding.uv[static_cast<std::size_t>(w)]);
    const TestTile other = square({{0, 2 * height}}, base.embedding.faces);
    verify(part, other);
    QCOMPARE(overlaid(part, other).layers.part.at(w), other.embedding.uv[static_cast<std::size_t>(w)]);
  }

  void shakenTilesGiveExactOverlays() {
    const TestTile tile = shapes::randomTile(7, 5, 9, 300);
    for (const double size : {1e-15, 1e-9, 1e-6, 1e-5}) {
      verify(shaken(tile, size), tile);
    }
  }

  void nearlyEqualTilesGiveExactOverlays() {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const TestTile tile = shapes::randomTile(seed, 5, 9, 300);
      verify(tile, shapes::renumbered(tile));
    }
  }

  void squeezedTilesGiveExactOverlays() {
    const TestTile deep = shapes::nestedRings(4, 2, 36);
    double smallest = 1;
    for (const auto& [i, j, k] : deep.embedding.faces) {
      smallest =
          std::min(smallest, overlay_detail::doubleArea(deep.embedding.uv[static_cast<std::size_t>(i)],
                                                        deep.embedding.uv[static_cast<std::size_t>(j)],
                                                        deep.embedding.uv[static_cast<std::size_t>(k)]));
    }
    QVERIFY(smallest < 1e-20);
    verify(deep, shapes::nestedRings(4, 3, 12));
    verify(deep, shapes::nestedRings(4, 2, 36, 3, 0.3));
    verify(deep, shapes::randomTile(3, 4, 5, 200));
    verify(shapes::nestedRings(12, 1, 15), shapes::nestedRings(12, 2, 8));
  }

  void addedVerticesLieOnTheTile() {
    TestTile part = shapes::randomTile(3, 4, 4, 50);
    // The last vertex becomes one that the embedding put into a face of the tile.
    part.points.pop_back();
    part.embedding.added.push_back({{3, 20, 30}, {0.5, 0.25, 0.25}});
    const TestTile base = shapes::randomTile(4, 4, 4, 50);
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    const auto last = static_cast<Index>(part.points.size());
    bool found = false;
    for (std::size_t v = 0; v < combined->part.size(); ++v) {
      const TileLocation& location = combined->onPart[v];
      if (location.kind == TileLocation::Kind::OnVertex && location.corners[0] == last) {
        found = true;
        const Point expected = (2 * part.points[3] + part.points[20] + part.points[30]) / 4;
        QVERIFY((combined->part[v] - expected).norm() < 1e-15);
      }
    }
    QVERIFY(found);
  }

  void smallModelsFarFromTheOriginKeepWhatDoublesAllow() {
    TestTile part = shapes::randomTile(3, 5, 4, 100);
    TestTile base = shapes::randomTile(4, 5, 4, 100);
    const Point offset(100, 200, 300);
    std::vector<Point> exactBase = base.points;
    for (TestTile* tile : {&part, &base}) {
      for (Point& p : tile->points) {
        p = offset + 1e-4 * p;
      }
    }
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    for (std::size_t v = 0; v < combined->base.size(); ++v) {
      const TileLocation& location = combined->onBase[v];
      Point p = Point::Zero();
      for (std::size_t k = 0; k < 3 && location.corners[k] >= 0; ++k) {
        p += location.weights[static_cast<Eigen::Index>(k)] *
             (base.points[static_cast<std::size_t>(location.corners[k])] - offset);
      }
      QVERIFY((combined->base[v] - offset - p).cwiseAbs().maxCoeff() < 6e-14);  // one ulp of 300
    }
  }

  void seamHoldsTheVerticesOfBothBoundaries() {
    const TestTile part = shapes::randomTile(3, 5, 14, 100);
    const TestTile base = shapes::randomTile(4, 5, 9, 100);
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    QCOMPARE(combined->seamSize, 5 + 5 * 14 + 5 * 9);
    for (const bool isPart : {true, false}) {
      const TestTile& tile = isPart ? part : base;
      const auto& seam = isPart ? combined->seamOnPart : combined->seamOnBase;
      const auto& positions = isPart ? combined->part : combined->base;
      QCOMPARE(static_cast<Index>(seam.size()), combined->seamSize);
      Index vertex = 0;
      for (std::size_t k = 0; k < seam.size(); ++k) {
        if (seam[k].t == 0) {
          QCOMPARE(seam[k].edge, vertex++);
          QCOMPARE(positions[k], tile.points[static_cast<std::size_t>(seam[k].edge)]);
        } else {
          QCOMPARE(seam[k].edge, vertex - 1);
          QVERIFY(seam[k].t < 1);
          QVERIFY(seam[k - 1].edge < seam[k].edge || seam[k - 1].t < seam[k].t);
        }
      }
      QCOMPARE(vertex, static_cast<Index>(tile.embedding.boundary.size()));
    }
  }

  void nearBoundaryVerticesAreJoined() {
    const TestTile base = shapes::randomTile(4, 5, 9, 100);
    TestTile part = base;
    std::vector<BoundaryPosition>& boundary = part.embedding.boundary;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      if (boundary[i].t > 0) {
        boundary[i].t += (i % 2 == 0 ? 1e-16 : -1e-6) * boundary[i].t;
        part.embedding.uv[i] = boundaryPoint(5, boundary[i]);
      }
    }
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    QCOMPARE(combined->seamSize, static_cast<Index>(boundary.size()));
    verify(part, base);
  }

  void distinctBoundaryVerticesStayApart() {
    const TestTile base = shapes::randomTile(4, 5, 9, 100);
    TestTile part = base;
    std::vector<BoundaryPosition>& boundary = part.embedding.boundary;
    boundary[4].t += 0.01 * (boundary[5].t - boundary[4].t);
    part.embedding.uv[4] = boundaryPoint(5, boundary[4]);
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(combined.has_value());
    QCOMPARE(combined->seamSize, static_cast<Index>(boundary.size()) + 1);
  }

  void apexesWithinRoundingOfTheBoundaryAreMoved() {
    // The apex of base triangle (0, 1, 3·…) nearly touches side 0, where the part has many vertices.
    TestTile base = shapes::randomTile(4, 4, 0, 1);
    base.embedding.uv[4] = boundaryPoint(4, {0, 0.3}) - Point2(1e-16, 1e-16);
    QVERIFY(shapes::isValid(base.embedding));
    const TestTile part = shapes::randomTile(3, 4, 40, 50);
    const Overlaid o = overlaid(part, base);
    verifyExactly(o);
    verifyDisk(o.combined);
  }

  void boundariesTooFineForDoublesAreAnError() {
    TestTile part = shapes::randomTile(3, 6, 9, 50);
    TestTile base = shapes::randomTile(4, 6, 9, 50);
    // On side 1, whose x runs from 0.5 down: parameters that differ, positions that are rounded to one.
    const double t = 0.01;
    base.embedding.boundary[11].t = t;
    part.embedding.boundary[11].t = std::nextafter(t, 0.0);
    part.embedding.boundary[12].t = std::nextafter(t, 1.0);
    for (TestTile* tile : {&part, &base}) {
      for (const std::size_t i : {11, 12}) {
        tile->embedding.uv[i] = boundaryPoint(6, tile->embedding.boundary[i]);
      }
    }
    const auto combined = overlay(part.view(), base.view(), {});
    QVERIFY(!combined.has_value());
    QCOMPARE(combined.error().code, ErrorCode::CombinedTileTooFine);
    QCOMPARE(combined.error().cvs, (std::vector<int>{1, 2}));
    QVERIFY(combined.error().message.find("CV 1") != std::string::npos);
  }

  void anyProgressCallCanCancel() {
    const TestTile part = shapes::randomTile(3, 5, 14, 3000);
    const TestTile base = shapes::randomTile(4, 5, 9, 3000);
    int calls = 0;
    double last = 0;
    const Progress counting(
        [&](double done) {
          ++calls;
          if (done < last) {
            calls = -1000000;
          }
          last = done;
          return true;
        },
        std::chrono::milliseconds(0));
    QVERIFY(overlay(part.view(), base.view(), counting).has_value());
    QVERIFY(calls > 10);
    for (int k = 0; k < calls; ++k) {
      int call = 0;
      const Progress stopping([&](double) { return call++ < k; }, std::chrono::milliseconds(0));
      const auto combined = overlay(part.view(), base.view(), stopping);
      QVERIFY(!combined.has_value());
      QCOMPARE(combined.error().code, ErrorCode::Cancelled);
      QCOMPARE(call, k + 1);
    }
  }

  void sameBitsOnAnyNumberOfThreads() {
    const TestTile part = shapes::randomTile(3, 5, 14, 12000);
    const TestTile base = shapes::randomTile(4, 5, 9, 12000);
    setThreadCount(1);
    const auto one = overlay(part.view(), base.view(), {});
    setThreadCount(3);
    const auto three = overlay(part.view(), base.view(), {});
    setThreadCount(0);
    QVERIFY(one && three && sameBits(*one, *three));
  }

  void seamDistanceIsZeroAtSidesAndOneAtTheCentre() {
    for (const Index n : {3, 4, 7, 12, 13, 40}) {
      QCOMPARE(seamDistance(n, {0, 0}), 1.0);
      for (Index side = 0; side < n; ++side) {
        for (const double t : {0.0, 0.25, 0.5, 0.9}) {
          const Point2 p = boundaryPoint(n, {side, t});
          QVERIFY(seamDistance(n, p) < 1e-14);
          QVERIFY(std::abs(seamDistance(n, 0.25 * p) - 0.75) < 1e-14);
        }
      }
      QCOMPARE(seamDistance(n, {2, 0}), 0.0);
    }
  }

  void coincidentLinesAndVerticesGiveExactOverlays() {
    for (const Index part : {2, 4, 8, 16}) {
      for (const Index base : {2, 4, 8}) {
        for (const bool flipped : {false, true}) {
          verify(shapes::gridTile(part, flipped), shapes::gridTile(base));
        }
      }
    }
  }
};

QTEST_APPLESS_MAIN(OverlayTest)
#include "overlay_test.moc"
