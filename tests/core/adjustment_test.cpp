#include "core/fusion/adjustment.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/boundary_lines.h"
#include "core/fusion/line_field.h"
#include "core/fusion/rigid_fit.h"

using namespace graftsman;
using Points = std::vector<Point>;

namespace {

constexpr double kPi = std::numbers::pi;

Points randomPoints(std::uint32_t seed, std::size_t count, double size = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-size, size);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(unit(random), unit(random), unit(random));
  }
  return points;
}

Eigen::Matrix3d rotation(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

const Eigen::Matrix3d kTurn = rotation(2.1, {1, -2, 0.5});

Points moved(const Points& points, const Eigen::Matrix3d& linear, const Point& shift) {
  Points result;
  for (const Point& p : points) {
    result.emplace_back(linear * p + shift);
  }
  return result;
}

// A circle of radius 1 in the plane z = 0, bent by `bump` out of it.
Points ring(int count, double bump = 0) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double a = 2 * kPi * i / count;
    points.emplace_back(std::cos(a), std::sin(a), bump * std::sin(2 * a));
  }
  return points;
}

double greatestDifference(const Points& a, const Points& b) {
  double greatest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    greatest = std::max(greatest, (a[i] - b[i]).norm());
  }
  return greatest;
}

Adjustment adjusted(const Points& points, const Points& part, const Points& base,
                    const AdjustmentSettings& settings = {}) {
  return adjust(points, part, base, settings, Progress()).value();
}

Error errorOf(const Points& part, const Points& base, const AdjustmentSettings& settings = {}) {
  const Result<Adjustment> result = adjust(part, part, base, settings, Progress());
  return result ? Error{ErrorCode::Unexpected, "no error"} : result.error();
}

