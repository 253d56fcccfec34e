#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "core/base/predicates.h"
#include "core/io/triangulate.h"
#include "tests/support/mesh_text.h"

using namespace graftsman;

namespace {

using Polygon = std::vector<Eigen::Vector2d>;

// In the plane z = x / 4 + y / 8 (exact for the small integers used here), or in one that a turn brings it
// to.
Point lifted(const Eigen::Vector2d& p, int turn = 0) {
  const Point q(p.x(), p.y(), p.x() / 4 + p.y() / 8);
  return {q[turn % 3], q[(turn + 1) % 3], q[(turn + 2) % 3]};
}

std::vector<Index> identity(std::size_t n) {
  std::vector<Index> corners(n);
  std::iota(corners.begin(), corners.end(), 0);
  return corners;
}

std::vector<Face> trianglesOf(const Polygon& polygon, int turn = 0) {
  std::vector<Point> points;
  for (const auto& p : polygon) {
    points.push_back(lifted(p, turn));
  }
  std::vector<Face> faces;
  triangulate(identity(points.size()), points, faces);
  return faces;
}

double areaOf(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return twice / 2;
}

// n − 2 triangles, none turned over, that add up to the polygon and have each of its edges once.
void requireTriangulation(const Polygon& polygon, const std::vector<Face>& faces) {
  QCOMPARE(faces.size(), polygon.size() - 2);
  double area = 0;
  std::vector<int> sides(polygon.size(), 0);
  for (const Face& f : faces) {
    Polygon triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.push_back(polygon[static_cast<std::size_t>(f[k])]);
      const auto n = static_cast<Index>(polygon.size());
      sides[static_cast<std::size_t>(f[k])] += (f[k] + 1) % n == f[(k + 1) % 3] ? 1 : 0;
    }
    QVERIFY(orient2d(triangle[0], triangle[1], triangle[2]) > 0);
    area += areaOf(triangle);
  }
  QVERIFY(std::abs(area / areaOf(polygon) - 1) < 1e-9);
  QVERIFY(std::all_of(sides.begin(), sides.end(), [](int count) { return count == 1; }));
}

// A star-shaped polygon about the origin with random radii: mostly concave.
Polygon star(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  Polygon polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 0.2 + static_cast<double>(random() % 1000) / 1000;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

// Two arms that wind round each other: every corner is hidden from most others.
Polygon spiral(std::size_t n) {
  Polygon polygon;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const std::size_t k = i < n ? i : 2 * n - 1 - i;
    const double angle = 0.1 * static_cast<double>(k);
    const double radius = 1 + angle + (i < n ? 1 : 0);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

Polygon rotated(Polygon polygon, std::size_t by) {
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(by), polygon.end());
  return polygon;
}

}  // namespace

class TriangulateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aQuadrilateralIsDividedByTheDiagonalWithTheLargerSmallestAngle() {
    const Polygon kite = {{0, 0}, {3, -1}, {8, 0}, {3, 1}};
    QCOMPARE(trianglesOf(kite), (std::vector<Face>{{0, 1, 3}, {1, 2, 3}}));
    QCOMPARE(trianglesOf(rotated(kite, 1)), (std::vector<Face>{{0, 1, 2}, {0, 2, 3}}));
  }

  void aTieGoesToTheFirstCorner() {
    const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Polygon trapezoid = {{0, 0}, {4, 0}, {3, 1}, {1, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
      for (const Polygon& polygon : {square, trapezoid}) {
        std::vector<Point> points;
        for (const auto& p : rotated(polygon, k)) {
          points.emplace_back(p.x() * 1.1, p.y() * 1.1, 0);  // rounded, so that the tie is not exact
        }
        std::vector<Face> faces;
        triangulate(identity(4), points, faces);
        QCOMPARE(faces, (std::vector<Face>{{0, 1, 2}, {0, 2, 3}}));
      }
    }
  }

  void noTriangleOfAConcaveQuadrilateralIsTurnedOver() {
    const Polygon dart = {{0, 0}, {4, -3}, {1, 0}, {4, 3}};
    for (std::size_t k = 0; k < 4; ++k) {
      for (int turn = 0; turn < 3; ++turn) {
        requireTriangulation(rotated(dart, k), trianglesOf(rotated(dart, k), turn));
      }
    }
  }

  void polygonsOfAnySizeAreCoveredExactly() {
    for (const std::size_t n : {5U, 6U, 7U, 12U, 40U, 99U, 100U, 101U, 300U, 2000U}) {
      for (unsigned seed = 1; seed < 5; ++seed) {
        const Polygon polygon = star(n, seed);
        const std::vector<Face> faces = trianglesOf(polygon, static_cast<int>(seed));
        requireTriangulation(polygon, faces);
        QCOMPARE(trianglesOf(polygon, static_cast<int>(seed)), faces);
      }
    }
    requireTriangulation(spiral(20), trianglesOf(spiral(20)));
    requireTriangulation(spiral(20000), trianglesOf(spiral(20000)));
  }

  void aPolygonFarFromTheOriginIsCovered() {
    Polygon polygon = star(60, 3);
    for (auto& p : polygon) {
      p = p * 1e-4 + Eigen::Vector2d(100, 200);
    }
    const std::vector<Face> faces = trianglesOf(polygon);
    QCOMPARE(faces.size(), 58U);
    for (const Face& f : faces) {
      QVERIFY(orient2d(polygon[static_cast<std::size_t>(f[0])], polygon[static_cast<std::size_t>(f[1])],
                       polygon[static_cast<std::size_t>(f[2])]) > 0);
    }
  }

  void cornersOnOneLineAreNoHindrance() {
    Polygon polygon;
    for (int i = 0; i < 20; ++i) {
      polygon.emplace_back(i, 0);
    }
    polygon.emplace_back(19, 8);
    polygon.emplace_back(0, 8);
    requireTriangulation(polygon, trianglesOf(polygon));
  }

  void aHoleReachedByABridgeIsLeftOpen() {
    // A square with a square hole; the bridge's two ends occur twice.
    const std::vector<Point> points = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0},
                                       {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}};
    const std::vector<Index> corners = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
    std::vector<Face> faces;
    triangulate(corners, points, faces);
    QCOMPARE(faces.size(), 8U);
    double area = 0;
    for (const Face& f : faces) {
      const auto corner = [&](int k) {
        return points[static_cast<std::size_t>(f[static_cast<std::size_t>(k)])];
      };
      const double twice = (corner(1) - corner(0)).cross(corner(2) - corner(0)).z();
      QVERIFY(twice > 0);
      area += twice / 2;
    }
    QCOMPARE(area, 81.0 - 9.0);
  }

  void whatIsNoPolygonGetsTheSameNumberOfTriangles() {
    Polygon crossing = star(150, 1);
    std::swap(crossing[10], crossing[90]);
    for (const Polygon& polygon :
         {Polygon(7, {1, 1}), Polygon{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}},
          Polygon{{0, 0}, {4, 4}, {4, 0}, {0, 4}, {2, 9}}, Polygon{{0, 0}, {1, 1}, {1, 0}, {0, 1}},
          Polygon(4, {1, 1}), Polygon(150, {1, 1}), crossing,
          Polygon{{0, 0}, {1e200, 0}, {1e200, 1e200}, {0, 1e200}, {-1e200, 5}}}) {
      QCOMPARE(trianglesOf(polygon).size(), polygon.size() - 2);
    }
    std::vector<Face> faces;
    triangulate(std::vector<Index>{0, 1}, {{0, 0, 0}, {1, 0, 0}}, faces);
    triangulate(std::vector<Index>{}, {}, faces);
    QVERIFY(faces.empty());
  }
};

QTEST_APPLESS_MAIN(TriangulateTest)
#include "triangulate_test.moc"
