#include <QtTest>
#include <numbers>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/measures.h"
#include "core/fusion/verify.h"
#include "core/mesh/nearest_surface.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/surface_distance.h"

using namespace graftsman;

namespace {

FusionResults fused(const std::string& name) {
  return update(samples::load(name), {}, {});
}

FusionResults withCurve(FusionInputs inputs, double f) {
  inputs.fcf = FCF::through({{0, f}, {0.3, f}, {0.6, f}, {1, f}}).value();
  return update(inputs, {}, {});
}

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

}  // namespace

class MeasuresTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreadCount(0); }

  void areaVolumeAndSeamAreThoseOfTheChecks_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"fig4c_cone_sphere", "fig7_letters_bottle", "fig8b_cone_nose", "fig9a_cars"}) {
      QTest::newRow(name) << name;
    }
  }
  void areaVolumeAndSeamAreThoseOfTheChecks() {
    QFETCH(QString, name);
    const FusionResults results = fused(name.toStdString());
    const Measures measures = measure(results);
    const Verification verification = verify(results);
    QVERIFY(near(measures.area, verification.result.area, 1e-12 * verification.result.area));
    QCOMPARE(measures.volume.has_value(), verification.result.closed && verification.result.oriented);
    if (measures.volume) {
      QVERIFY(near(*measures.volume, verification.result.volume, 1e-11 * std::abs(*measures.volume)));
    }
    constexpr double kDegrees = 180 / std::numbers::pi;
    QVERIFY(measures.meanSeamAngle > 0 && measures.greatestSeamAngle <= std::numbers::pi);
    QVERIFY(near(measures.meanSeamAngle * kDegrees, verification.meanSeamAngle, 1e-12));
    QVERIFY(near(measures.greatestSeamAngle * kDegrees, verification.greatestSeamAngle, 1e-12));
    QCOMPARE(measures.vertices, verification.result.vertices);
    QCOMPARE(measures.faces, verification.result.faces);
  }

  // The seam's edges looked up in the whole result's own adjacency.
  void theSeamsAnglesAreThoseOfItsEdges() {
    const FusionResults results = fused("fig9b_bird_plane");
    const TriangleMesh mesh(results.fused->points, results.fused->faces());
    const auto normal = [&](Index h) {
      const Face& face = mesh.face(TriangleMesh::faceOf(h));
      return Eigen::Vector3d(
          (mesh.point(face[1]) - mesh.point(face[0])).cross(mesh.point(face[2]) - mesh.point(face[0])));
    };
    double greatest = 0;
    double sum = 0;
    double lengths = 0;
    for (Index i = 0; i < results.combined->seamSize; ++i) {
      const auto& tile = results.join->tileVertices;
      const Index a = tile[static_cast<std::size_t>(i)];
      const Index b = tile[static_cast<std::size_t>((i + 1) % results.combined->seamSize)];
      const Index h = mesh.halfedgeBetween(a, b);
      QVERIFY(h >= 0 && mesh.twin(h) >= 0);
      const double angle =
          std::acos(std::clamp(normal(h).normalized().dot(normal(mesh.twin(h)).normalized()), -1.0, 1.0));
      const double length = (mesh.point(a) - mesh.point(b)).norm();
      greatest = std::max(greatest, angle);
      sum += angle * length;
      lengths += length;
    }
    const Measures measures = measure(results);
    QVERIFY(near(measures.greatestSeamAngle, greatest, 1e-6));
    QVERIFY(near(measures.meanSeamAngle, sum / lengths, 1e-6));
  }

  void distancesAreThoseOfAnIndependentTree() {
    const FusionResults results = fused("fig8b_cone_nose");
    const TriangleMesh& base = *results.inputs.base;
    const SurfaceDistance distance(base.points(), base.faces());
    double greatest = 0;
    for (const Index v : results.join->tileVertices) {
      greatest = std::max(greatest, distance(results.fused->points[static_cast<std::size_t>(v)]));
    }
    const Measures measures = measure(results);
    QVERIFY(greatest > 0.01 * base.diagonal());
    QVERIFY(near(measures.greatestDistance, greatest, 1e-9 * base.diagonal()));
    QVERIFY(measures.meanDistance > 0 && measures.meanDistance < greatest);
  }

  void aCurveOfZeroLeavesTheBaseWhereItWas() {
    const FusionInputs inputs = samples::load("fig9b_bird_plane");
    const Measures measures = measure(withCurve(inputs, 0));
    QVERIFY(measures.greatestDistance <= 1e-12 * inputs.base->diagonal());
    QCOMPARE(measures.meanDistance, 0.0);
    QVERIFY(measure(withCurve(inputs, 0.5)).meanDistance < measure(withCurve(inputs, 1)).meanDistance);
  }

  void qualitiesAreInOrderAndOfTheTilesTriangles() {
    const FusionResults results = fused("fig4a_cone_sphere");
    const Measures measures = measure(results);
    QVERIFY(measures.worstQuality >= 0 && measures.worstQuality <= measures.lowQuality);
    QVERIFY(measures.lowQuality < measures.meanQuality && measures.meanQuality < 1);
    std::size_t atMost = 0;
    const auto& faces = results.fused->faces();
    for (auto f = static_cast<std::size_t>(results.join->restFaces); f < faces.size(); ++f) {
      const auto p = [&](std::size_t k) {
        return results.fused->points[static_cast<std::size_t>(faces[f][k])];
      };
      const double a = (p(1) - p(2)).norm();
      const double b = (p(2) - p(0)).norm();
      const double c = (p(0) - p(1)).norm();
      const double half = (a + b + c) / 2;
      const double area = std::sqrt(std::max(half * (half - a) * (half - b) * (half - c), 0.0));  // Heron's
      const double ratio = 4 * std::numbers::sqrt3 * area / (a * a + b * b + c * c);
      QVERIFY(ratio >= measures.worstQuality - 1e-6);
      atMost += ratio <= measures.lowQuality + 1e-9 ? 1 : 0;
    }
    const std::size_t tile = results.combined->faces.size();
    QVERIFY(atMost >= tile / 20 && atMost <= tile / 20 + 2);
  }

  void oneAndTwoThreadsGiveTheSameBits() {
    const FusionResults results = fused("fig9b_bird_plane");
    setThreadCount(1);
    const Measures one = measure(results);
    setThreadCount(2);
    QVERIFY(measure(results) == one);
  }

  void itStopsWhenAsked() {
    const FusionResults results = fused("fig4c_cone_sphere");
    const Progress stop([](double) { return false; }, std::chrono::seconds(0));
    const Result<Measures> stopped = measure(results, NearestSurface(results.inputs.base), stop);
    QVERIFY(!stopped);
    QVERIFY(stopped.error().code == ErrorCode::Cancelled);
  }

  void theNearestSurfaceIsFoundFromAnywhere() {
    const auto torus = shapes::torus(24, 16);
    const NearestSurface nearest(torus);
    const SurfaceDistance distance(torus->points(), torus->faces());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-2, 2);
    for (int i = 0; i < 300; ++i) {
      const Point p(coordinate(random), coordinate(random), coordinate(random));
      const double expected = distance(p);
      QVERIFY(near(nearest.distance(p), expected, 1e-12));
      QCOMPARE(nearest.distance(p, expected / 2), expected / 2);
    }
  }

  void facesWithoutAreaAreSurfaceToo() {
    const auto needle = std::make_shared<const TriangleMesh>(
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, std::vector<Face>{{0, 1, 2}});
    QCOMPARE(NearestSurface(needle).distance({1.5, 3, 4}), 5.0);
    QCOMPARE(NearestSurface(needle).distance({-1, 0, 0}), 1.0);
  }
};

QTEST_APPLESS_MAIN(MeasuresTest)
#include "measures_test.moc"
