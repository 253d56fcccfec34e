#include "core/fusion/difference.h"

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <random>

#include "core/base/parallel.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

constexpr double kNone = 1e-12;

std::shared_ptr<const TriangleMesh> unitCube() {
  std::vector<Point> points;
  for (const double z : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double x : {0.0, 1.0}) {
        points.emplace_back(x, y, z);
      }
    }
  }
  std::vector<Face> faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                             {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return std::make_shared<const TriangleMesh>(std::move(points), std::move(faces));
}

std::shared_ptr<const TriangleMesh> changed(const TriangleMesh& mesh,
                                            const std::function<Point(const Point&)>& change) {
  std::vector<Point> points;
  for (const Point& p : mesh.points()) {
    points.push_back(change(p));
  }
  return std::make_shared<const TriangleMesh>(std::move(points), mesh.faces());
}

// The signed distances of single places: a surface of those, without faces of any use.
std::vector<double> distancesOf(const std::vector<Point>& places,
                                const std::shared_ptr<const TriangleMesh>& from) {
  return differenceOf(TriangleMesh(places, {}), from, {})->distances;
}

}  // namespace

class DifferenceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreadCount(0); }

  void aSurfaceDiffersFromItselfByExactlyNothing() {
    const auto sphere = shapes::icosphere(4);
    const auto same = differenceOf(*sphere, sphere, {});
    QVERIFY(same);
    QCOMPARE(same->distances, std::vector<double>(sphere->points().size(), 0.0));
    QCOMPARE(same->greatest, 0.0);
    QCOMPARE(same->least, 0.0);
    QCOMPARE(same->meanAbsolute, 0.0);
  }

  void aLargerSphereLiesOutsideByTheDifferenceOfTheRadii() {
    const auto sphere = shapes::icosphere(4);
    const auto larger = changed(*sphere, [](const Point& p) -> Point { return 1.25 * p; });
    const auto outside = differenceOf(*larger, sphere, {});
    QVERIFY(outside);
    // Over each vertex that vertex is nearest: the spheres are scaled copies.
    for (const double d : outside->distances) {
      QVERIFY(std::abs(d - 0.25) < kNone);
    }
    QVERIFY(std::abs(outside->meanAbsolute - 0.25) < kNone);
    // Inside, the flat faces of the larger one come a little nearer than its vertices.
    const auto inside = differenceOf(*sphere, larger, {});
    QVERIFY(inside);
    QVERIFY(inside->greatest < -0.24 && inside->least >= -0.25 - kNone);
    QVERIFY(inside->meanAbsolute > 0.24 && inside->meanAbsolute <= 0.25 + kNone);
  }

  void aShiftedPlaneIsAsFarAsItWasShifted() {
    const auto plane = shapes::grid(8);
    const auto above = changed(*plane, [](const Point& p) -> Point { return p + Point(0, 0, 0.5); });
    const auto up = differenceOf(*above, plane, {});
    QVERIFY(up);
    QCOMPARE(up->greatest, 0.5);
    QCOMPARE(up->least, 0.5);
    QCOMPARE(up->meanAbsolute, 0.5);
    const auto down = differenceOf(*plane, above, {});
    QCOMPARE(down->greatest, -0.5);
    QCOMPARE(down->least, -0.5);
    QCOMPARE(down->meanAbsolute, 0.5);
  }

  void roundACubeTheSignIsRightAtFacesEdgesAndCorners() {
    const auto cube = unitCube();
    const auto d = distancesOf({{0.3, 0.6, 1.5},
                                {0.3, 0.6, 0.75},
                                {0.5, 0.5, 0.9},  // over a face's diagonal
                                {0.5, 0.5, 1.1},
                                {-3, -4, 0.5},  // off an edge
                                {2, 0.5, 2},
                                {-2, -3, -6},  // off a corner
                                {2, 3, 3},
                                {0.5, 0.5, 0.5},  // as near to all faces
                                {0, 0.5, 0},      // on it
                                {1, 1, 1}},
                               cube);
    const std::vector<double> known = {0.5, -0.25, -0.1, 0.1, 5, std::sqrt(2.0), 7, 3, -0.5, 0, 0};
    for (std::size_t i = 0; i < known.size(); ++i) {
      QVERIFY2(std::abs(d[i] - known[i]) < kNone, qPrintable(QString("%1: %2").arg(i).arg(d[i])));
    }
  }

  // Round a cube everything is known.
  void ofManyPlacesRoundACubeNoneHasTheWrongSign() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> about(-1, 2);
    std::vector<Point> places;
    places.reserve(20000);
    for (int i = 0; i < 20000; ++i) {
      places.emplace_back(about(random), about(random), about(random));
    }
    const auto d = distancesOf(places, unitCube());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Point out = (places[i] - Point(1, 1, 1)).cwiseMax(-places[i]);
      const double known = out.maxCoeff() <= 0 ? out.maxCoeff() : out.cwiseMax(0).norm();
      QVERIFY(std::abs(d[i] - known) < kNone);
    }
  }

  // A tall, thin spike with a sharp tip beside which one face's own normal looks the wrong way.
  void besideASharpTipTheSignIsThatOfTheTipsPseudonormal() {
    const TriangleMesh spike({{0, 0, 1}, {1, 0, 0}, {-0.1, 0.1, 0}, {-0.1, -0.1, 0}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
    const auto shared = std::make_shared<const TriangleMesh>(spike);
    for (const Point& off : {Point(0, 0, 0.2), Point(-0.1, 0, 0.1), Point(0.05, 0.02, 0.3)}) {
      const double d = distancesOf({Point(0, 0, 1) + off}, shared).front();
      QVERIFY(d > 0 && d <= off.norm() + kNone);
    }
  }

  void theMeanIsWeightedByArea() {
    // A strip of which the wide half lies 1 above the plane and the narrow one in it.
    const auto plane = std::make_shared<const TriangleMesh>(
        std::vector<Point>{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}},
        std::vector<Face>{{0, 1, 2}, {0, 2, 3}});
    const TriangleMesh two({{0, 0, 1}, {3, 0, 1}, {0, 2, 1}, {0, 0, 0}, {1, 0, 0}, {0, 2, 0}},
                           {{0, 1, 2}, {3, 4, 5}});
    const auto difference = differenceOf(two, plane, {});
    QVERIFY(difference);
    QCOMPARE(difference->meanAbsolute, 0.75);  // areas 3 and 1
    QCOMPARE(difference->greatest, 1.0);
    QCOMPARE(difference->least, 0.0);
  }

  void theUsualDistanceIsNotThatOfASpike() {
    const auto plane = shapes::grid(20);
    // A third of the square is raised, one vertex of it far.
    const auto bumpy = changed(*plane, [](const Point& p) -> Point {
      const bool spike = (p - Point(0.15, 0.5, 0)).norm() < 0.01;
      return p + Point(0, 0, spike ? 0.05 : p.x() < 0.34 ? 0.01 : 0);
    });
    const auto difference = differenceOf(*bumpy, plane, {});
    QVERIFY(difference);
    QCOMPARE(difference->greatest, 0.05);
    QCOMPARE(difference->usual, 0.01);
    QCOMPARE(differenceOf(*plane, plane, {})->usual, 0.0);
  }

  void verticesWithoutFacesCountForNothing() {
    const auto plane = shapes::grid(4);
    std::vector<Point> points = plane->points();
    points.emplace_back(0, 0, 100);
    const auto difference = differenceOf(TriangleMesh(points, plane->faces()), plane, {});
    QVERIFY(difference);
    QCOMPARE(difference->greatest, 0.0);
    QVERIFY(difference->distances.back() > 99);
  }

  void anyNumberOfThreadsGivesTheSameBits() {
    const auto torus = shapes::torus(60, 40);
    const auto sphere = shapes::icosphere(5);
    setThreadCount(1);
    const auto one = differenceOf(*sphere, torus, {});
    setThreadCount(4);
    const auto four = differenceOf(*sphere, torus, {});
    QVERIFY(one && four);
    QCOMPARE(four->distances, one->distances);
    QCOMPARE(four->greatest, one->greatest);
    QCOMPARE(four->least, one->least);
    QCOMPARE(four->meanAbsolute, one->meanAbsolute);
    QCOMPARE(four->usual, one->usual);
  }

  void itStopsWhenAsked() {
    const auto sphere = shapes::icosphere(5);
    const Progress stop([](double done) { return done < 0.5; }, std::chrono::seconds(0));
    const auto stopped = differenceOf(*sphere, shapes::torus(60, 40), stop);
    QVERIFY(!stopped);
    QVERIFY(stopped.error().code == ErrorCode::Cancelled);
  }
};

QTEST_MAIN(DifferenceTest)
#include "difference_test.moc"
