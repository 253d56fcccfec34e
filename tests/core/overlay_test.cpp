#include <QtTest>
#include <algorithm>

#include "core/base/parallel.h"
#include "core/fusion/combined_tile.h"
#include "core/fusion/overlay_cells.h"
#include "core/fusion/overlay_predicates.h"
#include "core/fusion/overlay_vertices.h"
#include "core/fusion/seam_merge.h"
#include "core/fusion/vertex_snap.h"
#include "tests/support/embeddings.h"
#include "tests/support/overlay_checks.h"

using namespace graftsman;

namespace {

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
