#include <QDockWidget>
#include <QUndoView>

#include "app/document/commands.h"
#include "app/workbench/autosave.h"
#include "app/workbench/project_files.h"
#include "core/project/project_file.h"
#include "tests/support/workbench.h"

using namespace graftsman;

class HistoryDockTest : public QObject {
  Q_OBJECT

 private:
  static std::vector<Point> points(const Workbench& bench) {
    return bench.window->fusionPage().shown()->fused->points;
  }
  static QStringList rows(const Workbench& bench) {
    const QAbstractItemModel* model = bench.window->findChild<QUndoView*>("historyView")->model();
    QStringList texts;
    for (int row = 0; row < model->rowCount(); ++row) {
      texts.append(model->index(row, 0).data().toString());
    }
    return texts;
  }
  static void press(const Workbench& bench, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(bench.window.get(), Qt::Key_Z, modifiers);
  }
  // A saved project with two steps of history.
  static QString saved(const Workbench& bench) {
    const QString path = bench.folder.filePath("nose.graft");
    [&] {
      QVERIFY(bench.openSample("fig4c_cone_sphere"));
      bench.action("half")->trigger();
      bench.action("paste")->trigger();
      QVERIFY(bench.settle());
      bench.window->files().save(path);
      QVERIFY(bench.settle());
    }();
    return path;
  }

 private Q_SLOTS:
  void undoGoesOnAfterReopening() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const std::vector<Point> first = points(bench);
    bench.action("half")->trigger();
    QVERIFY(bench.settle());
    const std::vector<Point> second = points(bench);
    bench.action("paste")->trigger();
    QVERIFY(bench.settle());
    const std::vector<Point> third = points(bench);
    const QString path = bench.folder.filePath("nose.graft");
    bench.window->files().save(path);
    QVERIFY(bench.settle());
    bench.action("newProject")->trigger();
    QCOMPARE(rows(bench).size(), 1);

    bench.window->openFile(path);
    QVERIFY(bench.settle());
    QVERIFY(!bench.window->isWindowModified());
    QVERIFY(points(bench) == third);
    QCOMPARE(rows(bench).mid(1), QStringList({"Curve: Half", "Curve: Paste"}));
    auto* view = bench.window->findChild<QUndoView*>("historyView");
    QCOMPARE(view->currentIndex().row(), 2);
    QVERIFY(bench.action("undo")->text().contains("Curve: Paste"));
    bench.window->findChild<QDockWidget*>("historyDock")->raise();
    QVERIFY(view->isVisible());
    if (const QString picture = qEnvironmentVariable("HISTORY_PICTURE"); !picture.isEmpty()) {
      bench.window->grab().save(picture);
    }
    press(bench, Qt::ControlModifier);
    QVERIFY(bench.settle());
    QVERIFY(points(bench) == second);
    QVERIFY(bench.window->isWindowModified());
    press(bench, Qt::ControlModifier);
    QVERIFY(bench.settle());
    QVERIFY(points(bench) == first);
    QVERIFY(!bench.action("undo")->isEnabled());
    press(bench, Qt::ControlModifier | Qt::ShiftModifier);
    press(bench, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(bench.settle());
    QVERIFY(points(bench) == third);
    QVERIFY(!bench.window->isWindowModified());
  }

  void aHistoryThatIsClearedIsGoneFromTheFileOnceItIsSaved() {
    Workbench bench;
    const QString path = saved(bench);
    const std::vector<Point> before = points(bench);
    QVERIFY(bench.action("clearHistory")->isEnabled());
    bench.action("clearHistory")->trigger();
    QVERIFY(bench.settle());
    QCOMPARE(rows(bench).size(), 1);
    QVERIFY(points(bench) == before);
    QVERIFY2(bench.window->isWindowModified(), "the file still has it");
    QVERIFY(!bench.action("undo")->isEnabled() && !bench.action("clearHistory")->isEnabled());
    QCOMPARE(readProject(path.toStdString(), {})->project.history.steps.size(), std::size_t{2});
    bench.window->files().save(path);
    QVERIFY(bench.settle());
    QVERIFY(!bench.window->isWindowModified());
    QVERIFY(readProject(path.toStdString(), {})->project.history.steps.empty());
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::Paste));
  }

  void clearingWhatNoFileHasChangesNothing() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    bench.action("half")->trigger();
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!bench.window->isWindowModified());
    bench.action("clearHistory")->trigger();
    QVERIFY(!bench.window->isWindowModified());
    bench.action("half")->trigger();
    bench.action("clearHistory")->trigger();
    QVERIFY2(bench.window->isWindowModified(), "the document is not saved");
  }

  void whatIsRecoveredHasItsHistory() {
    Workbench bench;
    const QString path = saved(bench);
    bench.action("keepBaseSlope")->trigger();
    QSignalSpy autosaved(&bench.window->autosave(), &Autosave::autosaved);
    bench.window->autosave().saveNow();
    QVERIFY(autosaved.wait(kPatienceMs));
    const QDir recovery(bench.folder.filePath("recovery"));
    const QString left = recovery.filePath(recovery.entryList({"*.graft"}).value(0));
    const QString copy = bench.folder.filePath("left.graft");
    QVERIFY(QFile::copy(left, copy));
    bench.window->files().recover(copy, path);
    QVERIFY(bench.settle());
    QVERIFY(bench.window->isWindowModified());
    QCOMPARE(rows(bench).mid(1), QStringList({"Curve: Half", "Curve: Paste", "Curve: Keep base slope"}));
    press(bench, Qt::ControlModifier);
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::Paste));
    QVERIFY2(bench.window->isWindowModified(), "nothing that was recovered is in its file");
  }
};

QTEST_MAIN(HistoryDockTest)
#include "history_dock_test.moc"
