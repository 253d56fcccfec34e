#include <unistd.h>
#include <QAbstractButton>
#include <QMessageBox>

#include <csignal>
#include <cstring>

#include "app/workbench/autosave.h"
#include "tests/support/random_edits.h"
#include "tests/support/steps.h"
#include "tests/support/workbench.h"

using namespace graftsman;

namespace {

// Opens a sample, edits it, waits for the autosave, and is killed.
int crash(const QString& recovery) {
  Workbench bench(recovery);
  if (!bench.openSample("fig8b_cone_nose")) {
    return 1;
  }
  bench.window->model().push(std::make_unique<SetFCFPreset>(bench.window->model(), FCF::Preset::Half));
  QSignalSpy autosaved(&bench.window->autosave(), &Autosave::autosaved);
  bench.window->autosave().saveNow();
  if (!autosaved.wait(kPatienceMs)) {
    return 2;
  }
  ::kill(::getpid(), SIGKILL);
  return 3;
}

}  // namespace

class RecoveryTest : public QObject {
  Q_OBJECT

 private:
  static void crashInto(const QString& recovery) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.start(QCoreApplication::applicationFilePath(), {"--crash", recovery});
    QVERIFY(process.waitForFinished(2 * kPatienceMs));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    QCOMPARE(Autosave::findRecoverable(recovery).size(), std::size_t{1});
  }
  static QAbstractButton* button(const Workbench& bench, const char* name) {
    auto* box = bench.window->findChild<QMessageBox*>("recoveryBox");
    return box ? box->findChild<QAbstractButton*>(name) : nullptr;
  }

 private Q_SLOTS:
  void afterACrashTheWorkIsThereAgain() {
    QTemporaryDir folder;
    const QString recovery = folder.filePath("recovery");
    crashInto(recovery);
    Workbench bench(recovery);
    bench.window->offerRecovery();
    QAbstractButton* recover = button(bench, "recover");
    QVERIFY(recover && recover->isVisible());
    QTest::mouseClick(recover, Qt::LeftButton);
    QTRY_VERIFY(bench.fusion().part);
    QVERIFY(bench.settle());
    QVERIFY(bench.window->isWindowModified());
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::Half));
    const FusionInputs sample = samples::load("fig8b_cone_nose");
    QVERIFY(bench.fusion().inputs.loop == sample.loop);
    QVERIFY(bench.fusion().inputs.base->points() == sample.base->points());
    // It is this program's now: no other one offers it.
    QTRY_VERIFY(Autosave::findRecoverable(recovery).empty());
    QCOMPARE(QDir(recovery).entryList({"*.graft"}).size(), 1);
  }

  void askingLaterKeepsIt() {
    QTemporaryDir folder;
    const QString recovery = folder.filePath("recovery");
    crashInto(recovery);
    Workbench bench(recovery);
    bench.window->offerRecovery();
    QTest::mouseClick(button(bench, "recoverLater"), Qt::LeftButton);
    QCOMPARE(Autosave::findRecoverable(recovery).size(), std::size_t{1});
  }

  void throwingItAwayIsTheEndOfIt() {
    QTemporaryDir folder;
    const QString recovery = folder.filePath("recovery");
    crashInto(recovery);
    Workbench bench(recovery);
    bench.window->offerRecovery();
    QTest::mouseClick(button(bench, "recoverDiscard"), Qt::LeftButton);
    QVERIFY(Autosave::findRecoverable(recovery).empty());
    QVERIFY(!button(bench, "recover") || !button(bench, "recover")->isVisible());
  }

  void aProgramThatEndsAsItShouldLeavesNothing() {
    QTemporaryDir folder;
    const QString recovery = folder.filePath("recovery");
    {
      Workbench bench(recovery);
      QVERIFY(bench.openSample("fig4c_cone_sphere"));
      bench.window->model().push(std::make_unique<SetFCFPreset>(bench.window->model(), FCF::Preset::Half));
      bench.window->autosave().saveNow();
      QVERIFY(bench.settle());
      QCOMPARE(QDir(recovery).entryList({"*.graft"}).size(), 1);
      // A program that runs keeps its own.
      QVERIFY(Autosave::findRecoverable(recovery).empty());
    }
    QVERIFY(QDir(recovery).entryList({"*.graft"}).isEmpty());
  }

  void closingWithUnsavedWorkAsks() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    bench.window->model().push(std::make_unique<SetFCFPreset>(bench.window->model(), FCF::Preset::Half));
    QVERIFY(bench.window->isWindowModified());
    bench.window->close();
    QVERIFY(bench.window->isVisible());
    auto* box = bench.window->findChild<QMessageBox*>("unsavedBox");
    QVERIFY(box);
    QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
    QTRY_VERIFY(!bench.window->findChild<QMessageBox*>("unsavedBox"));
    QVERIFY(bench.window->isVisible());
    bench.window->close();
    box = bench.window->findChild<QMessageBox*>("unsavedBox");
    QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton);
    QTRY_VERIFY(!bench.window->isVisible());
  }

  void randomEditsInTheWindowUndoAndRedoToEqualStates() {
    constexpr int kEdits = steps(500);
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    DocumentModel& model = bench.window->model();
    std::mt19937 random(500);
    std::vector<Fusion> states = {model.fusion()};
    while (model.history()->count() < kEdits) {
      randomEdit(model, random);
      states.resize(static_cast<std::size_t>(model.history()->index()) + 1, model.fusion());
      if (states.size() % 50 == 0) {
        QVERIFY(bench.settle());
      }
    }
    for (int i = 0; i < steps(200); ++i) {
      const auto to = static_cast<int>(random() % states.size());
      model.history()->setIndex(to);
      QVERIFY(model.fusion() == states[static_cast<std::size_t>(to)]);
      if (i % 20 == 0) {
        QVERIFY(bench.settle());
        const FusionResults fresh = update(model.fusion().inputs, {}, {});
        if (model.fusion().closed && fresh.fused) {
          QVERIFY(bench.window->fusionPage().shown()->fused->points == fresh.fused->points);
        }
      }
    }
    model.history()->setIndex(0);
    QVERIFY(bench.settle());
    QVERIFY(model.fusion() == states.front());
    QVERIFY(bench.window->fusionPage().shown()->fused->points ==
            update(states.front().inputs, {}, {}).fused->points);
  }
};

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  if (argc == 3 && std::strcmp(argv[1], "--crash") == 0) {
    return crash(argv[2]);
  }
  RecoveryTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "recovery_test.moc"
