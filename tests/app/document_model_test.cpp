#include <QtTest>

#include "tests/support/documents.h"
#include "tests/support/random_edits.h"

using namespace graftsman;

class DocumentModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anEditIsOneStepWithATextThatAPersonUnderstands() {
    DocumentModel model;
    model.reset(samples::document("fig4c_cone_sphere"));
    const Document before = model.document();
    const Document after = *edits::moveCV(before, 3, Side::Base, SurfacePoint::atVertex(11));
    model.push(std::make_unique<MoveCVP>(model, after, 3, Side::Base));
    QCOMPARE(model.history()->undoText(), QString("Move CV 3 on the base"));
    QVERIFY(model.document() == after);
    model.history()->undo();
    QVERIFY(model.document() == before);
    model.history()->redo();
    QVERIFY(model.document() == after);
  }

  void anEditThatChangesNothingLeavesNoStep() {
    DocumentModel model;
    model.reset(samples::document("fig4c_cone_sphere"));
    model.push(std::make_unique<SetAdjustment>(model, model.committed().inputs.adjustment));
    QCOMPARE(model.history()->count(), 0);
  }

  void aDragIsOneStepAndTwoDragsAreTwo() {
    DocumentModel model;
    model.reset(samples::document("fig4c_cone_sphere"));
    const Document start = model.document();
    for (int drag = 0; drag < 2; ++drag) {
      for (int i = 0; i < 10; ++i) {
        Document moved = model.committed();
        moved.inputs.loop[2].base.vertex = 20 + 10 * drag + i;
        model.drag(moved);
        QVERIFY(model.document() == moved);
      }
      model.push(std::make_unique<MoveCVP>(model, model.document(), 2, Side::Base));
      QVERIFY(!model.dragging());
    }
    QCOMPARE(model.history()->count(), 2);
    model.history()->undo();
    QCOMPARE(model.document().inputs.loop[2].base.vertex, 29);
    model.history()->undo();
    QVERIFY(model.document() == start);
  }

  void aCancelledDragLeavesNoTraceNotEvenInRedo() {
    DocumentModel model;
    model.reset(samples::document("fig4c_cone_sphere"));
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Half));
    model.history()->undo();
    const Document before = model.document();
    Document moved = before;
    moved.inputs.loop[2].base.vertex = 20;
    model.drag(moved);
    model.cancelDrag();
    QVERIFY(model.document() == before);
    QVERIFY(model.history()->canRedo());
  }

  void historyTellsWhatItTouched() {
    DocumentModel model;
    model.reset(samples::document("fig4c_cone_sphere"));
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
    model.reset(samples::document("fig4c_cone_sphere"));
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
    model.reset(samples::document("fig4c_cone_sphere"));
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
    model.reset(samples::document("fig4c_cone_sphere"));
    std::vector<Document> states = {model.document()};
    while (model.history()->count() < 300) {
      randomEdit(model, random);
      states.resize(static_cast<std::size_t>(model.history()->index()) + 1, model.document());
    }
    for (int i = static_cast<int>(states.size()) - 1; i >= 0; --i) {
      model.history()->setIndex(i);
      QVERIFY(model.document() == states[static_cast<std::size_t>(i)]);
    }
    for (int i = 0; i < 1000; ++i) {
      const auto to = static_cast<int>(random() % states.size());
      model.history()->setIndex(to);
      QVERIFY(model.document() == states[static_cast<std::size_t>(to)]);
    }
  }

  void undoRestoresAnEqualResult() {
    std::mt19937 random(7);
    DocumentModel model;
    model.reset(samples::document("fig4c_cone_sphere"));
    const FusionResults first = update(model.document().inputs, {}, {});
    FusionResults now = first;
    for (int i = 0; i < 40; ++i) {
      randomEdit(model, random);
      now = update(model.document().inputs, now, {});
    }
    model.history()->setIndex(0);
    now = update(model.document().inputs, now, {});
    QVERIFY(now.fused && now.fused->points == first.fused->points);
    QVERIFY(now.fused->faces() == first.fused->faces());
  }
};

QTEST_GUILESS_MAIN(DocumentModelTest)
#include "document_model_test.moc"
