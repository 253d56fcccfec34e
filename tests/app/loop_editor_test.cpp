#include <QtTest>

#include "app/document/document_model.h"
#include "app/document/loop_editor.h"
#include "core/fusion/path_position.h"
#include "tests/support/documents.h"

using namespace graftsman;

class LoopEditorTest : public QObject {
  Q_OBJECT

 private:
  struct Editing {
    DocumentModel model;
    LoopEditor editor{model};
    std::vector<Error> refused;

    explicit Editing(Fusion fusion) {
      model.reset(std::move(fusion));
      connect(&editor, &LoopEditor::refused, &model,
              [this](const Error& error) { refused.push_back(error); });
    }
    [[nodiscard]] const Loop& loop() const { return model.fusion().inputs.loop; }
  };
  static Fusion open(const std::string& name) {
    Fusion fusion = samples::fusion(name);
    fusion.closed = false;
    return fusion;
  }
  static SurfacePoint at(Index v) { return SurfacePoint::atVertex(v); }

 private Q_SLOTS:
  void clicksMakePairsInEitherOrder() {
    Editing e(open("fig4c_cone_sphere"));
    const std::size_t before = e.loop().size();
    e.editor.pick(Side::Part, at(1));
    QVERIFY(e.editor.halfPair());
    QCOMPARE(e.model.history()->count(), 0);
    e.editor.pick(Side::Base, at(2));
    e.editor.pick(Side::Base, at(4));
    e.editor.pick(Side::Part, at(3));
    QVERIFY(!e.editor.halfPair());
    QCOMPARE(e.loop().size(), before + 2);
    QVERIFY(e.loop()[before] == (CVP{at(1), at(2)}));
    QVERIFY(e.loop()[before + 1] == (CVP{at(3), at(4)}));
    QCOMPARE(e.model.history()->count(), 2);
  }

  void aSecondClickOnTheSameMeshMovesTheHalfMadePair() {
    Editing e(open("fig4c_cone_sphere"));
    e.editor.pick(Side::Part, at(1));
    e.editor.pick(Side::Part, at(3));
    QVERIFY(e.editor.halfPair() && e.editor.halfPair()->at == at(3));
    QVERIFY(e.editor.backOut());
    QVERIFY(!e.editor.halfPair());
    QVERIFY(!e.editor.backOut());
  }

  void aPickThatWasADoubleClickIsTakenBack() {
    Editing e(open("fig4c_cone_sphere"));
    const Fusion before = e.model.fusion();
    e.editor.pick(Side::Part, at(1));
    e.editor.takeBackPick();
    QVERIFY(!e.editor.halfPair());
    e.editor.pick(Side::Part, at(1));
    e.editor.pick(Side::Base, at(2));
    e.editor.takeBackPick();
    QVERIFY(e.model.fusion() == before);
    QVERIFY(e.editor.halfPair() && e.editor.halfPair()->at == at(1));
    e.editor.takeBackPick();
    QVERIFY(e.editor.halfPair());
  }

  void aClickOnTheFirstCVClosesTheLoop() {
    Editing e(open("fig4c_cone_sphere"));
    e.editor.clickCV(0);
    QVERIFY(e.model.fusion().closed);
    e.editor.clickCV(0);
    QCOMPARE(e.editor.selection(), QSet<int>{0});
  }

  void aClosedLoopTakesNoMorePairsAtItsEnd() {
    Editing e(samples::fusion("fig4c_cone_sphere"));
    e.editor.pick(Side::Part, at(1));
    QCOMPARE(e.refused.size(), std::size_t{1});
    QVERIFY(!e.editor.halfPair());
  }

  void twoPairsAreNotClosed() {
    Editing e(open("fig4c_cone_sphere"));
    e.editor.remove({0, 1, 2, 3, 4, 5});
    e.editor.close();
    QCOMPARE(e.refused.back().code, ErrorCode::LoopTooShort);
    QVERIFY(!e.model.fusion().closed);
  }

  void aDragIsOneStepAndKeepsOffOtherCVs() {
    Editing e(samples::fusion("fig4c_cone_sphere"));
    const Fusion before = e.model.fusion();
    e.editor.startDrag(Side::Base, 1);
    e.editor.dragTo(Side::Base, 1, at(5));
    QVERIFY(e.loop()[1].base == at(5));
    e.editor.dragTo(Side::Base, 1, before.inputs.loop[2].base);  // taken: it stays
    QVERIFY(e.loop()[1].base == at(5));
    e.editor.finishDrag();
    QCOMPARE(e.model.history()->count(), 1);
    e.model.history()->undo();
    QVERIFY(e.model.fusion() == before);
  }

  void anUndoInTheMiddleOfADragEndsIt() {
    Editing e(samples::fusion("fig4c_cone_sphere"));
    const Fusion before = e.model.fusion();
    e.editor.reverse();
    e.editor.startDrag(Side::Base, 1);
    e.editor.dragTo(Side::Base, 1, at(5));
    e.model.history()->undo();
    e.editor.dragTo(Side::Base, 1, at(6));
    e.editor.finishDrag();
    QVERIFY(e.model.fusion() == before);
  }

  void aPairIsInsertedOnEveryPathWithItsPartnerAsFarAlong() {
    for (const std::string& name : samples::kScenarios) {
      const Fusion fusion = samples::fusion(name);
      Outcome outcome;
      outcome.fusion = fusion;
      outcome.results = std::make_shared<const FusionResults>(update(fusion.inputs, {}, {}));
      const auto& paths = outcome.results->part.paths->paths;
      for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto there =
            pointAlong(*paths[i], *outcome.results->part.anchored, fusion.inputs.part->vertexCount(), 0.5);
        if (!there) {
          continue;
        }
        Editing e(fusion);
        e.editor.insertOnPath(Side::Part, static_cast<int>(i), *there, &outcome);
        QVERIFY2(e.refused.empty(), e.refused.empty() ? "" : e.refused.front().message.c_str());
        QCOMPARE(e.loop().size(), fusion.inputs.loop.size() + 1);
        QVERIFY(e.loop()[i + 1].part == *there);
        QVERIFY(e.loop()[i] == fusion.inputs.loop[i]);
        QCOMPARE(e.editor.selection(), QSet<int>{static_cast<int>(i) + 1});
      }
    }
  }

  void whatIsUndoneIsNotSelected() {
    Editing e(open("fig4c_cone_sphere"));
    e.editor.pick(Side::Part, at(1));
    e.editor.pick(Side::Base, at(2));
    e.editor.select({static_cast<int>(e.loop().size()) - 1});
    e.model.history()->undo();
    QVERIFY(e.editor.selection().isEmpty());
  }
};

QTEST_GUILESS_MAIN(LoopEditorTest)
#include "loop_editor_test.moc"
