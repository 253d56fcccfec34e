#include <QAbstractButton>
#include <QTableView>

#include "core/project/project_file.h"
#include "tests/support/places.h"
#include "tests/support/workbench.h"
#include "widgets/curve/fusion_curve_editor.h"

using namespace graftsman;

// A designer's way through the program, with real mouse and keys on the real window.
class WorkbenchTest : public QObject {
  Q_OBJECT

 private:
  static std::vector<Point> fused(const Workbench& bench) {
    return bench.window->fusionPage().shown()->fused->points;
  }

 private Q_SLOTS:
  void twoModelsAreFusedByHand() {
    Workbench bench;
    const Result<LoadedScenario> scenario = readScenario(samples::scenarioPath("fig8b_cone_nose"), {});
    const Loop& wanted = scenario->scenario.inputs.loop;

    // The part is dropped, the base opened by its dialog.
    bench.action("tilesMode")->trigger();
    bench.drop(bench.pane(Side::Part), QString::fromStdString(scenario->scenario.part.string()));
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().part);
    bench.action("loadBase")->trigger();
    auto* dialog = bench.window->findChild<QFileDialog*>("loadDialog");
    QVERIFY(dialog);
    dialog->selectFile(QString::fromStdString(scenario->scenario.base.string()));
    static_cast<QDialog*>(dialog)->accept();
    QTRY_VERIFY(bench.fusion().base);
    QVERIFY(bench.settle());

