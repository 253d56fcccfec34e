#include <QtTest>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

#include "core/base/predicates.h"
#include "core/mesh/polygon_triangulation.h"

using namespace graftsman;

namespace {

/// A polygon along the perimeter of the triangle (0,0), (4,0), (0,4).
struct Polygon {
  std::vector<Index> ids;
  std::vector<Point> points;
  std::vector<std::uint8_t> sides;

  void add(int side, double t) {
    static const std::array<Point, 3> kCorners = {Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)};
    const auto a = static_cast<std::size_t>(side);
    ids.push_back(100 + static_cast<Index>(ids.size()));
    points.emplace_back(kCorners[a] + t * (kCorners[(a + 1) % 3] - kCorners[a]));
    sides.push_back(static_cast<std::uint8_t>(t == 0 ? 1 << a | 1 << (a + 2) % 3 : 1 << a));
  }
  [[nodiscard]] std::size_t at(Index id) const { return static_cast<std::size_t>(id - 100); }
};

Eigen::Vector2d flat(const Point& p) {
  return p.head<2>();
}

bool allOnOneSide(const Polygon& polygon) {
  return std::accumulate(polygon.sides.begin(), polygon.sides.end(), 7, std::bit_and<>()) != 0;
}

/// Every edge of the polygon is there once, every other edge twice, in opposite directions.
bool fillsPolygon(const Polygon& polygon, const std::vector<Face>& faces) {
  std::vector<std::pair<Index, Index>> edges;
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.emplace_back(f[k], f[(k + 1) % 3]);
    }
  }
  const std::size_t n = polygon.ids.size();
  for (std::size_t k = 0; k < n; ++k) {
    edges.emplace_back(polygon.ids[(k + 1) % n], polygon.ids[k]);
  }
  std::sort(edges.begin(), edges.end());
  const bool unique = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  return unique && faces.size() == n - 2 && std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
           return std::binary_search(edges.begin(), edges.end(), std::pair(e.second, e.first));
         });
}

bool hasFaceOnOneSide(const Polygon& polygon, const std::vector<Face>& faces) {
  return std::any_of(faces.begin(), faces.end(), [&](const Face& f) {
    return (polygon.sides[polygon.at(f[0])] & polygon.sides[polygon.at(f[1])] &
            polygon.sides[polygon.at(f[2])]) != 0;
  });
}

/// Some corners and some points of the perimeter: as chords would cut it off.
Polygon randomPolygon(std::mt19937& random, int most) {
  Polygon polygon;
  for (int side = 0; side < 3; ++side) {
    if (random() % 3 != 0) {
      polygon.add(side, 0);
    }
    const int points = random() % 4 == 0 ? 0 : static_cast<int>(random() % static_cast<unsigned>(most));
    for (int i = 1; i <= points; ++i) {
      polygon.add(side, i / (points + 1.0));
    }
  }
  return polygon;
}

/// `count` polygons that fulfil the precondition.
std::vector<Polygon> randomPolygons(unsigned seed, std::size_t count, int most) {
  std::mt19937 random(seed);
  std::vector<Polygon> polygons;
  while (polygons.size() < count) {
    Polygon polygon = randomPolygon(random, most);
    if (polygon.ids.size() >= 3 && !allOnOneSide(polygon)) {
      polygons.push_back(std::move(polygon));
    }
  }
  return polygons;
}

std::vector<Face> triangulate(const Polygon& polygon) {
  std::vector<Face> faces;
  triangulatePolygon(polygon.ids, polygon.points, polygon.sides, faces);
  return faces;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double smallestAngle(const Polygon& polygon, const std::vector<Face>& faces) {
  double smallest = 180;
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d p = flat(polygon.points[polygon.at(f[k])]);
      const Eigen::Vector2d a = flat(polygon.points[polygon.at(f[(k + 1) % 3])]) - p;
      const Eigen::Vector2d b = flat(polygon.points[polygon.at(f[(k + 2) % 3])]) - p;
      smallest = std::min(smallest, std::atan2(cross(a, b), a.dot(b)) * 180 / std::numbers::pi);
    }
  }
  return smallest;
}

}  // namespace

class PolygonTriangulationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aTriangleStaysAsItIs() {
    Polygon polygon;
    polygon.add(0, 0.5);
    polygon.add(1, 0.5);
    polygon.add(2, 0.5);
    QCOMPARE(triangulate(polygon), std::vector<Face>({{100, 101, 102}}));
  }

  void aQuadrilateralGetsTheBetterDiagonal() {
    Polygon polygon;  // the corner at the origin is cut off
    polygon.add(0, 0.1);
    polygon.add(1, 0);
    polygon.add(2, 0);
    polygon.add(2, 0.5);
    QCOMPARE(triangulate(polygon), std::vector<Face>({{100, 101, 103}, {101, 102, 103}}));
  }

  void aPointOnASideOfATriangleIsJoinedToTheOppositeCorner() {
    for (const double t : {1e-12, 0.5, 1 - 1e-12}) {
      Polygon polygon;
      polygon.add(0, 0);
      polygon.add(0, t);
      polygon.add(1, 0);
      polygon.add(2, 0);
      QCOMPARE(triangulate(polygon), std::vector<Face>({{100, 101, 103}, {101, 102, 103}}));
    }
  }

  void anApexOverManyPointsOfOneSideBecomesAFan() {
    Polygon polygon;
    constexpr int kPoints = 20000;
    for (int i = 0; i < kPoints; ++i) {
      polygon.add(0, static_cast<double>(i) / kPoints);
    }
    polygon.add(1, 0);
    polygon.add(2, 0);
    const std::vector<Face> faces = triangulate(polygon);
    QVERIFY(fillsPolygon(polygon, faces));
    const Index apex = polygon.ids.back();
    for (const Face& f : faces) {
      QVERIFY(std::find(f.begin(), f.end(), apex) != f.end());
    }
  }

  void noTriangleLiesOnOneSideAndAllAreCounterClockwise() {
    std::vector<Polygon> polygons = randomPolygons(1, 3000, 5);
    std::ranges::copy(randomPolygons(2, 300, 60), std::back_inserter(polygons));
    for (const Polygon& polygon : polygons) {
      const std::vector<Face> faces = triangulate(polygon);
      QVERIFY(fillsPolygon(polygon, faces));
      QVERIFY(!hasFaceOnOneSide(polygon, faces));
      double area = 0;
      for (const Face& f : faces) {
        const Eigen::Vector2d a = flat(polygon.points[polygon.at(f[0])]);
        const Eigen::Vector2d b = flat(polygon.points[polygon.at(f[1])]);
        const Eigen::Vector2d c = flat(polygon.points[polygon.at(f[2])]);
        QVERIFY(orient2d(a, b, c) > 0);
        area += cross(b - a, c - a);
      }
      for (std::size_t k = 0; k < polygon.ids.size(); ++k) {
        area -= cross(flat(polygon.points[k]), flat(polygon.points[(k + 1) % polygon.ids.size()]));
      }
      QVERIFY(std::abs(area) < 1e-12);
    }
  }

  void validityDoesNotDependOnPositions() {
    std::mt19937 random(3);
    for (Polygon& polygon : randomPolygons(4, 2000, 7)) {
      const bool same = random() % 2 == 0;
      for (Point& p : polygon.points) {
        p = same ? Point(1, 2, 3) : Point(random() % 7, random() % 7, random() % 7);
      }
      const std::vector<Face> faces = triangulate(polygon);
      QVERIFY(fillsPolygon(polygon, faces));
      QVERIFY(!hasFaceOnOneSide(polygon, faces));
    }
  }

  void twoSidesOfManyPointsAreJoinedByGoodTriangles() {
    Polygon polygon;
    for (int i = 30; i < 60; ++i) {
      polygon.add(0, i / 60.0);
    }
    for (int i = 0; i <= 30; ++i) {
      polygon.add(1, i / 60.0);
    }
    const std::vector<Face> faces = triangulate(polygon);
    QVERIFY(fillsPolygon(polygon, faces));
    QVERIFY(smallestAngle(polygon, faces) > 0.5);
  }

  void theChoiceDoesNotDependOnTheUnit() {
    for (const Polygon& polygon : randomPolygons(5, 50, 9)) {
      const std::vector<Face> faces = triangulate(polygon);
      for (const double scale : {0x1p-200, 0x1p200}) {
        Polygon scaled = polygon;
        for (Point& p : scaled.points) {
          p *= scale;
        }
        QCOMPARE(triangulate(scaled), faces);
      }
    }
  }
};

QTEST_APPLESS_MAIN(PolygonTriangulationTest)
#include "polygon_triangulation_test.moc"
