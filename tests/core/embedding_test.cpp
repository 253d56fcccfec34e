#include "core/fusion/embedding.h"

#include <QtTest>
#include <numeric>

#include "core/base/parallel.h"
#include "core/base/predicates.h"
#include "tests/support/embedding_checks.h"
#include "tests/support/embedding_tiles.h"
#include "tests/support/shapes.h"
#include "tests/support/tiles.h"

using namespace graftsman;

namespace {

/// The n-gon itself, with count vertices a side, its interior vertices shifted at random: flat.
DiscTile flatPolygon(Index sides, Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> sizes;
  for (Index i = count; i > 0; --i) {
    sizes.push_back(sides * i);
  }
  return shapes::rings(sizes, sides, [&](double depth, double angle) {
    const double turn = angle * sides / (2 * std::numbers::pi);
    const auto side = static_cast<Index>(turn + 1e-9);
    const Point2 edge = boundaryPoint(sides, {side, std::max(turn - side, 0.0)});
    const double shift = depth > 0 && depth < 1 ? 0.2 / count : 0;
    const auto noise = [&] { return shift * (static_cast<double>(random() % 2001) / 1000 - 1); };
    const double x = (1 - depth) * edge.x() + noise();
    return Point(x, (1 - depth) * edge.y() + noise(), 0);
  });
}

/// The square grid of n×n cells with the boundary first, corners at the square's corners.
DiscTile gridTile(Index n) {
  return shapes::gridDisc(n, n, shapes::grid(n)->points());
}

double worstDistance(const Embedding& e, const std::vector<Point>& flat) {
  double worst = 0;
  for (std::size_t v = 0; v < flat.size(); ++v) {
    worst = std::max(worst, (e.uv[v] - flat[v].head<2>()).norm());
  }
  return worst;
}

/// True if the face's triangle stays counter-clockwise in both parts when its boundary edge, where it has
/// one, is divided anywhere.
bool takesPointsOnItsBoundaryEdge(const DiscTile& tile, const Embedding& e, const Face& face) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Index a = face[k];
    const Index b = face[(k + 1) % 3];
    if (a >= tile.boundarySize || b >= tile.boundarySize) {
      continue;
    }
    const Point2& apex = e.uv[static_cast<std::size_t>(face[(k + 2) % 3])];
    const auto [side, start] = e.boundary[static_cast<std::size_t>(a)];
    const BoundaryPosition& to = e.boundary[static_cast<std::size_t>(b)];
    const double end = to.side == side ? to.t : 1;
    for (int i = 1; i < 1000; ++i) {
      const Point2 p = boundaryPoint(e.sides, {side, start + i / 1000.0 * (end - start)});
      if (orient2d(e.uv[static_cast<std::size_t>(a)], p, apex) != 1 ||
          orient2d(p, e.uv[static_cast<std::size_t>(b)], apex) != 1) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

class EmbeddingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cornersLieOnTheUnitCircle() {
    for (const Index sides : {3, 4, 7, 100}) {
      for (Index i = 0; i < sides; ++i) {
        const Point2 corner = boundaryPoint(sides, {i, 0});
        const Point2 next = boundaryPoint(sides, {(i + 1) % sides, 0});
        const double angle = 2 * std::numbers::pi * i / sides;
        QVERIFY((corner - Point2(std::cos(angle), std::sin(angle))).norm() < 1e-15);
        QVERIFY((boundaryPoint(sides, {i, 0.5}) - (corner + next) / 2).norm() < 1e-15);
      }
    }
  }

  void aHemisphereStaysHarmonicAndWhole() {
    for (const Index sides : {3, 5, 8}) {
      const DiscTile tile = shapes::hemisphere(20, sides);
      const auto e = embedTile(tile);
      VERIFY_EMBEDS(tile, e);
      QCOMPARE(e->weights, EmbeddingWeights::Cotangent);
      QCOMPARE(e->flippedCotangent, 0);
      QVERIFY(e->added.empty());
      QVERIFY(e->faces == tile.faces);
      QVERIFY(e->uv.back().norm() < 0.05);  // the pole
    }
  }

  void boundaryVerticesLieInProportionToLength() {
    DiscTile tile = gridTile(8);
    tile.points[1].x() = 0.2;  // between vertex 0 at 0 and vertex 2 at 0.25
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    for (std::size_t i = 0; i < 8; ++i) {
      QCOMPARE(e->boundary[i].side, 0);
      QVERIFY(std::abs(e->boundary[i].t - tile.points[i].x()) < 1e-15);
    }
    QCOMPARE(e->boundary[8].side, 1);
    QCOMPARE(e->boundary[8].t, 0.0);
  }

  void aGridEmbedsForAnyChoiceOfCorners() {
    DiscTile tile = gridTile(9);
    for (const std::vector<Index>& corners :
         {std::vector<Index>{0, 9, 18, 27}, {0, 1, 2}, {0, 12, 24}, {0, 1, 18}, {0, 5, 6, 7, 8, 30, 35}}) {
      tile.corners = corners;
      const auto e = embedTile(tile);
      VERIFY_EMBEDS(tile, e);
      QVERIFY(partsCoverParents(tile, *e));
    }
  }

  void everyBoundaryVertexMayBeACorner() {
    DiscTile tile = gridTile(6);
    tile.corners.resize(24);
    std::iota(tile.corners.begin(), tile.corners.end(), 0);
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    for (const BoundaryPosition& p : e->boundary) {
      QCOMPARE(p.t, 0.0);
    }
  }

  void aFlatPolygonIsReproduced() {
    const DiscTile tile = flatPolygon(6, 12, 1);  // few enough vertices for a factorisation
    for (const Method method : {Method::Cotangent, Method::MeanValue}) {
      const auto e = embedTile(tile, method);
      VERIFY_EMBEDS(tile, e);
      QVERIFY(worstDistance(*e, tile.points) < 1e-8);
    }
  }

  void aLargeFlatPolygonIsReproducedByTheIteration() {
    const DiscTile tile = flatPolygon(5, 60, 2);
    for (const Method method : {Method::Cotangent, Method::MeanValue}) {
      const auto e = embedTile(tile, method);
      VERIFY_EMBEDS(tile, e);
      QVERIFY2(worstDistance(*e, tile.points) < 1e-4,
               QByteArray::number(worstDistance(*e, tile.points)).constData());
    }
  }

  void chordsAreDividedAtTheirMiddles() {
    // Five boundary vertices, all faces round vertex 0: two chords, an ear at each end.
    DiscTile tile;
    tile.points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 1}, {0, 2, 0}};
    tile.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    tile.boundarySize = 5;
    for (const std::vector<Index>& corners :
         {std::vector<Index>{0, 1, 2}, {0, 1, 4}, {0, 2, 4}, {0, 3, 4}, {0, 1, 2, 3, 4}}) {
      tile.corners = corners;
      const auto e = embedTile(tile);
      VERIFY_EMBEDS(tile, e);
      QCOMPARE(e->added.size(), std::size_t{2});
      QCOMPARE(e->faces.size(), std::size_t{7});
      QVERIFY(partsCoverParents(tile, *e));
      QVERIFY((embeddedPoint(tile, *e, 5) - Point(1, 0.5, 0)).norm() < 1e-15);
      QVERIFY((embeddedPoint(tile, *e, 6) - Point(0.5, 1, 0.5)).norm() < 1e-15);
    }
  }

  void aFaceWithThreeChordsIsDividedInFour() {
    DiscTile tile;
    tile.points = {{0, 0, 0}, {1, -1, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
    tile.faces = {{0, 1, 2}, {2, 3, 4}, {4, 5, 0}, {0, 2, 4}};
    tile.boundarySize = 6;
    tile.corners = {0, 2, 4};
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    QCOMPARE(e->added.size(), std::size_t{3});
    QCOMPARE(e->faces.size(), std::size_t{10});
    QVERIFY(partsCoverParents(tile, *e));
  }

  void aSingleTriangleGetsAVertexInTheMiddle() {
    DiscTile tile;
    tile.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 2}};
    tile.faces = {{0, 1, 2}};
    tile.boundarySize = 3;
    tile.corners = {0, 1, 2};
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    QCOMPARE(e->faces.size(), std::size_t{3});
    QVERIFY((embeddedPoint(tile, *e, 3) - Point(1, 1, 2) / 3).norm() < 1e-15);
    QVERIFY(partsCoverParents(tile, *e));
  }

  void twoTrianglesEmbed() {
    DiscTile tile;
    tile.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
    tile.faces = {{0, 1, 2}, {0, 2, 3}};
    tile.boundarySize = 4;
    for (const std::vector<Index>& corners : {std::vector<Index>{0, 1, 2, 3}, {0, 1, 2}, {0, 2, 3}}) {
      tile.corners = corners;
      const auto e = embedTile(tile);
      VERIFY_EMBEDS(tile, e);
      QCOMPARE(e->added.size(), std::size_t{1});
      QVERIFY(partsCoverParents(tile, *e));
    }
  }

  void boundaryVerticesOnTheSameSpotStayApart() {
    DiscTile tile = shapes::hemisphere(10, 4);
    tile.points[1] = tile.points[0];
    tile.points[2] = tile.points[0];
    tile.points[20] = tile.points[21] + Point(1e-17, 0, 0);
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    for (std::size_t i = 1; i < e->boundary.size(); ++i) {
      QVERIFY((e->uv[i] - e->uv[i - 1]).norm() > 1e-7);
    }
  }

  void aSideWithoutLengthIsDividedEvenly() {
    DiscTile tile = shapes::hemisphere(8, 4);
    std::fill(tile.points.begin(), tile.points.begin() + 13, tile.points[0]);
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    for (std::size_t i = 0; i < 12; ++i) {
      QVERIFY(std::abs(e->boundary[i].t - static_cast<double>(i) / 12) < 1e-14);
    }
  }

  void aTileWithoutExtentEmbeds() {
    DiscTile tile = shapes::hemisphere(8, 5);
    std::fill(tile.points.begin(), tile.points.end(), Point(3, 4, 5));
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
  }

  void trianglesWithoutAreaInsideEmbed() {
    DiscTile tile = shapes::hemisphere(12, 5);
    std::mt19937 random(3);
    const auto point = [&](Index v) -> Point& { return tile.points[static_cast<std::size_t>(v)]; };
    for (int i = 0; i < 60; ++i) {  // interior vertices put onto a neighbour, or onto the edge opposite
      const auto [a, b, c] = tile.faces[random() % tile.faces.size()];
      if (a >= tile.boundarySize) {
        point(a) = i < 40 ? point(b) : Point((point(b) + point(c)) / 2);
      }
    }
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
  }

  void smallestAreaRatioIsTheLeastOverTheFaces() {
    const DiscTile tile = shapes::bumpyDisc(12, 5, 0.2, 7);
    const auto e = embedTile(tile);
    VERIFY_EMBEDS(tile, e);
    double total = 0;
    double least = 1e300;
    for (const Face& f : e->faces) {
      total += embeddedFaceArea(tile, *e, f);
      least = std::min(least, layoutArea(*e, f) / embeddedFaceArea(tile, *e, f));
    }
    const double expected = least * total / regularPolygonArea(5);
    QVERIFY(std::abs(e->smallestAreaRatio / expected - 1) < 1e-9);
  }

  void boundaryTrianglesTakeFurtherPointsOnTheirEdge() {
    DiscTile tile = gridTile(10);
    for (std::size_t i = 0; i < 9; ++i) {
      tile.points[40 + i].y() = 1e-14;  // the second row nearly touches the first
    }
    for (const DiscTile& t : {tile, shapes::hemisphere(30, 3)}) {
      const auto e = embedTile(t);
      VERIFY_EMBEDS(t, e);
      for (const Face& face : e->faces) {
        QVERIFY(takesPointsOnItsBoundaryEdge(t, *e, face));
      }
    }
  }

  void sizeAndPlaceOfTheModelDoNotMatter() {
    const DiscTile tile = shapes::bumpyDisc(20, 4, 0.15, 5);
    const auto expected = embedTile(tile);
    VERIFY_EMBEDS(tile, expected);
    // 1e-4 at (100, 200, 300) leaves ten digits of the shape.
    for (const auto& [scale, offset, tolerance] : {std::tuple(1e-4, Point(100, 200, 300), 1e-5),
                                                   {1e6, Point(0, 0, 0), 1e-11},
                                                   {1e-150, Point(0, 0, 0), 1e-11},
                                                   {1e150, Point(0, 0, 0), 1e-11}}) {
      DiscTile moved = tile;
      for (Point& p : moved.points) {
        p = scale * p + offset;
      }
      const auto e = embedTile(moved);
      VERIFY_EMBEDS(moved, e);
      QVERIFY(e->faces == expected->faces);
      QCOMPARE(e->weights, expected->weights);
      for (std::size_t v = 0; v < e->uv.size(); ++v) {
        QVERIFY((e->uv[v] - expected->uv[v]).norm() < tolerance);
      }
    }
  }

  void theNumberOfThreadsDoesNotMatter() {
    for (const DiscTile& tile : {shapes::bumpyDisc(40, 5, 0.1, 9), shapes::horn(30, 20, 5)}) {
      setThreadCount(1);
      const auto one = embedTile(tile);
      setThreadCount(2);
      const auto two = embedTile(tile);
      setThreadCount(0);
      VERIFY_EMBEDS(tile, one);
      VERIFY_EMBEDS(tile, two);
      QVERIFY(one->uv == two->uv);
    }
  }

  void stopsWhenAskedTo() {
    const DiscTile tile = shapes::horn(12, 40, 5);
    const auto always = std::chrono::seconds(0);
    int calls = 0;
    double last = 0;
    bool isMonotone = true;
    const auto count = [&](double done) {
      isMonotone = isMonotone && done >= last && done <= 1;
      last = done;
      ++calls;
      return true;
    };
    QVERIFY(embedTile(tile, Method::Automatic, Progress(count, always)).has_value());
    QVERIFY(isMonotone);
    QCOMPARE(last, 1.0);
    QVERIFY(calls > 20);
    for (int stop = 1; stop <= calls; stop += std::max(1, calls / 25)) {
      int seen = 0;
      const auto e =
          embedTile(tile, Method::Automatic, Progress([&](double) { return ++seen < stop; }, always));
      QVERIFY(!e);
      QCOMPARE(e.error().code, ErrorCode::Cancelled);
      QCOMPARE(seen, stop);
    }
  }
};

QTEST_APPLESS_MAIN(EmbeddingTest)
#include "embedding_test.moc"
