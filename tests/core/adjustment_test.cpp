#include "core/fusion/adjustment.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/fusion/boundary_lines.h"
#include "core/fusion/line_field.h"
#include "core/fusion/rigid_fit.h"
#include "tests/support/adjustment_loops.h"

using namespace graftsman;

namespace {

const Eigen::Matrix3d kTurn = rotation(2.1, {1, -2, 0.5});

bool isRotation(const Eigen::Matrix3d& r) {
  return (r * r.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14 && r.determinant() > 0.5;
}

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
