#include <QSignalSpy>
#include <QtTest>

#include "app/document/document_commands.h"
#include "core/project/document_edits.h"
#include "tests/support/documents.h"
#include "tests/support/project_bytes.h"
#include "tests/support/random_edits.h"

using namespace graftsman;
using namespace graftsman::projects;

namespace {

// Closes the project and opens it again.
void reopen(DocumentModel& model) {
  Project project;
  project.document = model.document();
  project.shown = model.shown();
  project.history = model.historyValue();
  const Result<LoadedProject> loaded = parse(bytesOf(project));
  if (!loaded || !loaded->damage.empty()) {
    qFatal("the project does not come back whole");
  }
  model.reset(loaded->project.document, loaded->project.shown, loaded->project.history);
}

}  // namespace

class SavedHistoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void undoGoesOnWhereTheProjectWasSaved() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    const Fusion first = model.fusion();
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Half));
    model.push(std::make_unique<ReverseLoop>(model, edits::reverseLoop(model.committed())));
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Paste));
    const Fusion last = model.fusion();
    model.history()->undo();
    reopen(model);
    QCOMPARE(model.history()->count(), 3);
    QCOMPARE(model.history()->index(), 2);
    QVERIFY(model.history()->isClean());
    QCOMPARE(model.history()->undoText(), QString("Reverse the loop"));
    QCOMPARE(model.history()->redoText(), QString("Curve: Paste"));
    model.history()->redo();
    QVERIFY(sameEdits(model.fusion(), last));
    QVERIFY(!model.history()->isClean());
    model.history()->setIndex(0);
    QVERIFY(sameEdits(model.fusion(), first));
    model.history()->setIndex(2);
    QVERIFY(model.history()->isClean());
    // An edit takes the place of what was undone.
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Linear));
    QCOMPARE(model.history()->count(), 3);
    QCOMPARE(model.history()->undoText(), QString("Curve: Linear"));
  }

  void whatAStepTouchedAndShowedIsKept() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    model.push(std::make_unique<MoveCVP>(
        model, *edits::moveCV(model.committed(), 3, Side::Base, SurfacePoint::atVertex(11)), 3, Side::Base));
    model.push(std::make_unique<AddFusion>(model, model.fusion().part, nullptr));
    reopen(model);
    QCOMPARE(model.shown(), 2);
    model.history()->undo();
    QCOMPARE(model.shown(), 1);
    model.history()->redo();
    QCOMPARE(model.shown(), 2);
    model.history()->undo();
    std::optional<int> touched;
    connect(&model, &DocumentModel::changed, this, [&](Change change, const Touched& what) {
      QCOMPARE(change, Change::History);
      touched = what.cv;
    });
    model.history()->undo();
    QCOMPARE(touched, std::optional(3));
  }

  void whoeverListensIsToldOnce() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    std::mt19937 random(5);
    while (model.history()->count() < 50) {
      randomEdit(model, random);
    }
    const QSignalSpy moved(model.history(), &QUndoStack::indexChanged);
    const QSignalSpy changed(&model, &DocumentModel::changed);
    reopen(model);
    QCOMPARE(moved.size(), 1);
    QCOMPARE(moved[0][0].toInt(), model.history()->index());
    QCOMPARE(changed.size(), 1);
  }

  void aHistoryThatIsForgottenLeavesTheDocument() {
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Half));
    const Document before = model.document();
    model.forgetHistory();
    QVERIFY(model.document() == before);
    QCOMPARE(model.history()->count(), 0);
    QVERIFY(!model.history()->canUndo());
    QVERIFY(model.historyValue().steps.empty() && model.historyValue().states.empty());
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Paste));
    model.history()->undo();
    QVERIFY(model.document() == before);
  }

  void randomEditsWithReopeningInBetweenUndoAndRedoToEqualStates() {
    std::mt19937 random(20'261'126);
    DocumentModel model;
    model.reset(samples::fusion("fig4c_cone_sphere"));
    std::vector<Fusion> states = {model.fusion()};
    int reopened = 0;
    for (int edits = 0; edits < 200;) {
      const int before = model.history()->count() + model.history()->index();
      randomEdit(model, random);
      edits += model.history()->count() + model.history()->index() != before ? 1 : 0;
      states.resize(static_cast<std::size_t>(model.history()->index()) + 1, model.fusion());
      states.back() = model.fusion();
      if (random() % 10 == 0) {
        const int back = static_cast<int>(random() % 4);
        model.history()->setIndex(std::max(0, model.history()->index() - back));
      }
      if (random() % 12 == 0) {
        reopen(model);
        ++reopened;
        QVERIFY(sameEdits(model.fusion(), states[static_cast<std::size_t>(model.history()->index())]));
      }
    }
    QVERIFY(reopened > 5);
    reopen(model);
    for (int i = model.history()->count(); i >= 0; --i) {
      model.history()->setIndex(i);
      QVERIFY(sameEdits(model.fusion(), states[static_cast<std::size_t>(i)]));
    }
    for (int i = 0; i <= model.history()->count(); ++i) {
      model.history()->setIndex(i);
      QVERIFY(sameEdits(model.fusion(), states[static_cast<std::size_t>(i)]));
    }
  }
};

QTEST_GUILESS_MAIN(SavedHistoryTest)
#include "saved_history_test.moc"
