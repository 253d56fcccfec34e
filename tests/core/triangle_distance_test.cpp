#include "core/mesh/triangle_distance.h"

#include <Eigen/Geometry>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace graftsman;

namespace {

const Point kA(0, 0, 0);
const Point kB(4, 0, 0);
const Point kC(0, 3, 0);

double segmentDistance(const Point& p, const Point& a, const Point& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

}  // namespace

class TriangleDistanceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aboveTheInsideItIsTheHeight() {
    QCOMPARE(distanceToTriangle({1, 1, 2}, kA, kB, kC), 2.0);
    QCOMPARE(distanceToTriangle({1, 1, -2}, kA, kB, kC), 2.0);
    QVERIFY(distanceToTriangle({1, 1, 0}, kA, kB, kC) < 4e-15);  // some ulps of 4
  }

  void besideAnEdgeOrACornerItIsTheDistanceFromThat() {
    QCOMPARE(distanceToTriangle({2, -3, 0}, kA, kB, kC), 3.0);
    QCOMPARE(distanceToTriangle({2, -3, 4}, kA, kB, kC), 5.0);
    QCOMPARE(distanceToTriangle({7, -4, 0}, kA, kB, kC), 5.0);
    QCOMPARE(distanceToTriangle({2 + 3, 1.5 + 4, 0}, kA, kB, kC), 5.0);  // off the middle of the long edge
  }

  void aTriangleWithoutAreaIsItsLongestEdge() {
    QCOMPARE(distanceToTriangle({1, 2, 0}, kA, kB, Point(2, 0, 0)), 2.0);
    QCOMPARE(distanceToTriangle({-3, 4, 0}, kA, kA, kA), 5.0);
  }

  // Points of needles of any direction, as a person's mesh has them, computed in doubles.
  void pointsOfNeedlesLieOnThem() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto anywhere = [&] { return Point(unit(random), unit(random), unit(random)); };
    for (int i = 0; i < 20000; ++i) {
      const Point a = anywhere();
      const Point b = anywhere();
      const double thin = std::pow(10, -16 * unit(random));
      const Point c = a + unit(random) * (b - a) + thin * (anywhere() - a);
      double u = unit(random);
      double v = unit(random);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const Point p = a + u * (b - a) + v * (c - a);
      const QByteArray what = QString("%1, thin %2").arg(i).arg(thin).toUtf8();
      QVERIFY2(distanceToTriangle(p, a, b, c) < 1e-15, what);
      const Point above = p + (b - a).cross(anywhere()).normalized();
      QVERIFY2(distanceToTriangle(above, a, b, c) > segmentDistance(above, a, b) - 2 * thin - 1e-15, what);
    }
  }
};

QTEST_APPLESS_MAIN(TriangleDistanceTest)
#include "triangle_distance_test.moc"
