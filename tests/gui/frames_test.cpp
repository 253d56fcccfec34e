#include <QComboBox>
#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include "app/workbench/frames_dialog.h"
#include "tests/support/workbench.h"
#include "widgets/viewport/camera_view.h"

using namespace graftsman;

// Films of the result, by File ▸ Export frames.
class FramesTest : public QObject {
  Q_OBJECT

 private:
  template <class T>
  static T* the(const Workbench& bench, const char* name) {
    return bench.window->findChild<T*>(name);
  }

  static void setNumber(const Workbench& bench, const char* name, int value) {
    auto* box = the<QSpinBox>(bench, name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QString::number(value));
    QTest::keyClick(box, Qt::Key_Tab);
  }

  /// Opens the dialog and fills it in.
  static void choose(const Workbench& bench, Film::Kind kind, int count, const QString& folder) {
    bench.activate();
    QTest::keyClick(bench.window.get(), Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    auto* dialog = the<FramesDialog>(bench, "framesDialog");
    if (!dialog) {
      qFatal("no dialog");
    }
    if (!activated(*dialog)) {
      qFatal("the dialog does not become active");
    }
    auto* film = the<QComboBox>(bench, "framesKind");
    film->setFocus();
    QTest::keyClick(film, kind == Film::Kind::Morph ? Qt::Key_Down : Qt::Key_Up);
    setNumber(bench, "framesCount", count);
    setNumber(bench, "framesWidth", 80);
    setNumber(bench, "framesHeight", 60);
    QTest::keyClick(dialog, Qt::Key_F, Qt::AltModifier);
    auto* line = the<QLineEdit>(bench, "framesFolder");
    if (QApplication::focusWidget() != line) {
      qFatal("the key does not lead to the folder");
    }
    line->clear();
    QTest::keyClicks(line, folder);
  }

  static void press(const Workbench& bench, const char* button) {
    QTest::mouseClick(the<QPushButton>(bench, button), Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  static QStringList filesIn(const QString& folder) { return QDir(folder).entryList(QDir::Files); }

 private Q_SLOTS:
  void aTurntableGoesRoundFromWhereThePaneLooks() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const QString folder = bench.folder.filePath("round");
    choose(bench, Film::Kind::Turntable, 4, folder);
    press(bench, "framesExport");
    QVERIFY(bench.settle());
    QCOMPARE(filesIn(folder),
             (QStringList{"frame-001.png", "frame-002.png", "frame-003.png", "frame-004.png"}));
    QVERIFY2(bench.status().startsWith("Exported 4 frames"), qPrintable(bench.status()));
    const ResultPane& pane = *bench.resultPane();
    const CameraView view{pane.camera(), pane.size(), pane.devicePixelRatioF()};
    const FusionResults& results = *bench.window->fusionPage().shown();
    const Film film = withCameras({Film::Kind::Turntable, 4, {}, {80, 60}}, results, view);
    const Eigen::Vector3d looked = (view.camera.position - view.camera.pivot).normalized();
    QVERIFY(((film.cameras[0].position - film.cameras[0].pivot).normalized() - looked).norm() < 1e-9);
    for (int frame = 0; frame < 4; ++frame) {
      QFile file(folder + '/' + QString::fromStdString(frameName(frame, 4)));
      QVERIFY(file.open(QIODevice::ReadOnly));
      QCOMPARE(file.readAll().toStdString(), formatPng(drawFrame(results, film, frame)).value());
    }
  }

  void aMorphLeadsFromTheBaseToThePart() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const QString folder = bench.folder.filePath("morph");
    choose(bench, Film::Kind::Morph, 3, folder);
    press(bench, "framesExport");
    QVERIFY(bench.settle());
    QCOMPARE(filesIn(folder).size(), 3);
    const QImage first(folder + "/frame-001.png");
    const QImage last(folder + "/frame-003.png");
    QCOMPARE(first.size(), QSize(80, 60));
    QVERIFY(first != last);
    QVERIFY(first != QImage(folder + "/frame-002.png"));
  }

  void framesThatAreThereAreReplacedOnlyWhenAskedTo() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const QString folder = bench.folder.filePath("film");
    QVERIFY(QDir().mkpath(folder));
    QFile old(folder + "/frame-002.png");
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    choose(bench, Film::Kind::Turntable, 3, folder);
    press(bench, "framesExport");
    QVERIFY(QTest::qWaitForWindowExposed(the<QMessageBox>(bench, "framesBox")));
    press(bench, "framesKeep");
    QVERIFY(!bench.window->jobs().busy());
    QCOMPARE(filesIn(folder), QStringList{"frame-002.png"});
    QVERIFY(the<FramesDialog>(bench, "framesDialog")->isVisible());
    press(bench, "framesExport");
    QVERIFY(QTest::qWaitForWindowExposed(the<QMessageBox>(bench, "framesBox")));
    press(bench, "framesOverwrite");
    QVERIFY(bench.settle());
    QCOMPARE(filesIn(folder).size(), 3);
    QVERIFY(QFileInfo(old).size() > 3);
  }

  void cancelEndsAFilm() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const QString folder = bench.folder.filePath("long");
    choose(bench, Film::Kind::Turntable, 5000, folder);
    press(bench, "framesExport");
    auto* cancel = the<QToolButton>(bench, "statusCancel");
    QVERIFY(QTest::qWaitFor([&] { return cancel->isVisible() && !filesIn(folder).isEmpty(); }, kPatienceMs));
    QTest::mouseClick(cancel, Qt::LeftButton);
    QVERIFY(bench.settle());
    QVERIFY(filesIn(folder).size() < 5000);
    QVERIFY2(bench.status().startsWith("Cancelled. The frames that were done"), qPrintable(bench.status()));
  }

  void aWindowThatGoesEndsAFilm() {
    QTemporaryDir folder;
    {
      Workbench bench;
      QVERIFY(bench.openSample("fig4c_cone_sphere"));
      choose(bench, Film::Kind::Turntable, 5000, folder.filePath("film"));
      press(bench, "framesExport");
      QVERIFY(QTest::qWaitFor([&] { return !filesIn(folder.filePath("film")).isEmpty(); }, kPatienceMs));
    }
    QVERIFY(filesIn(folder.filePath("film")).size() < 5000);
  }

  void whatCannotBeWrittenIsTold() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const QString file = bench.folder.filePath("file");
    QVERIFY(QFile(file).open(QIODevice::WriteOnly));
    choose(bench, Film::Kind::Turntable, 2, file);
    press(bench, "framesExport");
    QVERIFY(bench.settle());
    QVERIFY2(bench.status().contains("is no folder"), qPrintable(bench.status()));
  }

  void withoutAResultThereAreNoFrames() {
    Workbench bench;
    QVERIFY(!bench.action("exportFrames")->isEnabled());
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QVERIFY(bench.action("exportFrames")->isEnabled());
    choose(bench, Film::Kind::Turntable, 2, "");
    QVERIFY(!the<QPushButton>(bench, "framesExport")->isEnabled());
    press(bench, "framesCancel");
    bench.action("newProject")->trigger();
    QVERIFY(bench.settle());
    QVERIFY(!bench.action("exportFrames")->isEnabled());
  }
};

QTEST_MAIN(FramesTest)
#include "frames_test.moc"
