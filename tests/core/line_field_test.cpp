#include "core/fusion/line_field.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>
#include <cmath>

#include "core/base/parallel.h"
#include "core/fusion/adjustment.h"
#include "core/fusion/boundary_lines.h"
#include "core/fusion/rigid_fit.h"
#include "tests/support/adjustment_loops.h"

using namespace graftsman;

namespace {

// Eqs. 4–8 to the letter, with z normalised and d to the segment.
Point literalLineField(const Points& part, const Points& base, double n, const Point& v) {
  const auto mean = [](const Points& points) {
    Point sum = Point::Zero();
    for (const Point& p : points) {
      sum += p;
    }
    return Point(sum / static_cast<double>(points.size()));
  };
  const auto axes = [&](const Points& cvs, std::size_t i) {
    const Eigen::Vector3d y = (cvs[(i + 1) % cvs.size()] - cvs[i]).normalized();
    const Eigen::Vector3d z = (cvs[i] - mean(cvs)).normalized().cross(y).normalized();
    Eigen::Matrix3d matrix;
    matrix << y.cross(z), y, z;
    return matrix;
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::size_t next = (i + 1) % part.size();
    const double l1 = (part[next] - part[i]).norm();
    const double l2 = (base[next] - base[i]).norm();
    const Eigen::Vector3d u = axes(part, i).inverse() * (v - part[i]);
    const Eigen::Vector3d scaled = l2 / l1 * u;
    const Eigen::Vector3d image = axes(base, i) * scaled + base[i];
    const double along = std::clamp(u.y(), 0.0, l1);
    const double d = (u - along * Eigen::Vector3d::UnitY()).norm();
    const double w = std::pow(1 + d / l1, -n);
    sum += w * image;
    weights += w;
  }
  return sum / weights;
}

const AdjustmentSettings kLineFieldOnly = {.rigid = false, .scale = false, .lineField = true};

}  // namespace

class LineFieldTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theLineFieldIsThatOfEquations4To8() {
    const Points part = ring(7, 0.1);
    Points base = moved(ring(7, 0.25), 1.2 * rotation(0.2, {1, 1, 0}), Point(0.1, -0.2, 0.1));
    base[3] += Point(0.1, 0.2, -0.1);
    Points tile = randomPoints(11, 2000, 2);
    tile.insert(tile.end(), part.begin(), part.end());
    tile.push_back((part[0] + part[1]) / 2);
    for (const double n : {1.0, 2.0, 5.0, 8.0, 0.5, 2.7, 9.0, 40.0}) {
      AdjustmentSettings settings = kLineFieldOnly;
      settings.falloff = n;
      const Points result = adjusted(tile, part, base, settings).points;
      const bool inSingle = n <= 8 && n == std::floor(n);
      double greatest = 0;
      double displacement = 0;
      for (std::size_t i = 0; i < tile.size(); ++i) {
        const Point expected = literalLineField(part, base, n, tile[i]);
        greatest = std::max(greatest, (result[i] - expected).norm());
        displacement = std::max(displacement, (expected - tile[i]).norm());
      }
      QVERIFY2(greatest < (inSingle ? 1e-6 * displacement : 1e-12),
               qPrintable(QString("n = %1: %2").arg(n).arg(greatest)));
    }
  }

  // Neighbouring CVs a thousandth of the loop apart: what is left of a coordinate's digits decides there.
  void theLineFieldIsAsExactBesideAShortLine() {
    Points part = ring(7, 0.1);
    part.insert(part.begin() + 3, part[3] + Point(1e-3, -1e-3, 5e-4));
    Points base = ring(7, 0.25);
    base.insert(base.begin() + 3, base[3] + Point(-8e-4, 1e-3, 1e-3));
    Points tile = randomPoints(22, 500, 2);
    for (const Point& p : randomPoints(23, 500, 4e-3)) {
      tile.push_back(part[3] + p);
    }
    const Points result = adjusted(tile, part, base, kLineFieldOnly).points;
    for (std::size_t i = 0; i < tile.size(); ++i) {
      double greatest = 0;
      for (const BoundaryLine& line : boundaryLines(part, base, Eigen::Matrix3d::Identity())) {
        const Point image = line.linear * (tile[i] - line.origin) + line.image;
        greatest = std::max(greatest, (image - tile[i]).norm());
      }
      QVERIFY((result[i] - literalLineField(part, base, 5, tile[i])).norm() < 1e-6 * greatest);
    }
  }

  void theLineFieldOfEqualLoopsMovesNothing() {
    const Points part = ring(7, 0.2);
    const Points tile = randomPoints(12, 500, 3);
    const LineField field(boundaryLines(part, part, Eigen::Matrix3d::Identity()), 2, 5);
    Points result = tile;
    field.move(result);
    QVERIFY(greatestDifference(result, tile) < 1e-15);
  }

  void theLineFieldCarriesASimilarityOn() {
    const Points part = ring(7, 0.2);
    const Eigen::Matrix3d linear = 1.5 * rotation(0.7, {1, 2, 3});
    const Points base = moved(part, linear, Point(0.3, 0.2, 0.1));
    const Points tile = randomPoints(13, 500, 3);
    const Points expected = moved(tile, linear, Point(0.3, 0.2, 0.1));
    QVERIFY(greatestDifference(adjusted(tile, part, base, kLineFieldOnly).points, expected) < 2e-6);
  }

  void aGreaterFalloffBringsTheCvsCloserToTheirPartners() {
    const Points part = ring(8);
    Points base = ring(8, 0.2);
    double last = 1e300;
    for (const double n : {1.0, 3.0, 5.0, 7.5, 20.0}) {
      AdjustmentSettings settings;
      settings.falloff = n;
      const double distance = adjusted({}, part, base, settings).report.distanceAfterLineField;
      QVERIFY(distance < last);
      last = distance;
    }
  }

  void pointsFarFromTheLoopStayFinite() {
    const Points part = ring(6);
    const Points base = ring(6, 0.3);
    const Points far = {{1e6, 0, 0}, {0, -1e12, 1e12}, {1e20, 1e20, 1e20}, {1e120, 0, 0}};
    for (const double n : {1.0, 5.0, 8.0, 4.5, 300.0}) {
      AdjustmentSettings settings;
      settings.falloff = n;
      for (const Point& p : adjusted(far, part, base, settings).points) {
        QVERIFY(p.allFinite());
      }
    }
  }

  void aLineThroughTheCentroidHasAFrameAllTheSame() {
    // CVs 0 and 1 lie on a line through the centroid of both loops.
    const Points part = {{-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, -2, 0}, {-1, 1, 0}};
    QVERIFY(centroid(part).norm() < 1e-15);
    const Points base = moved(part, Eigen::Matrix3d::Identity(), Point(0, 0, 0));
    for (const BoundaryLine& line : boundaryLines(part, base, Eigen::Matrix3d::Identity())) {
      QVERIFY((line.linear - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    }
    Points bent = part;
    bent[2].z() = 0.2;
    const Points tile = randomPoints(14, 300);
    const Adjustment result = adjusted(tile, part, bent);
    QVERIFY(greatestDifference(result.points, tile) < 0.5);
  }

  void aCvDraggedPastTheCentroidsLineDoesNotMakeTheFieldJump() {
    Points base = {{-1, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, -2, 0}, {-1, 1, -0.1}};
    const Points part = ring(5);
    const Points tile = randomPoints(15, 100);
    Points last;
    for (int i = -100; i <= 100; ++i) {
      base[0].y() = 0.002 * i;
      base[1].y() = 0.002 * i;
      AdjustmentSettings settings;
      settings.epsilon = 0;
      const Points now = adjusted(tile, part, base, settings).points;
      QVERIFY(last.empty() || greatestDifference(now, last) < 0.05);
      last = now;
    }
  }

  void aConcaveCornerOnOneMeshDoesNotTurnItsSurroundings() {
    // An L whose inner corner lies beyond the centroid on the base only.
    Points part = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1.9, 1.2, 0}, {1, 4, 0}, {0, 4, 0}};
    Points base = part;
    base[3] = Point(0.7, 0.7, 0);
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    for (const BoundaryLine& line : boundaryLines(part, base, one)) {
      const Eigen::Vector3d up = line.linear * Eigen::Vector3d::UnitZ();
      QVERIFY(up.normalized().z() > 0.999);
    }
    const Adjustment result = adjusted({{2, 0.5, 0.3}}, part, base);
    QVERIFY(result.points[0].z() > 0.2);
  }

  void neighbouringCvsOfOnePositionAreNoLine() {
    Points part = ring(6);
    part[1] = part[0];
    Points base = ring(6, 0.1);
    QCOMPARE(boundaryLines(part, base, Eigen::Matrix3d::Identity()).size(), std::size_t{5});
    base[4] = base[3];
    QCOMPARE(boundaryLines(part, base, Eigen::Matrix3d::Identity()).size(), std::size_t{4});
    for (const Point& p : adjusted(randomPoints(16, 100), part, base).points) {
      QVERIFY(p.allFinite());
    }
  }

  void aLoopWithoutAnyLineIsRefused() {
    const Points part = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    const Points base = {{0, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 0}};
    const AdjustmentSettings settings = {.scale = false};
    QCOMPARE(errorOf(part, base, settings).code, ErrorCode::LoopDegenerate);
  }

  void collinearLoopsDeformWithoutATwist() {
    const Points part = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
    const Points base = {{0, 0, 0}, {1.5, 0, 0}, {3, 0, 0}};
    const Points tile = {{1, 1, 0}, {1, 0, 1}};
    const Points result = adjusted(tile, part, base).points;
    QVERIFY(std::abs(result[0].z()) < 1e-6 && result[0].y() > 0.5);
    QVERIFY(std::abs(result[1].y()) < 1e-6 && result[1].z() > 0.5);
  }
};

QTEST_APPLESS_MAIN(LineFieldTest)
#include "line_field_test.moc"
