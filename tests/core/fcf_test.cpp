#include "core/fusion/fcf.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <random>

using namespace graftsman;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

FCF curve(std::vector<FCFPoint> points, bool monotone = true) {
  return FCF::through(std::move(points), monotone).value();
}

ErrorCode errorOf(std::vector<FCFPoint> points) {
  const Result<FCF> result = FCF::through(std::move(points));
  return result ? ErrorCode::Unexpected : result.error().code;
}

std::string messageOf(const Result<FCF>& result) {
  return result ? std::string() : result.error().message;
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

double derivative(const FCF& f, double s, double h = 1e-6) {
  return (f(s + h) - f(s - h)) / (2 * h);
}

double secondDerivative(const FCF& f, double s, double h) {
  return (f(s + h) - 2 * f(s) + f(s - h)) / (h * h);
}

// Points with random s and f.
std::vector<FCFPoint> randomPoints(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> s = {0, 1};
  while (s.size() < count) {
    s.push_back(unit(random));
  }
  std::sort(s.begin(), s.end());
  std::vector<FCFPoint> points;
  for (const double value : s) {
    points.push_back({value, unit(random)});
  }
  return points;
}

}  // namespace

class FcfTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theCurveTakesExactlyItsPoints() {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
      const std::vector<FCFPoint> points = randomPoints(random, 4 + static_cast<std::size_t>(i) % 30);
      for (const bool monotone : {false, true}) {
        const FCF f = curve(points, monotone);
        for (const FCFPoint& point : points) {
          QVERIFY(f(point.s) == point.f);
        }
      }
    }
  }

  void theDefaultIsLinear() {
    const FCF f;
    QVERIFY(f == FCF::preset(FCF::Preset::Linear));
    for (int i = 0; i <= 1000; ++i) {
      QVERIFY(std::abs(f(i / 1000.0) - i / 1000.0) < 1e-15);
    }
  }

  void aConstantCurveIsExactlyConstant() {
    for (const double value : {0.0, 0.3, 0.5, 1.0}) {
      for (const bool monotone : {false, true}) {
        const FCF f = curve({{0, value}, {0.17, value}, {0.3, value}, {0.9, value}, {1, value}}, monotone);
        for (int i = 0; i <= 10000; ++i) {
          QVERIFY(f(i / 10000.0) == value);
        }
      }
    }
    QCOMPARE(FCF::preset(FCF::Preset::Half)(0.123), 0.5);
  }

  void thePlainCurveIsTwiceContinuouslyDifferentiableWithStraightEnds() {
    const FCF f = curve({{0, 0.2}, {0.3, 0.5}, {0.55, 0.45}, {0.8, 0.6}, {1, 0.7}}, false);
    const double h = 1e-4;
    for (const double s : {0.3, 0.55, 0.8}) {
      QVERIFY(std::abs(derivative(f, s - h) - derivative(f, s + h)) < 0.01);
      QVERIFY(std::abs(secondDerivative(f, s - 2 * h, h) - secondDerivative(f, s + 2 * h, h)) < 0.1);
    }
    QVERIFY(std::abs(secondDerivative(f, h, h)) < 0.02);
    QVERIFY(std::abs(secondDerivative(f, 1 - h, h)) < 0.02);
  }

  void thePlainCurveReproducesAStraightLineThroughAnyPoints() {
    const FCF f = curve({{0, 0.1}, {0.01, 0.108}, {0.5, 0.5}, {0.9, 0.82}, {1, 0.9}}, false);
    for (int i = 0; i <= 1000; ++i) {
      QVERIFY(std::abs(f(i / 1000.0) - (0.1 + 0.8 * i / 1000.0)) < 1e-14);
    }
  }

  void aMonotoneCurveStaysBetweenItsNeighbours() {
    std::mt19937 random(2);
    for (int i = 0; i < 300; ++i) {
      const std::vector<FCFPoint> points = randomPoints(random, 4 + static_cast<std::size_t>(i) % 12);
      const FCF f = curve(points, true);
      for (std::size_t j = 0; j + 1 < points.size(); ++j) {
        const bool rises = points[j].f <= points[j + 1].f;
        double last = points[j].f;
        for (int k = 1; k <= 100; ++k) {
          const double s = points[j].s + (points[j + 1].s - points[j].s) * k / 100;
          const double value = f(s);
          QVERIFY(rises ? value >= last - 1e-14 : value <= last + 1e-14);
          last = value;
        }
      }
    }
  }

  void limitingLeavesACurveThatIsMonotoneAlreadyAsItIs() {
    const std::vector<FCFPoint> points = {{0, 0}, {0.3, 0.2}, {0.6, 0.5}, {1, 1}};
    const FCF plain = curve(points, false);
    const FCF limited = curve(points, true);
    for (int i = 0; i <= 1000; ++i) {
      QVERIFY(limited(i / 1000.0) == plain(i / 1000.0));
    }
  }

  void aMonotoneCurveHasNoKink() {
    const FCF f = FCF::preset(FCF::Preset::KeepBaseSlope);
    for (const double s : {0.35, 0.65}) {
      const double h = 1e-7;
      QVERIFY(std::abs((f(s + h) - f(s)) / h - (f(s) - f(s - h)) / h) < 1e-3);
    }
  }

  void valuesOutsideAreClamped() {
    const FCF f = curve({{0, 0}, {0.02, 0.9}, {0.08, 1}, {1, 1}}, false);
    double least = 1;
    for (int i = 0; i <= 10000; ++i) {
      const double value = f(i / 10000.0);
      QVERIFY(value >= 0 && value <= 1);
      least = i > 800 ? std::min(least, value) : least;
    }
    QVERIFY(least == 0.0);  // the plain spline would fall to −2.4: why the presets are monotone
  }

  void anyArgumentGivesAValue() {
    const FCF f = curve({{0, 0.25}, {0.3, 0.5}, {0.6, 0.1}, {1, 0.75}});
    QVERIFY(f(-3) == 0.25);
    QVERIFY(f(-0.0) == 0.25);
    QVERIFY(f(7) == 0.75);
    QVERIFY(f(std::numeric_limits<double>::infinity()) == 0.75);
    QVERIFY(f(kNan) == 0.25);
  }

  void pasteIsOneExceptNearTheSeam() {
    const FCF f = FCF::preset(FCF::Preset::Paste);
    QVERIFY(f(0) == 0.0);
    QVERIFY(f(0.01) > 0.4 && f(0.01) < 0.9);
    double last = 0;
    for (int i = 0; i <= 10000; ++i) {
      const double s = i / 10000.0;
      QVERIFY(f(s) >= last);
      QVERIFY(s < 0.08 || f(s) == 1);
      last = f(s);
    }
  }

  void keepBaseSlopeIsFlatAtBothEndsAndRisesOnce() {
    const FCF f = FCF::preset(FCF::Preset::KeepBaseSlope);
    const double h = 1e-7;
    QVERIFY(f(h) / h < 1e-6);
    QVERIFY((1 - f(1 - h)) / h < 1e-6);
    int bends = 0;
    double lastSlope = 0;
    bool steeper = true;
    for (int i = 1; i <= 1000; ++i) {
      const double slope = f(i / 1000.0) - f((i - 1) / 1000.0);
      QVERIFY(slope >= 0);
      if (std::abs(slope - lastSlope) > 1e-12 && (slope > lastSlope) != steeper) {
        steeper = !steeper;
        ++bends;
      }
      lastSlope = slope;
    }
    QCOMPARE(bends, 1);  // one inflection: an S, no waves
    QVERIFY(f(0.5) == 0.5);
  }

  void manyAtOnceGivesTheSameBitsAsOneByOne() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-0.1, 1.1);
    std::vector<double> s(5000);
    for (double& value : s) {
      value = unit(random);
    }
    s[7] = kNan;
    s[8] = 0;
    s[9] = 1;
    std::vector<double> out(s.size());
    for (const std::size_t count : {4U, 5U, 6U, 7U, 8U, 9U, 17U, 1000U}) {
      const FCF f = curve(randomPoints(random, count));
      f.evaluate(s, out);
      for (std::size_t i = 0; i < s.size(); ++i) {
        QVERIFY(out[i] == f(s[i]));
      }
    }
  }

  void crowdedPointsAreFoundRight() {
    std::vector<FCFPoint> points = {{0, 0}};
    for (int i = 0; i < 1000; ++i) {
      points.push_back({0.5 + i * 1e-8, i % 2 == 0 ? 1.0 : 0.0});
    }
    points.push_back({1, 0.5});
    const FCF f = curve(points, false);
    for (const FCFPoint& point : points) {
      QVERIFY(f(point.s) == point.f);
      QVERIFY(std::isfinite(f(point.s + 5e-9)));
    }
  }

  void curvesAreEqualIfPointsAndKindAre() {
    const std::vector<FCFPoint> points = {{0, 0}, {0.3, 0.5}, {0.6, 0.1}, {1, 1}};
    QVERIFY(curve(points, true) == curve(points, true));
    QVERIFY(!(curve(points, true) == curve(points, false)));
    QVERIFY(!(curve(points, true) == FCF()));
  }

  void fewerThanFourPointsAreRefused() {
    QCOMPARE(errorOf({}), ErrorCode::CurveTooShort);
    QCOMPARE(errorOf({{0, 0}, {0.5, 0.5}, {1, 1}}), ErrorCode::CurveTooShort);
  }

  void theEndsMustLieAtZeroAndOne() {
    QCOMPARE(errorOf({{0.1, 0}, {0.3, 0}, {0.5, 0.5}, {1, 1}}), ErrorCode::CurveEndsWrong);
    QCOMPARE(errorOf({{kNan, 0}, {0.3, 0}, {0.5, 0.5}, {1, 1}}), ErrorCode::CurveEndsWrong);
    const Result<FCF> late = FCF::through({{0, 0}, {0.3, 0}, {0.5, 0.5}, {0.99, 1}});
    QCOMPARE(late.error().code, ErrorCode::CurveEndsWrong);
    QVERIFY(contains(late.error().message, "point 3"));
  }

  void everySMustBeGreaterThanTheOneBefore() {
    const Result<FCF> equal = FCF::through({{0, 0}, {0.3, 0}, {0.3, 0.5}, {1, 1}});
    QCOMPARE(equal.error().code, ErrorCode::CurveNotIncreasing);
    QVERIFY(contains(equal.error().message, "point 2"));
    QCOMPARE(errorOf({{0, 0}, {0.6, 0}, {0.3, 0.5}, {1, 1}}), ErrorCode::CurveNotIncreasing);
    QCOMPARE(errorOf({{0, 0}, {0.6, 0}, {0.6 + 1e-12, 0.5}, {1, 1}}), ErrorCode::CurveNotIncreasing);
    QCOMPARE(errorOf({{0, 0}, {kNan, 0}, {0.6, 0.5}, {1, 1}}), ErrorCode::CurveNotIncreasing);
    QCOMPARE(errorOf({{0, 0}, {0.3, 0}, {1, 0.5}, {1, 1}}), ErrorCode::CurveNotIncreasing);
  }

  void everyFMustLieBetweenZeroAndOne() {
    for (const double f : {-0.001, 1.001, kNan, std::numeric_limits<double>::infinity()}) {
      const Result<FCF> result = FCF::through({{0, 0}, {0.3, f}, {0.6, 0.5}, {1, 1}});
      QCOMPARE(result.error().code, ErrorCode::CurveOutOfRange);
      QVERIFY(contains(result.error().message, "point 1"));
    }
  }

  void everyPresetIsFoundByItsName() {
    for (const FCF::Preset preset :
         {FCF::Preset::Linear, FCF::Preset::Paste, FCF::Preset::KeepBaseSlope, FCF::Preset::Half}) {
      QVERIFY(presetNamed(name(preset)) == preset);
      QVERIFY(parseFCF(name(preset)).value() == FCF::preset(preset));
    }
    QVERIFY(!presetNamed("Paste"));
    QVERIFY(!presetNamed(""));
  }

  void aTextOfPointsIsACurve() {
    QVERIFY(parseFCF("0,0;0.25,1e-1; 0.5 , 0.9 ;1,1").value() ==
            curve({{0, 0}, {0.25, 0.1}, {0.5, 0.9}, {1, 1}}));
  }

  void aTextThatIsNoCurveIsRefusedNamingThePoint() {
    for (const char* text : {"0,0;0.25,0.1;0.5,x;1,1", "0,0;0.25,0.1;0.5;1,1", "0,0;0.25,0.1;;1,1",
                             "0,0;0.25,0.1;0.5,0.9,3;1,1", "0,0;0.25,0.1;0.5,0.9abc;1,1", "0,0;1,1;,;1,1"}) {
      const Result<FCF> result = parseFCF(text);
      QVERIFY2(!result && result.error().code == ErrorCode::CurveOutOfRange, text);
      QVERIFY2(contains(messageOf(result), "Point 2"), messageOf(result).c_str());
    }
    QCOMPARE(parseFCF("0,0;0.25,0.1;0.5,0.9;1,1;").error().code, ErrorCode::CurveOutOfRange);
    QCOMPARE(parseFCF("0,0;0.25,0.1;0.5,nan;1,1").error().code, ErrorCode::CurveOutOfRange);
    QCOMPARE(parseFCF("0,0;1,1").error().code, ErrorCode::CurveTooShort);
    QCOMPARE(parseFCF("bump").error().code, ErrorCode::CurveTooShort);
    QCOMPARE(parseFCF("").error().code, ErrorCode::CurveTooShort);
    QCOMPARE(parseFCF("0,0;0.5,0.1;0.25,0.9;1,1").error().code, ErrorCode::CurveNotIncreasing);
    QCOMPARE(parseFCF("0.1,0;0.5,0.1;0.75,0.9;1,1").error().code, ErrorCode::CurveEndsWrong);
  }
};

QTEST_APPLESS_MAIN(FcfTest)
#include "fcf_test.moc"
