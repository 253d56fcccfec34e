#include <QtTest>

#include "core/fusion/path_position.h"
#include "core/mesh/mesh_check.h"
#include "tests/support/stacked.h"

using namespace graftsman;

namespace {

Document withCurve(const Document& document, FusionId id, FCF::Preset preset) {
  Fusion fusion = *find(document.fusions, id);
  fusion.inputs.fcf = FCF::preset(preset);
  return edits::withFusion(document, fusion);
}

}  // namespace

class EvaluateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aFusionOfMeshesIsWhatUpdateGives() {
    const Fusion fusion = samples::fusion("fig8b_cone_nose");
    Evaluated known;
    const Evaluation evaluation = evaluate(samples::documentOf(fusion).fusions, 1, known, {});
    QVERIFY(evaluation.results.fused->points == update(fusion.inputs, {}, {}).fused->points);
    QVERIFY(evaluation.assets.empty());
  }

  void aFusionOfAResultHasBothParts() {
    const Document document = samples::twoConesOnASphere();
    Evaluated known;
    const Evaluation evaluation = evaluate(document.fusions, 2, known, {});
    QVERIFY(!evaluation.results.error);
    const auto& first = known.fusions.at(1).results;
    const auto& second = evaluation.results;
    QVERIFY(second.inputs.base->points() == first.fused->points);
    const TriangleMesh mesh(second.fused->points, second.fused->faces());
    const MeshCheck check = checkMesh(mesh);
    QVERIFY(check.closed && check.manifold && check.oriented);
    QCOMPARE(check.eulerCharacteristic, 2);
    // The first cone is still there, to the last bit.
    std::set<std::array<double, 3>> points;
    for (const Point& p : second.fused->points) {
      points.insert({p.x(), p.y(), p.z()});
    }
    for (const Index v : first.join->tileVertices) {
      const Point& p = first.fused->points[static_cast<std::size_t>(v)];
      QVERIFY(points.contains({p.x(), p.y(), p.z()}));
    }
  }

  void aChangeDownstreamRunsNothingUpstream() {
    const Document document = samples::twoConesOnASphere();
    Evaluated known;
    const Evaluation before = evaluate(document.fusions, 2, known, {});
    const auto upstream = known.fusions.at(1).results.fused;
    const Evaluation after = evaluate(withCurve(document, 2, FCF::Preset::Half).fusions, 2, known, {});
    QCOMPARE(known.fusions.at(1).results.fused, upstream);
    QVERIFY(!known.fusions.at(1).results.run(Stage::Blend).ran);
    QCOMPARE(after.fusion.base, before.fusion.base);
    QCOMPARE(after.results.combined, before.results.combined);
    QVERIFY(after.results.run(Stage::Blend).ran && !after.results.run(Stage::Overlay).ran);
  }

  void aCurveUpstreamChangesTheResultDownstreamAndLeavesTheCVsThatAreElsewhere() {
    const Document document = samples::twoConesOnASphere();
    Evaluated known;
    const Evaluation before = evaluate(document.fusions, 2, known, {});
    const Evaluation after = evaluate(withCurve(document, 1, FCF::Preset::Half).fusions, 2, known, {});
    QVERIFY(after.results.fused && after.results.fused->points != before.results.fused->points);
    QVERIFY(movedCVs(after.fusion).empty());
    for (const CVP& pair : after.fusion.inputs.loop) {
      QCOMPARE(after.fusion.inputs.base->point(pair.base.vertex), *pair.base.place);
    }
  }

  void theSameDocumentGivesTheSameBitsWhateverWasKnown() {
    const Document document = samples::twoConesOnASphere();
    Evaluated known;
    (void)evaluate(withCurve(document, 1, FCF::Preset::Half).fusions, 2, known, {});
    (void)evaluate(withCurve(document, 1, FCF::Preset::Linear).fusions, 2, known, {});
    const Evaluation again = evaluate(document.fusions, 2, known, {});
    Evaluated nothing;
    const Evaluation fresh = evaluate(document.fusions, 2, nothing, {});
    QVERIFY(again.results.fused->points == fresh.results.fused->points);
    QVERIFY(again.results.fused->faces() == fresh.results.fused->faces());
  }

  void aCVThatIsFoundAgainFarAwayIsTold() {
    Document document = samples::twoConesOnASphere();
    Fusion second = *find(document.fusions, 2);
    Point& place = *second.inputs.loop[3].base.place;
    place *= 1.2;
    document = edits::withFusion(std::move(document), second);
    Evaluated known;
    const std::vector<Error> moved = movedCVs(evaluate(document.fusions, 2, known, {}).fusion);
    QCOMPARE(moved.size(), std::size_t{1});
    QCOMPARE(moved[0].code, ErrorCode::LoopPointMoved);
    QCOMPARE(moved[0].cvs, std::vector<int>{3});
    QCOMPARE(moved[0].side, std::optional(Side::Base));
  }

  void aPointInAFaceOfAResultIsTheVerySamePointWhenItIsFoundAgain() {
    const Document document = samples::twoConesOnASphere();
    Evaluated known;
    Fusion second = evaluate(document.fusions, 2, known, {}).fusion;
    const TriangleMesh& mesh = *second.inputs.base;
    for (Index face = 0; face < mesh.faceCount(); face += 97) {
      const Result<Fusion> moved =
          edits::moveCV(second, 3, Side::Base, {-1, face, Eigen::Vector3d(0.1, 0.7, 0.2), {}});
      QVERIFY(moved);
      const SurfacePoint& point = moved->inputs.loop[3].base;
      const SurfacePoint again = attach(mesh, point);
      QVERIFY(again.face == point.face && again.bary == point.bary);
      // The weights are found again by division; a sliver loses most.
      QVERIFY((positionOf(mesh, point) - *point.place).norm() < 1e-9);
    }
  }

  void aFusionUpstreamWithoutAResultSaysWhy() {
    Document document = samples::twoConesOnASphere();
    document = edits::withFusion(document, edits::openLoop(*find(document.fusions, 1)));
    Evaluated known;
    const Evaluation open = evaluate(document.fusions, 2, known, {});
    QVERIFY(open.results.error && open.results.error->code == ErrorCode::SourceUnfused);
    QVERIFY(open.results.error->message.find("its loop is open") != std::string::npos);
    QCOMPARE(open.results.error->side, std::optional(Side::Base));
    QVERIFY(!open.results.fused && !open.fusion.inputs.base);
    QVERIFY2(open.assets.contains(1) && !open.assets.at(1), "it is known that there is none");
  }

  void aCancelIsACancelWhereverItComes() {
    const Document document = samples::twoConesOnASphere();
    for (int last = 0; last < 30; ++last) {
      int calls = 0;
      Evaluated known;
      const Evaluation stopped =
          evaluate(document.fusions, 2, known, Progress([&](double) { return ++calls <= last; }));
      if (stopped.results.error) {
        QCOMPARE(stopped.results.error->code, ErrorCode::Cancelled);
      }
      QVERIFY(evaluate(document.fusions, 2, known, {}).results.fused);
    }
  }

  void aRemovedFusionLeavesItsBaseToThoseThatWereMadeOfIt() {
    const Document document = edits::removeFusion(samples::twoConesOnASphere(), 1);
    QCOMPARE(document.fusions.size(), std::size_t{1});
    const Fusion& left = *document.fusions.front();
    QCOMPARE(left.base->name, std::string("base"));
    QVERIFY(!left.inputs.loop.front().base.place);
    Evaluated known;
    const Evaluation evaluation = evaluate(document.fusions, 2, known, {});
    QVERIFY(evaluation.results.fused);
    QCOMPARE(
        checkMesh({evaluation.results.fused->points, evaluation.results.fused->faces()}).eulerCharacteristic,
        2);
  }

  void aResultMayNotBeMadeOfItself() {
    const Document document = samples::twoConesOnASphere();
    const Result<Document> circle = edits::takeResult(document, 1, Side::Part, 2);
    QVERIFY(!circle && circle.error().code == ErrorCode::SourcesInCircle);
    const Result<Document> itself = edits::takeResult(document, 1, Side::Part, 1);
    QVERIFY(!itself && itself.error().code == ErrorCode::SourcesInCircle);
  }
};

QTEST_GUILESS_MAIN(EvaluateTest)
#include "evaluate_test.moc"
