#include <QtTest>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/io/mesh_file.h"
#include "core/mesh/mesh_check.h"
#include "tests/support/places.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

MeshCheck check(std::vector<Point> points, std::vector<Face> faces) {
  return checkMesh(TriangleMesh(std::move(points), std::move(faces)));
}

std::vector<Point> somePoints(int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(std::cos(i), std::sin(i), 0.1 * i * i);
  }
  return points;
}

// A strip of n quadrilaterals closed to a ring, with a twist if `twisted`.
MeshCheck checkRing(Index n, bool twisted) {
  std::vector<Face> faces;
  for (Index i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const Index a = 2 * i;
    const Index b = a + 1;
    const Index c = !last ? a + 2 : twisted ? 1 : 0;
    const Index d = !last ? a + 3 : twisted ? 0 : 1;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  return check(somePoints(2 * n), faces);
}

}  // namespace

class MeshCheckTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTwelveModelsAreWhatTheirTableSays_data() {
    QTest::addColumn<int>("vertices");
    QTest::addColumn<int>("faces");
    QTest::addColumn<int>("borderLoops");
    QTest::addColumn<int>("components");
    QTest::addColumn<double>("smallestAngle");
    QTest::addColumn<double>("medianAngle");
    QTest::addColumn<bool>("onlyTriangles");
    QTest::newRow("cone.stl") << 434 << 864 << 0 << 1 << 8.13 << 29.0 << true;
    QTest::newRow("sphere.off") << 922 << 1840 << 0 << 1 << 8.77 << 39.8 << true;
    QTest::newRow("hemisphere.stl") << 242 << 480 << 0 << 1 << 14.0 << 34.6 << true;
    QTest::newRow("letters.obj") << 1303 << 2602 << 0 << 1 << 0.179 << 43.7 << false;
    QTest::newRow("bottle.ply") << 3542 << 7080 << 0 << 1 << 5.94 << 36.0 << false;
    QTest::newRow("head.obj") << 14062 << 28068 << 1 << 1 << 2.62 << 36.9 << false;
    QTest::newRow("nefertiti.ply") << 35002 << 70000 << 0 << 1 << 1.22 << 37.2 << true;
    QTest::newRow("beetle.off") << 5107 << 9664 << 11 << 1 << 1.25 << 23.0 << true;
    QTest::newRow("boxcar.off") << 1266 << 2504 << 0 << 7 << 0.476 << 5.62 << true;
    QTest::newRow("penguin.obj") << 3362 << 6720 << 0 << 1 << 9.79 << 36.3 << true;
    QTest::newRow("plane.ply") << 8730 << 17456 << 0 << 1 << 18.8 << 57.6 << true;
    QTest::newRow("spot.obj") << 2930 << 5856 << 0 << 1 << 8.44 << 36.0 << false;
  }

  void theTwelveModelsAreWhatTheirTableSays() {
    QFETCH(int, vertices);
    QFETCH(int, faces);
    QFETCH(int, borderLoops);
    QFETCH(int, components);
    QFETCH(double, smallestAngle);
    QFETCH(double, medianAngle);
    QFETCH(bool, onlyTriangles);
    const std::filesystem::path models = places::samples() / "models";
    const MeshFile file = readMesh(models / QTest::currentDataTag(), {}).value();
    QVERIFY(file.vertexOfFileVertex.empty());
    QCOMPARE(file.report.droppedDegenerate + file.report.droppedDuplicate + file.report.isolated, 0U);
    QCOMPARE(file.report.triangulated == 0, onlyTriangles);
    const MeshCheck c = checkMesh(*file.mesh);
    QCOMPARE(c.vertices, vertices);
    QCOMPARE(c.faces, faces);
    QCOMPARE(c.borderLoops, borderLoops);
    QCOMPARE(c.components, components);
    QCOMPARE(c.eulerCharacteristic, 2L * components - borderLoops);  // none of them has a handle
    QCOMPARE(c.eulerCharacteristic, static_cast<long>(c.vertices) - c.edges + c.faces);
    QCOMPARE(2 * c.edges - c.borderEdges, 3 * c.faces);
    QVERIFY(c.manifold && c.oriented && c.orientable);
    QCOMPARE(c.closed, borderLoops == 0);
    QCOMPARE(c.degenerateFaces, 0U);
    if (c.closed) {
      QVERIFY(c.volume > 0);
    }
    // The table rounds to three digits. Other diagonals of the quadrilaterals may only make angles larger.
    if (onlyTriangles) {
      QVERIFY(std::abs(c.smallestAngle / smallestAngle - 1) < 0.005);
      QVERIFY(std::abs(c.medianSmallestAngle / medianAngle - 1) < 0.005);
    } else {
      QVERIFY(c.smallestAngle > smallestAngle * 0.995);
      QVERIFY(c.medianSmallestAngle > medianAngle * 0.995);
    }
  }

  void aClosedSurfaceIsMeasured() {
    const MeshCheck c = checkMesh(*shapes::icosphere(5));
    QVERIFY(c.closed && c.manifold && c.oriented && c.orientable);
    QCOMPARE(c.eulerCharacteristic, 2L);
    QVERIFY(std::abs(c.area / (4 * std::numbers::pi) - 1) < 2e-3);
    QVERIFY(std::abs(c.volume / (4 * std::numbers::pi / 3) - 1) < 2e-3);
    QVERIFY((c.boxMax - Point::Ones()).norm() < 1e-2);
    QCOMPARE(checkMesh(*shapes::torus(12, 8)).eulerCharacteristic, 0L);
  }

  void aGridHasOneBorderLoopAndRightAngles() {
    const MeshCheck c = checkMesh(*shapes::grid(4));
    QCOMPARE(c.borderLoops, 1);
    QCOMPARE(c.borderEdges, 16);
    QCOMPARE(c.eulerCharacteristic, 1L);
    QVERIFY(!c.closed && c.manifold);
    QCOMPARE(c.smallestAngle, 45.0);
    QCOMPARE(c.medianSmallestAngle, 45.0);
    QCOMPARE(c.area, 1.0);
  }

  void theVolumeDoesNotSufferFarFromTheOrigin() {
    std::vector<Point> points = shapes::icosphere(2)->points();
    const double volume = checkMesh(*shapes::icosphere(2)).volume;
    for (Point& p : points) {
      p = p * 1e-4 + Point(100, 200, 300);
    }
    const MeshCheck c = check(points, shapes::icosphere(2)->faces());
    QVERIFY(std::abs(c.volume / (volume * 1e-12) - 1) < 1e-8);
  }

  void anEdgeOfThreeFacesIsListed() {
    const MeshCheck c = check(somePoints(5), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    QCOMPARE(c.edgesOfManyFacesCount, 1U);
    QCOMPARE(c.edgesOfManyFaces, (std::vector<std::array<Index, 2>>{{0, 1}}));
    QCOMPARE(c.misorientedEdgesCount, 0U);
    QCOMPARE(c.singularVertices, (std::vector<Index>{0, 1}));
    QVERIFY(!c.manifold && !c.oriented && !c.orientable && !c.closed);
    QCOMPARE(c.edges, 7);
    QCOMPARE(c.borderEdges, 6);
    QCOMPARE(c.borderLoops, 3);  // cut apart along the edge, each face has its own
    QCOMPARE(c.eulerCharacteristic, 1L);
    QCOMPARE(c.components, 1);
  }

  void twoFacesThatDisagreeAreMisorientedButOrientable() {
    const MeshCheck c = check(somePoints(4), {{0, 1, 2}, {0, 1, 3}});
    QCOMPARE(c.misorientedEdges, (std::vector<std::array<Index, 2>>{{0, 1}}));
    QCOMPARE(c.misorientedEdgesCount, 1U);
    QCOMPARE(c.edgesOfManyFacesCount, 0U);
    QVERIFY(!c.oriented && c.orientable);
    QCOMPARE(c.borderLoops, 1);
    QCOMPARE(c.edges, 5);
  }

  // How the faces run is one thing, what surface they make another.
  void facesThatDisagreeAreAManifoldAllTheSame() {
    const MeshCheck two = check(somePoints(4), {{0, 1, 2}, {0, 1, 3}});
    QVERIFY(two.manifold);
    QVERIFY(two.singularVertices.empty());
    std::vector<Face> faces = shapes::icosphere(3)->faces();
    for (std::size_t f = 0; f < faces.size(); f += 5) {
      std::swap(faces[f][1], faces[f][2]);
    }
    const MeshCheck sphere = check(shapes::icosphere(3)->points(), faces);
    QVERIFY(sphere.manifold && sphere.closed && sphere.orientable && !sphere.oriented);
    QCOMPARE(sphere.singularVerticesCount, 0U);
    // Two such fans that touch in a vertex are none.
    const MeshCheck bow = check(somePoints(7), {{0, 1, 2}, {0, 1, 3}, {0, 4, 5}, {0, 4, 6}});
    QCOMPARE(bow.singularVertices, (std::vector<Index>{0}));
    QVERIFY(!bow.manifold);
  }

  void aMobiusStripIsNotOrientable() {
    const MeshCheck strip = checkRing(5, true);
    QVERIFY(strip.manifold && !strip.oriented && !strip.orientable);
    QCOMPARE(strip.misorientedEdgesCount, 1U);
    QCOMPARE(strip.borderLoops, 1);
    QCOMPARE(strip.borderEdges, 10);
    QCOMPARE(strip.eulerCharacteristic, 0L);
    const MeshCheck ring = checkRing(5, false);
    QVERIFY(ring.oriented && ring.orientable && ring.manifold);
    QCOMPARE(ring.borderLoops, 2);
    QCOMPARE(ring.eulerCharacteristic, 0L);
  }

  void aBowTieHasOneSingularVertexAndTwoLoops() {
    const MeshCheck c = check(somePoints(5), {{0, 1, 2}, {0, 3, 4}});
    QCOMPARE(c.singularVertices, (std::vector<Index>{0}));
    QVERIFY(!c.manifold && c.oriented && c.orientable);
    QCOMPARE(c.components, 1);
    QCOMPARE(c.borderLoops, 2);
    QCOMPARE(c.borderEdges, 6);
    QCOMPARE(c.eulerCharacteristic, 1L);
  }

  void twoClosedSurfacesThatTouchInAVertexStayClosed() {
    std::vector<Face> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (const Face& f : std::vector<Face>(faces)) {
      const auto moved = [](Index v) { return v == 3 ? v : v + 4; };
      faces.push_back({moved(f[0]), moved(f[1]), moved(f[2])});
    }
    const MeshCheck c = check(somePoints(8), faces);  // vertex 7 of the second would be 3
    QCOMPARE(c.singularVertices, (std::vector<Index>{3}));
    QCOMPARE(c.isolatedVertices, 1U);
    QVERIFY(c.closed && !c.manifold && c.oriented && c.orientable);
    QCOMPARE(c.borderLoops, 0);
    QCOMPARE(c.components, 1);
    QCOMPARE(c.eulerCharacteristic, 3L);
  }

  void isolatedVerticesDoNotCountForTheShape() {
    std::vector<Point> points = somePoints(4);
    points[3] = Point(1e6, 1e6, 1e6);
    const MeshCheck c = check(points, {{0, 1, 2}});
    QCOMPARE(c.isolatedVertices, 1U);
    QCOMPARE(c.vertices, 4);
    QCOMPARE(c.eulerCharacteristic, 1L);
    QCOMPARE(c.components, 1);
    QVERIFY(c.manifold);
    QVERIFY(c.singularVertices.empty());
    QVERIFY(c.boxMax.maxCoeff() < 2);
  }

  void facesWithoutAreaAreFoundExactly() {
    const double third = 1.0 / 3;
    const std::vector<Point> points = {
        {0, 0, 0}, {1, 1, 1}, {third, third, third}, {third, third, std::nextafter(third, 1)}};
    QCOMPARE(check(points, {{0, 1, 2}}).degenerateFaces, 1U);
    QCOMPARE(check(points, {{0, 1, 2}}).smallestAngle, 0.0);
    QCOMPARE(check(points, {{0, 1, 3}}).degenerateFaces, 0U);
    QVERIFY(check(points, {{0, 1, 3}}).smallestAngle > 0);
  }

  // Twice the second coordinate is beyond the doubles, and so is every area.
  void coordinatesAtTheEndOfTheDoublesAreMeasured() {
    const double far = 1e308;
    const MeshCheck c = check({{-far, -far, 0}, {far, -far, 0}, {0, far, 0}, {0, 0, far}},
                              {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
    QCOMPARE(c.degenerateFaces, 0U);
    QVERIFY(c.smallestAngle > 30 && c.smallestAngle < 60);
    QVERIFY(c.medianSmallestAngle > 30 && c.medianSmallestAngle < 60);
    QCOMPARE(c.area, std::numeric_limits<double>::infinity());
    const std::string text = describe(c);
    QVERIFY2(text.find("nan") == std::string::npos, text.c_str());
    QVERIFY2(text.find("area beyond 1.8e308, volume ") != std::string::npos, text.c_str());

    const double near = 1e-200;
    const MeshCheck small = check({{0, 0, 0}, {near, 0, 0}, {0, near, 0}}, {{0, 1, 2}});
    QCOMPARE(small.degenerateFaces, 0U);
    QVERIFY(std::abs(small.smallestAngle - 45) < 1e-9);
  }

  void atMostAHundredDefectsAreListedButAllAreCounted() {
    std::vector<Face> faces;
    for (Index i = 0; i < 150; ++i) {
      faces.push_back({0, 2 * i + 1, 2 * i + 2});
      faces.push_back({2 * i + 301, 2 * i + 1, 2 * i + 2});
      faces.push_back({2 * i + 301, 2 * i + 601, 2 * i + 602});
    }
    const MeshCheck c = check(somePoints(901), faces);
    QCOMPARE(c.misorientedEdgesCount, 150U);
    QCOMPARE(c.misorientedEdges.size(), 100U);
    QCOMPARE(c.singularVerticesCount, 151U);
    QCOMPARE(c.singularVertices.size(), 100U);
    QVERIFY(c.orientable);
  }

  void theTextNamesEveryDefect() {
    const std::string text = describe(check(somePoints(8), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 5, 6}}));
    for (const char* const part : {"vertices 8, edges 10, faces 4\n",
                                   "components 1, border loops 4 with 9 edges, Euler characteristic 1\n",
                                   "manifold: no, oriented: no, orientable: no, closed: no\n",
                                   "edges of three or more faces: 1: 0-1\n", "singular vertices: 3: 0 1 2\n",
                                   "isolated vertices: 1\n"}) {
      QVERIFY2(text.find(part) != std::string::npos, part);
    }
    QVERIFY(text.find("disagree") == std::string::npos);
    QVERIFY(describe(check(somePoints(4), {{0, 1, 2}, {0, 1, 3}})).find("disagree: 1: 0-1\n") !=
            std::string::npos);
    QVERIFY(describe(MeshCheck()).find("vertices 0") == 0);
  }
};

QTEST_APPLESS_MAIN(MeshCheckTest)
#include "mesh_check_test.moc"
