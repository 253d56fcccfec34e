#include <QtTest>

#include "tests/support/documents.h"
#include "tests/support/random_edits.h"

using namespace graftsman;

class DocumentModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anEditIsOneStepWithATextThatAPersonUnderstands() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    const Fusion before = model.fusion();
    const Fusion after = *edits::moveCV(before, 3, Side::Base, SurfacePoint::atVertex(11));
    model.push(std::make_unique<MoveCVP>(model, after, 3, Side::Base));
    QCOMPARE(model.history()->undoText(), QString("Move CV 3 on the base"));
    QVERIFY(model.fusion() == after);
    model.history()->undo();
    QVERIFY(model.fusion() == before);
    model.history()->redo();
    QVERIFY(model.fusion() == after);
  }

  void anEditThatChangesNothingLeavesNoStep() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    model.push(std::make_unique<SetAdjustment>(model, model.committed().inputs.adjustment));
    QCOMPARE(model.history()->count(), 0);
  }

  void aDragIsOneStepAndTwoDragsAreTwo() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    const Fusion start = model.fusion();
    for (int drag = 0; drag < 2; ++drag) {
      for (int i = 0; i < 10; ++i) {
        Fusion moved = model.committed();
        moved.inputs.loop[2].base.vertex = 20 + 10 * drag + i;
        model.drag(moved);
        QVERIFY(model.fusion() == moved);
      }
      model.push(std::make_unique<MoveCVP>(model, model.fusion(), 2, Side::Base));
      QVERIFY(!model.dragging());
    }
    QCOMPARE(model.history()->count(), 2);
    model.history()->undo();
    QCOMPARE(model.fusion().inputs.loop[2].base.vertex, 29);
    model.history()->undo();
    QVERIFY(model.fusion() == start);
  }

  void aCancelledDragLeavesNoTraceNotEvenInRedo() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Half));
    model.history()->undo();
    const Fusion before = model.fusion();
    Fusion moved = before;
    moved.inputs.loop[2].base.vertex = 20;
    model.drag(moved);
    model.cancelDrag();
    QVERIFY(model.fusion() == before);
    QVERIFY(model.history()->canRedo());
  }

  void historyTellsWhatItTouched() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    model.push(std::make_unique<MoveCVP>(
        model, *edits::moveCV(model.committed(), 3, Side::Base, SurfacePoint::atVertex(11)), 3, Side::Base));
    std::optional<int> touched;
    connect(&model, &DocumentModel::changed, this, [&](Change change, const Touched& what) {
      QCOMPARE(change, Change::History);
      touched = what.cv;
    });
    model.history()->undo();
    QCOMPARE(touched, std::optional(3));
  }

  void whatAnUndoTookAwayIsNotTouched() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    model.push(std::make_unique<RemoveCVP>(model, edits::removePairs(model.committed(), {2}), 2, 1));
    std::vector<std::optional<int>> touched;
    connect(&model, &DocumentModel::changed, this,
            [&](Change, const Touched& what) { touched.push_back(what.cv); });
    model.history()->undo();  // the pair is back
    model.history()->redo();  // another pair has its number
    QCOMPARE(touched, (std::vector<std::optional<int>>{2, std::nullopt}));
  }

  void historyTellsOfTheAdjustmentAndOfTheSide() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    AdjustmentSettings settings = model.committed().inputs.adjustment;
    settings.falloff = 3;
    model.push(std::make_unique<SetAdjustment>(model, settings));
    model.push(std::make_unique<MoveCVP>(
        model, *edits::moveCV(model.committed(), 3, Side::Base, SurfacePoint::atVertex(11)), 3, Side::Base));
    std::vector<Touched> touched;
    connect(&model, &DocumentModel::changed, this,
            [&](Change, const Touched& what) { touched.push_back(what); });
    model.history()->undo();
    model.history()->undo();
    QCOMPARE(touched[0].side, std::optional(Side::Base));
    QVERIFY(!touched[0].adjustment && touched[1].adjustment);
  }

  void hundredsOfRandomEditsUndoAndRedoToEqualInputs() {
    std::mt19937 random(20'261'124);
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    std::vector<Fusion> states = {model.fusion()};
    while (model.history()->count() < 300) {
      randomEdit(model, random);
      states.resize(static_cast<std::size_t>(model.history()->index()) + 1, model.fusion());
    }
    for (int i = static_cast<int>(states.size()) - 1; i >= 0; --i) {
      model.history()->setIndex(i);
      QVERIFY(model.fusion() == states[static_cast<std::size_t>(i)]);
    }
    for (int i = 0; i < 1000; ++i) {
      const auto to = static_cast<int>(random() % states.size());
      model.history()->setIndex(to);
      QVERIFY(model.fusion() == states[static_cast<std::size_t>(to)]);
    }
  }

  void undoRestoresAnEqualResult() {
    std::mt19937 random(7);
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    const FusionResults first = update(model.fusion().inputs, {}, {});
    FusionResults now = first;
    for (int i = 0; i < 40; ++i) {
      randomEdit(model, random);
      now = update(model.fusion().inputs, now, {});
    }
    model.history()->setIndex(0);
    now = update(model.fusion().inputs, now, {});
    QVERIFY(now.fused && now.fused->points == first.fused->points);
    QVERIFY(now.fused->faces() == first.fused->faces());
  }
};

QTEST_GUILESS_MAIN(DocumentModelTest)
#include "document_model_test.moc"
