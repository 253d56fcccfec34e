#include <Eigen/Geometry>
#include <QtTest>

#include "core/fusion/update.h"
#include "core/fusion/verify.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

void addScenarioRows() {
  QTest::addColumn<QString>("scenario");
  for (const char* name :
       {"fig4a_cone_sphere", "fig7_letters_bottle", "fig8b_cone_nose", "fig9a_cars", "fig9b_bird_plane"}) {
    QTest::newRow(name) << QString(name);
  }
}

// The scenario's base, pasted onto itself along the scenario's loop.
FusionInputs ontoItself(const std::string& scenario) {
  FusionInputs inputs = samples::load(scenario);
  inputs.part = inputs.base;
  for (CVP& cvp : inputs.loop) {
    cvp.part = cvp.base;
  }
  return inputs;
}

std::shared_ptr<const TriangleMesh> moved(const TriangleMesh& mesh, double angle) {
  const Eigen::AngleAxisd turn(angle, Eigen::Vector3d(1, 2, 3).normalized());
  std::vector<Point> points;
  for (const Point& p : mesh.points()) {
    points.emplace_back(turn * p + mesh.diagonal() * Eigen::Vector3d(0.3, -2, 0.7));
  }
  return std::make_shared<const TriangleMesh>(std::move(points), mesh.faces());
}

}  // namespace

class SelfOverlayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aTilePastedOntoItselfIsThatTile_data() { addScenarioRows(); }
  void aTilePastedOntoItselfIsThatTile() {
    QFETCH(QString, scenario);
    const FusionResults results = update(ontoItself(scenario.toStdString()), {}, {});
    QVERIFY2(results.fused, results.error ? results.error->message.c_str() : "");
    const CombinedTile& combined = *results.combined;
    const Embedding& base = *results.base.embedding;
    QCOMPARE(results.fitted->points, results.base.tile->points);
    QCOMPARE(results.part.embedding->uv, base.uv);
    QCOMPARE(combined.uv.size(), base.uv.size());
    QCOMPARE(combined.faces.size(), base.faces.size());
    QCOMPARE(combined.partFaces, combined.baseFaces);
    QCOMPARE(combined.part, combined.base);
    QVERIFY(verify(results).holds());
  }

  // The turn leaves rounding errors in the positions, and so in the embedding.
  void aTilePastedOntoItselfIsThatTileAfterARigidMotion_data() { addScenarioRows(); }
  void aTilePastedOntoItselfIsThatTileAfterARigidMotion() {
    QFETCH(QString, scenario);
    for (const double angle : {0.0, 0.1, 2.5}) {
      FusionInputs inputs = ontoItself(scenario.toStdString());
      inputs.part = moved(*inputs.base, angle);
      const FusionResults results = update(inputs, {}, {});
      QVERIFY2(results.fused, results.error ? results.error->message.c_str() : "");
      const CombinedTile& combined = *results.combined;
      const Embedding& base = *results.base.embedding;
      QCOMPARE(combined.uv, base.uv);
      QCOMPARE(combined.faces.size(), base.faces.size());
      QVERIFY(verify(results).holds());
    }
  }

  // So large that the embedding is solved for by iteration, which ends where it is near enough.
  void aLargeTileTurnedIsThatTile() {
    FusionInputs inputs = ontoItself("fig8b_cone_nose");
    auto [points, faces] = shapes::subdivided(inputs.base->points(), inputs.base->faces());
    inputs.base = std::make_shared<const TriangleMesh>(std::move(points), std::move(faces));
    inputs.part = moved(*inputs.base, 0.1);
    const FusionResults results = update(inputs, {}, {});
    QVERIFY(results.fused);
    QVERIFY(results.base.embedding->uv.size() > 4000);
    QCOMPARE(results.combined->uv.size(), results.base.embedding->uv.size());
    QVERIFY(verify(results).holds());
  }
};

QTEST_APPLESS_MAIN(SelfOverlayTest)
#include "self_overlay_test.moc"