bool isRotation(const Eigen::Matrix3d& r) {
  return (r * r.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14 && r.determinant() > 0.5;
}

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

class AdjustmentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreadCount(0); }

  void aRigidMotionIsRecoveredAndNothingElseHappens() {
    const Points part = randomPoints(1, 7);
    const Points tile = randomPoints(2, 500);
    const Point shift(3, -4, 0.5);
    const Adjustment result = adjusted(tile, part, moved(part, kTurn, shift));
    QCOMPARE(result.report.reached, AdjustmentStep::Rigid);
    QCOMPARE(result.report.iterations, 0);
    QVERIFY(result.report.scale == 1);
    QVERIFY((result.report.transform.rotation - kTurn).norm() < 1e-12);
    QVERIFY((result.report.transform.translation - shift).norm() < 1e-12);
    QVERIFY(result.report.distanceBefore > 1);
    QVERIFY(result.report.distanceAfterRigid < 1e-12);
    QVERIFY(result.report.distanceAfterScale == result.report.distanceAfterRigid);
    QVERIFY(result.report.distanceAfterLineField == result.report.distanceAfterRigid);
    QVERIFY(greatestDifference(result.points, moved(tile, kTurn, shift)) < 1e-12);
  }

  void aSimilarityIsRecoveredWithItsScale() {
    const Points part = randomPoints(3, 6);
    const Points tile = randomPoints(4, 500);
    const Point shift(100, 200, 300);
    const Adjustment result = adjusted(tile, part, moved(part, 2.5 * kTurn, shift));
    QCOMPARE(result.report.reached, AdjustmentStep::Scale);
    QCOMPARE(result.report.iterations, 1);
    QVERIFY(std::abs(result.report.scale - 2.5) < 1e-12);
    QVERIFY(result.report.distanceAfterRigid > 0.1);
    QVERIFY(result.report.distanceAfterScale < 1e-12);
    QVERIFY(greatestDifference(result.points, moved(tile, 2.5 * kTurn, shift)) < 1e-12);
  }

  void loopsOfOneShapeNeedTheRigidStepAlone() {
    // Fig. 4: both boundaries are the same circle with the same CVs.
    const Points cone = moved(ring(8), 0.8 * Eigen::Matrix3d::Identity(), Point(0, 0, 1));
    const Points sphere = moved(ring(8), 0.8 * kTurn, Point(5, 5, 5));
    QCOMPARE(adjusted({}, cone, sphere).report.reached, AdjustmentStep::Rigid);
  }

  void loopsOfOtherShapesReachTheLineFieldAndComeCloser() {
    const Points part = ring(8);
    Points base = ring(8, 0.2);
    base[2] *= 1.3;
    base = moved(base, 1.7 * kTurn, Point(1, 2, 3));
    const AdjustmentReport report = adjusted(part, part, base).report;
    QCOMPARE(report.reached, AdjustmentStep::LineField);
    QCOMPARE(report.iterations, 2);  // the second finds k = 1
    QVERIFY(report.distanceAfterRigid < report.distanceBefore);
    QVERIFY(report.distanceAfterScale < report.distanceAfterRigid);
    QVERIFY(report.distanceAfterLineField < 0.5 * report.distanceAfterScale);
  }

  void theReportedTransformTakesThePointsToWhereStep3Began() {
    const Points part = ring(8);
    const Points base = moved(ring(8, 0.2), 1.7 * kTurn, Point(1, 2, 3));
    const AdjustmentSettings settings = {.lineField = false};
    const Points tile = randomPoints(5, 200);
    const Adjustment result = adjusted(tile, part, base, settings);
    const RigidTransform& t = result.report.transform;
    QVERIFY(greatestDifference(result.points, moved(tile, result.report.scale * t.rotation, t.translation)) <
            1e-13);
    QVERIFY(adjusted(tile, part, base).report.transform.translation == t.translation);
  }

  void theScaleIsTheLeastSquaresOne() {
    const Points part = ring(8);
    const Points base = moved(ring(8, 0.3), 1.7 * kTurn, Point(1, 2, 3));
    const auto energy = [&](double factor) {
      const AdjustmentSettings settings = {.lineField = false};
      const AdjustmentReport report = adjusted({}, part, base, settings).report;
      double sum = 0;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Point image = factor * report.scale * (report.transform.rotation * part[i]) + Point(1, 2, 3);
        sum += (image - base[i]).squaredNorm();
      }
      return sum;
    };
    QVERIFY(energy(1) < energy(1.001));
    QVERIFY(energy(1) < energy(0.999));
  }

  void aMirroredLoopGivesARotationNotAReflection() {
    const Points part = randomPoints(6, 9);
    Points base = part;
    for (Point& p : base) {
      p.x() = -p.x();
    }
    const AdjustmentReport report = adjusted(part, part, base).report;
    QVERIFY(isRotation(report.transform.rotation));
    QVERIFY(report.scale > 0);
  }

  void aPlanarLoopGivesAProperRotation() {
    const Points part = ring(6);
    const Points flipped = moved(part, Eigen::Vector3d(1, -1, 1).asDiagonal(), Point(0, 0, 2));
    for (const Points& base : {moved(part, kTurn, Point(1, 1, 1)), flipped}) {
      const AdjustmentReport report = adjusted(part, part, base).report;
      QVERIFY(isRotation(report.transform.rotation));
      QVERIFY(report.distanceAfterRigid < 1e-14 * 100);
    }
  }

  void collinearCvsTurnAsLittleAsTheyCan() {
    const Points part = {{-1, 0, 0}, {0.5, 0, 0}, {0.5, 0, 0}};
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 2, -0.5), Eigen::Vector3d(1, 0, 0)}) {
      const Eigen::Vector3d to = direction.normalized();
      Points base;
      for (const Point& p : part) {
        base.push_back(Point(3, 3, 3) + p.x() * to);
      }
      const Eigen::Matrix3d found = adjusted(part, part, base).report.transform.rotation;
      const Eigen::Matrix3d expected =
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), to).toRotationMatrix();
      QVERIFY(isRotation(found));
      QVERIFY((found - expected).norm() < 1e-13);
    }
  }

  void collinearCvsTheOtherWayRoundGiveHalfATurn() {
    const Points part = {{-1, 0, 0}, {0.25, 0, 0}, {0.75, 0, 0}};
    const Points base = {{1, 0, 0}, {-0.25, 0, 0}, {-0.75, 0, 0}};
    const Eigen::Matrix3d found = adjusted(part, part, base).report.transform.rotation;
    QVERIFY(isRotation(found));
    QVERIFY((found * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitX()).norm() < 1e-14);
  }

  void theSmallestRotationIsExactForAnyPairOfDirections() {
    const Points directions = randomPoints(8, 40);
    for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
      const Eigen::Vector3d a = directions[i].normalized();
      for (const double share : {0.0, 1e-13, 1e-8, 0.5, 1.0}) {
        const Eigen::Vector3d b = ((1 - share) * -a + share * directions[i + 1]).normalized();
        const Eigen::Matrix3d r = smallestRotation(a, b);
        QVERIFY(isRotation(r));
        QVERIFY((r * a - b).norm() < 3e-15);
      }
      QVERIFY((smallestRotation(a, a) - Eigen::Matrix3d::Identity()).norm() < 1e-15);
    }
  }

  void coincidingCvsAreRefused() {
    const Points same(4, Point(1, 2, 3));
    const Error part = errorOf(same, ring(4));
    QCOMPARE(part.code, ErrorCode::LoopDegenerate);
    QVERIFY(part.side == Side::Part);
    const Error base = errorOf(ring(4), same);
    QCOMPARE(base.code, ErrorCode::LoopDegenerate);
    QVERIFY(base.side == Side::Base);
  }

  void aScaleThatIsNotPositiveIsRefused() {
    const AdjustmentSettings scaleOnly = {.rigid = false};
    QCOMPARE(errorOf(ring(4), moved(ring(4), -Eigen::Matrix3d::Identity(), Point(0, 0, 0)), scaleOnly).code,
             ErrorCode::LoopDegenerate);
    // The CVs of the base run twice round in the time of one: no rotation relates the loops at all.
    const Points twice = {ring(8)[0], ring(8)[2], ring(8)[4], ring(8)[6],
                          ring(8)[0], ring(8)[2], ring(8)[4], ring(8)[6]};
    QCOMPARE(errorOf(ring(8), twice).code, ErrorCode::LoopDegenerate);
  }

  void epsilonIsAFractionOfTheLoopsDiameter() {
    const Points part = moved(ring(8), 1000 * Eigen::Matrix3d::Identity(), Point(0, 0, 0));
    Points base = part;
    for (std::size_t i = 0; i < base.size(); ++i) {
      base[i].z() += i % 2 == 0 ? 10 : -10;  // 0.5 % of the diameter, and no rigid motion helps
    }
    AdjustmentSettings settings;
    settings.epsilon = 0.006;
    const AdjustmentReport within = adjusted({}, part, base, settings).report;
    QCOMPARE(within.reached, AdjustmentStep::Rigid);
    QVERIFY(std::abs(within.loopDiameter - std::hypot(2000, 0)) < 1e-9);
    settings.epsilon = 0.004;
    QCOMPARE(adjusted({}, part, base, settings).report.reached, AdjustmentStep::LineField);
  }

  void stepsCanBeLeftOut() {
    const Points part = ring(8);
    const Points base = moved(ring(8, 0.2), 1.7 * kTurn, Point(1, 2, 3));
    const Points tile = randomPoints(9, 50);

    const Adjustment none = adjusted(tile, part, base, {.rigid = false, .scale = false, .lineField = false});
    QCOMPARE(none.report.reached, AdjustmentStep::None);
    QVERIFY(none.points == tile);
    QVERIFY(none.report.distanceAfterLineField == none.report.distanceBefore);
    QVERIFY(none.report.transform.translation == Point::Zero());

    const Adjustment rigid = adjusted(tile, part, base, {.scale = false, .lineField = false});
    QCOMPARE(rigid.report.reached, AdjustmentStep::Rigid);
    QVERIFY(std::abs((rigid.points[0] - rigid.points[1]).norm() - (tile[0] - tile[1]).norm()) < 1e-13);

    const Adjustment noScale = adjusted(tile, part, base, {.scale = false});
    QCOMPARE(noScale.report.reached, AdjustmentStep::LineField);
    QCOMPARE(noScale.report.iterations, 0);
    QVERIFY(noScale.report.scale == 1);
    QVERIFY(noScale.report.distanceAfterScale == noScale.report.distanceAfterRigid);
  }

  void scaleWithoutRigidGrowsThePartInItsPlace() {
    const Points part = moved(ring(8), Eigen::Matrix3d::Identity(), Point(7, 8, 9));
    const Points base = moved(ring(8), 3 * Eigen::Matrix3d::Identity(), Point(0, 0, 0));
    const Adjustment result = adjusted(part, part, base, {.rigid = false, .lineField = false});
    QVERIFY(std::abs(result.report.scale - 3) < 1e-13);
    QVERIFY(result.report.transform.rotation == Eigen::Matrix3d::Identity());
    QVERIFY(greatestDifference(result.points,
                               moved(ring(8), 3 * Eigen::Matrix3d::Identity(), Point(7, 8, 9))) < 1e-12);
  }

  void nothingMovesWhereTheLoopsLieTogetherAlready() {
    const Points tile = randomPoints(10, 50);
    AdjustmentSettings settings;
    settings.rigid = false;
    const Adjustment result = adjusted(tile, ring(5), ring(5), settings);
    QCOMPARE(result.report.reached, AdjustmentStep::None);
    QVERIFY(result.points == tile);
  }

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

  void theUnitDoesNotMatter() {
    const Points part = ring(8, 0.1);
    const Points base = moved(ring(8, 0.3), 1.7 * kTurn, Point(1, 2, 3));
    const Points tile = randomPoints(17, 300);
    const Points expected = adjusted(tile, part, base).points;
    const auto scaled = [](const Points& points, double unit) {
      return moved(points, unit * Eigen::Matrix3d::Identity(), Point(0, 0, 0));
    };
    for (const double unit : {std::ldexp(1.0, -30), std::ldexp(1.0, 40)}) {
      const Adjustment result = adjusted(scaled(tile, unit), scaled(part, unit), scaled(base, unit));
      QVERIFY(result.points == scaled(expected, unit));
    }
    const Adjustment small = adjusted(scaled(tile, 1e-4), scaled(part, 1e-4), scaled(base, 1e-4));
    QVERIFY(greatestDifference(scaled(small.points, 1e4), expected) < 1e-6);
  }

  void aSmallModelFarFromTheOriginLosesNothing() {
    const Points part = moved(ring(8, 0.1), 1e-4 * Eigen::Matrix3d::Identity(), Point(0, 0, 0));
    const Points base = moved(part, kTurn, Point(100, 200, 300));
    const Points tile = randomPoints(18, 100, 1e-4);
    const Points expected = moved(tile, kTurn, Point(100, 200, 300));
    const Adjustment there = adjusted(tile, part, base);
    QCOMPARE(there.report.reached, AdjustmentStep::Rigid);
    QVERIFY(greatestDifference(there.points, expected) < 3e-13);  // some ulps of 300
    const Adjustment back = adjusted(expected, base, part);
    QVERIFY(greatestDifference(back.points, tile) < 3e-13);
  }

  void theThreadsDoNotChangeTheBits() {
    const Points tile = randomPoints(19, 50000);
    const Points part = ring(8, 0.1);
    const Points base = ring(8, 0.3);
    setThreadCount(1);
    const Points one = adjusted(tile, part, base).points;
    setThreadCount(4);
    QVERIFY(adjusted(tile, part, base).points == one);
  }

  void howThePointsAreDividedDoesNotChangeTheBits() {
    const LineField field(boundaryLines(ring(6), ring(6, 0.3), Eigen::Matrix3d::Identity()), 2, 5);
    Points together = randomPoints(20, 700);
    together[50] =
        Point(1e60, 0, 0);  // single precision cannot hold it: takes another way than its neighbours
    Points alone = together;
    field.move(together);
    for (Point& p : alone) {
      field.move({&p, 1});
    }
    QVERIFY(together == alone);
  }

  void settingsOutOfRangeAreRefused() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double falloff : {0.0, -1.0, nan, infinity}) {
      AdjustmentSettings settings;
      settings.falloff = falloff;
      const Error error = errorOf(ring(4), ring(4), settings);
      QCOMPARE(error.code, ErrorCode::SettingOutOfRange);
      QVERIFY(error.message.find("falloff") != std::string::npos);
    }
    for (const double epsilon : {-1e-9, nan, infinity}) {
      AdjustmentSettings settings;
      settings.epsilon = epsilon;
      const Error error = errorOf(ring(4), ring(4), settings);
      QCOMPARE(error.code, ErrorCode::SettingOutOfRange);
      QVERIFY(error.message.find("epsilon") != std::string::npos);
    }
    AdjustmentSettings settings;
    settings.maxIterations = 0;
    const Error error = errorOf(ring(4), ring(4), settings);
    QCOMPARE(error.code, ErrorCode::SettingOutOfRange);
    QVERIFY(error.message.find("iterations") != std::string::npos);
  }

  void iterationsAreLimited() {
    AdjustmentSettings settings;
    settings.maxIterations = 1;
    QCOMPARE(adjusted({}, ring(8), ring(8, 0.4), settings).report.iterations, 1);
  }

  void aCancelledAdjustmentSaysSo() {
    const Progress cancel([](double) { return false; }, std::chrono::seconds(0));
    const Points tile = randomPoints(21, 100);
    const Result<Adjustment> result = adjust(tile, ring(8), ring(8, 0.4), {}, cancel);
    QCOMPARE(result.error().code, ErrorCode::Cancelled);
  }
};

QTEST_APPLESS_MAIN(AdjustmentTest)
#include "adjustment_test.moc"