    // Pairs, part first and base first in turn.
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const Side first = i % 2 == 0 ? Side::Part : Side::Base;
      for (const Side side : {first, first == Side::Part ? Side::Base : Side::Part}) {
        bench.clickVertex(side, side == Side::Part ? wanted[i].part.vertex : wanted[i].base.vertex);
      }
      QCOMPARE(bench.fusion().inputs.loop.size(), i + 1);
    }
    QVERIFY(bench.fusion().inputs.loop == wanted);
    QVERIFY(!bench.fusion().closed);

    // Enter closes the loop: the tiles appear, and there is a result.
    QTest::keyClick(bench.pane(Side::Base), Qt::Key_Return);
    QVERIFY(bench.fusion().closed);
    QVERIFY(bench.settle());
    QVERIFY(bench.window->fusionPage().shown());
    QVERIFY(fused(bench) == update(bench.fusion().inputs, {}, {}).fused->points);

    // The curve.
    QTest::keyClick(bench.window.get(), Qt::Key_F3);
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Fusion);
    auto* editor = bench.window->findChild<FusionCurveEditor*>();
    const FCFPoint point = editor->curve().points()[1];
    const QPoint from = editor->position(point).toPoint();
    const int steps = bench.window->model().history()->count();
    QTest::mousePress(editor, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) {
      QTest::mouseMove(editor, from - QPoint(0, 4 * i));
    }
    QVERIFY(bench.window->model().dragging());
    QTest::mouseRelease(editor, Qt::LeftButton, {}, from - QPoint(0, 32));
    QCOMPARE(bench.window->model().history()->count(), steps + 1);
    QVERIFY(bench.fusion().inputs.fcf.points()[1].f > point.f);
    QVERIFY(bench.settle());

    // Back and forth through every step.
    const Fusion last = bench.fusion();
    const std::vector<Point> result = fused(bench);
    while (bench.window->model().history()->canUndo()) {
      QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    }
    QVERIFY(!bench.fusion().part && !bench.fusion().base);
    QVERIFY(bench.fusion().inputs.loop.empty());
    while (bench.window->model().history()->canRedo()) {
      QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    }
    QVERIFY(bench.fusion() == last);
    QVERIFY(bench.settle());
    QVERIFY(fused(bench) == result);

    // Saved, closed, opened again.
    const QString path = bench.folder.filePath("nose.graft");
    bench.window->files().save(path);
    QVERIFY(bench.settle());
    QVERIFY(!bench.window->isWindowModified());
    QVERIFY(bench.window->windowTitle().contains("nose"));
    bench.action("newProject")->trigger();
    QVERIFY(!bench.fusion().part);
    bench.window->openFile(path);
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().inputs.loop == last.inputs.loop);
    QVERIFY(bench.fusion().inputs.fcf == last.inputs.fcf);
    QVERIFY(fused(bench) == result);
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Fusion);
  }

  void aSampleOpensReadyForTheCurve() {
    Workbench bench;
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Fusion);
    QVERIFY(bench.window->findChild<FusionCurveEditor*>()->isVisible());
  }

  void aDragOfTheCurveIsSeenAtOnceAndEscTakesItBack() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    auto* editor = bench.window->findChild<FusionCurveEditor*>();
    const Fusion before = bench.fusion();
    const QImage picture = bench.resultPane()->picture();
    const QPoint from = editor->position(editor->curve().points()[1]).toPoint();
    QTest::mousePress(editor, Qt::LeftButton, {}, from);
    QTest::mouseMove(editor, from + QPoint(0, -40));
    QVERIFY(bench.resultPane()->picture() != picture);
    QTest::keyClick(editor, Qt::Key_Escape);
    QVERIFY(bench.fusion() == before);
    QCOMPARE(bench.window->model().history()->count(), 0);
    QTest::mouseRelease(editor, Qt::LeftButton, {}, from + QPoint(0, -40));
    QVERIFY(bench.fusion() == before);
  }

  void aCVIsDraggedWhileARunIsUnderWay() {
    Workbench bench;
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    QTest::keyClick(bench.window.get(), Qt::Key_F2);
    const Fusion before = bench.fusion();
    MeshPane* pane = bench.pane(Side::Base);
    const TriangleMesh& mesh = *bench.fusion().inputs.base;
    const Index vertex = before.inputs.loop[2].base.vertex;
    bench.lookAt(pane, mesh, vertex);
    const QPoint from = pane->screenPosition(mesh.point(vertex)).toPoint();
    QTest::mousePress(pane, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 12; ++i) {
      QTest::mouseMove(pane, from + QPoint(i * 3, i * 2));
      if (i == 6) {
        QTRY_VERIFY(bench.window->runner().busy());
      }
    }
    QTest::mouseRelease(pane, Qt::LeftButton, {}, from + QPoint(36, 24));
    QVERIFY(bench.fusion().inputs.loop[2].base.vertex != vertex);
    QCOMPARE(bench.window->model().history()->count(), 1);
    QCOMPARE(bench.window->model().history()->undoText(), QString("Move CV 2 on the base"));
    QVERIFY(bench.settle());
    const FusionResults fresh = update(bench.fusion().inputs, {}, {});
    if (fresh.fused) {
      QVERIFY(fused(bench) == fresh.fused->points);
    }
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.fusion() == before);
    QVERIFY(bench.settle());
    QVERIFY(fused(bench) == update(before.inputs, {}, {}).fused->points);
  }

  void aHalfMadePairIsAbandonedByEsc() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_F2);
    bench.action("openLoop")->trigger();
    const Fusion before = bench.fusion();
    bench.clickVertex(Side::Base, 3);
    auto* table = bench.window->findChild<QTableView*>();
    QCOMPARE(table->model()->rowCount(), static_cast<int>(before.inputs.loop.size()) + 1);
    QTest::keyClick(bench.pane(Side::Base), Qt::Key_Escape);
    QCOMPARE(table->model()->rowCount(), static_cast<int>(before.inputs.loop.size()));
    QVERIFY(bench.fusion() == before);
  }

  void cancelStopsARunAndTheNextEditGoesOn() {
    Workbench bench;
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    bench.action("reverse")->trigger();
    bench.action("cancel")->setEnabled(true);
    bench.action("cancel")->trigger();
    QVERIFY(bench.settle());
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.settle());
    QVERIFY(fused(bench) == update(bench.fusion().inputs, {}, {}).fused->points);
  }

  void aClockwiseLoopSaysSoAndOffersTheRemedy() {
    Workbench bench;
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    QTest::keyClick(bench.window.get(), Qt::Key_F2);
    const Fusion before = bench.fusion();
    bench.action("reverse")->trigger();
    QVERIFY(bench.settle());
    auto* frame = bench.window->findChild<QWidget*>("baseFrame");
    auto* remedy = frame->findChild<QAbstractButton*>("remedy");
    QVERIFY(remedy && remedy->isVisible());
    QCOMPARE(remedy->text(), QString("Reverse the loop"));
    QTest::mouseClick(remedy, Qt::LeftButton);
    QVERIFY(bench.fusion() == before);
    QVERIFY(bench.settle());
    QVERIFY(!remedy->isVisible());
  }

  void aBadFileIsRefusedAndNothingIsLost() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const Fusion before = bench.fusion();
    const QString path = bench.folder.filePath("broken.obj");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0\nf 1 2 9\n");
    file.close();
    QTest::keyClick(bench.window.get(), Qt::Key_F2);
    bench.drop(bench.pane(Side::Base), path);
    QVERIFY(bench.settle());
    QVERIFY2(bench.status().contains("broken.obj"), qPrintable(bench.status()));
    QVERIFY(bench.fusion() == before);
    bench.window->openFile(bench.folder.filePath("missing.graft"));
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion() == before);
  }

  void theTableSelectsAndIsSelected() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_F2);
    auto* table = bench.window->findChild<QTableView*>();
    table->selectRow(3);
    const Fusion before = bench.fusion();
    QTest::keyClick(table, Qt::Key_Delete);
    QCOMPARE(bench.fusion().inputs.loop.size(), before.inputs.loop.size() - 1);
    QVERIFY(bench.fusion().inputs.loop[3] == before.inputs.loop[4]);
  }

  void theExportIsWhatTheCommandLineWrites() {
    Workbench bench;
    QVERIFY(bench.openSample("fig8c_cone_nose"));
    const QString project = bench.folder.filePath("nose.graft");
    bench.window->files().save(project);
    QVERIFY(bench.settle());
    for (const char* ending : {"obj", "ply", "stl", "off"}) {
      const QString ours = bench.folder.filePath(QString("ours.%1").arg(ending));
      const QString theirs = bench.folder.filePath(QString("theirs.%1").arg(ending));
      bench.window->files().exportResult(
          ours, std::make_shared<const FusionResults>(*bench.window->fusionPage().shown()));
      QVERIFY(bench.settle());
      QCOMPARE(QProcess::execute(QString::fromStdString(places::commandLine().string()),
                                 {"fuse", project, "-o", theirs}),
               0);
      QFile a(ours);
      QFile b(theirs);
      QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
      QVERIFY(!a.readAll().isEmpty());
      a.seek(0);
      QVERIFY(a.readAll() == b.readAll());
    }
  }
};

QTEST_MAIN(WorkbenchTest)
#include "workbench_test.moc"
