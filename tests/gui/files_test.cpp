#include <QAbstractButton>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QToolButton>

#include "app/document/commands.h"
#include "app/workbench/autosave.h"
#include "app/workbench/project_files.h"
#include "tests/support/project_bytes.h"
#include "tests/support/workbench.h"

using namespace graftsman;

// Files, with real dialogs, drops and keys on the real window.
class FilesTest : public QObject {
  Q_OBJECT

 private:
  static void write(const QString& path, const std::string& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray::fromStdString(bytes)) < 0) {
      qFatal("%s cannot be written", qPrintable(path));
    }
  }
  static std::string samplePath(const char* name) { return samples::scenarioPath(name).string(); }

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void aProjectIsSavedByKeysAndOpenedByKeys() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const QString path = bench.folder.filePath("mine");
    QTest::keyClick(bench.window.get(), Qt::Key_S, Qt::ControlModifier);
    bench.answerFileDialog("saveDialog", path);
    QVERIFY(bench.settle());
    QVERIFY(QFileInfo::exists(path + ".graft"));
    QCOMPARE(bench.window->windowTitle(), QString("mine[*] – Graftsman"));
    QVERIFY(!bench.window->isWindowModified());
    // An edit marks it, undo takes the mark away, Ctrl+S saves without asking.
    QTest::keyClick(bench.resultPane(), Qt::Key_4, Qt::ShiftModifier);
    QVERIFY(bench.window->isWindowModified());
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!bench.window->isWindowModified());
    QTest::keyClick(bench.window.get(), Qt::Key_Y, Qt::ControlModifier);
    QVERIFY(bench.settle());
    QTest::keyClick(bench.window.get(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(bench.settle());
    QVERIFY(!bench.window->isWindowModified());
    const FCF saved = bench.fusion().inputs.fcf;
    const std::vector<Point> points = bench.window->fusionPage().shown()->fused->points;
    QTest::keyClick(bench.window.get(), Qt::Key_N, Qt::ControlModifier);
    QVERIFY(!bench.fusion().part);
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Start);
    QTest::keyClick(bench.window.get(), Qt::Key_O, Qt::ControlModifier);
    bench.answerFileDialog("openDialog", path + ".graft");
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().inputs.fcf == saved);
    QVERIFY(bench.window->fusionPage().shown()->fused->points == points);
  }

  void saveAsGoesOnUnderTheNewName() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    bench.window->files().save(bench.folder.filePath("one.graft"));
    QVERIFY(bench.settle());
    QTest::keyClick(bench.window.get(), Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    bench.answerFileDialog("saveDialog", bench.folder.filePath("two.graft"));
    QVERIFY(bench.settle());
    QVERIFY(bench.window->windowTitle().startsWith("two"));
    QMenu* recent = bench.window->actions().menu("recentMenu");
    QCOMPARE(recent->actions().size(), 2);
    QCOMPARE(recent->actions()[0]->text(), QString("two.graft"));
    recent->actions()[1]->trigger();
    QVERIFY(bench.settle());
    QVERIFY(bench.window->windowTitle().startsWith("one"));
  }

  void theStartPageOpensSamplesAndRecentProjects() {
    Workbench bench;
    QList<QToolButton*> samples;
    for (int i = 0; i < 5; ++i) {
      auto* button = bench.window->findChild<QToolButton*>(QString("sample%1").arg(i));
      QVERIFY(button && button->isVisible() && !button->icon().isNull());
      samples.append(button);
    }
    QVERIFY(bench.window->findChild<QLabel*>("steps")->text().count("<li>") == 3);
    QTest::mouseClick(samples[4], Qt::LeftButton);
    QVERIFY(bench.settle());
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Fusion);
    QVERIFY(bench.window->fusionPage().shown());
    bench.window->files().save(bench.folder.filePath("kept.graft"));
    QVERIFY(bench.settle());
    QTest::keyClick(bench.window.get(), Qt::Key_N, Qt::ControlModifier);
    auto* recent = bench.window->findChild<QAbstractButton*>("recent");
    QVERIFY(recent && recent->text() == "kept");
    QTest::mouseClick(recent, Qt::LeftButton);
    QVERIFY(bench.settle());
    QVERIFY(bench.window->fusionPage().shown());
  }

  void filesAreDroppedOnPanesAndOnTheStartPage() {
    Workbench bench;
    const Result<LoadedScenario> scenario = readScenario(samples::scenarioPath("fig4c_cone_sphere"), {});
    bench.drop(bench.window.get(), QString::fromStdString(scenario->scenario.part.string()));
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().part && !bench.fusion().base);
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Tiles);
    bench.drop(bench.pane(Side::Base), QString::fromStdString(scenario->scenario.base.string()));
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().base);
    QCOMPARE(bench.window->model().history()->count(), 2);
    // The scenario on a pane replaces all, after asking.
    bench.drop(bench.pane(Side::Part), QString::fromStdString(samplePath("fig4c_cone_sphere")));
    auto* box = bench.window->findChild<QMessageBox*>("unsavedBox");
    QVERIFY(box);
    QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton);
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().closed);
  }

  void everyFormatIsExportedByItsEndingAndThePictureToo() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    for (const char* ending : {"obj", "ply", "stl", "off", "glb"}) {
      const QString path = bench.folder.filePath(QString("out.%1").arg(ending));
      QTest::keyClick(bench.window.get(), Qt::Key_E, Qt::ControlModifier);
      bench.answerFileDialog("exportDialog", path);
      QVERIFY(bench.settle());
      QVERIFY2(QFileInfo(path).size() > 1000, qPrintable(path));
      QVERIFY(bench.status().contains("Exported"));
    }
    // Without an ending, that of the kind chosen.
    QTest::keyClick(bench.window.get(), Qt::Key_E, Qt::ControlModifier);
    auto* dialog = bench.window->findChild<QFileDialog*>("exportDialog");
    dialog->selectNameFilter(dialog->nameFilters().last());
    Q_EMIT dialog->filterSelected(dialog->nameFilters().last());
    bench.answerFileDialog("exportDialog", bench.folder.filePath("morph"));
    QVERIFY(bench.settle());
    QVERIFY(QFileInfo::exists(bench.folder.filePath("morph.glb")));
    QTest::keyClick(bench.window.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    bench.answerFileDialog("pictureDialog", bench.folder.filePath("picture.png"));
    QVERIFY(bench.settle());
    QCOMPARE(QImage(bench.folder.filePath("picture.png")).size(),
             bench.resultPane()->size() * bench.resultPane()->devicePixelRatioF());
  }

  void aDamagedProjectOpensWithWhatIsWhole() {
    Workbench bench;
    const QString path = bench.folder.filePath("damaged.graft");
    write(path, projects::withEntries([](projects::Entries& entries) {
            for (auto& [name, bytes] : entries) {
              if (name.starts_with("meshes/")) {
                bytes = bytes.substr(0, bytes.size() / 2);
                return;
              }
            }
          }));
    bench.window->openFile(path);
    QVERIFY(bench.settle());
    QVERIFY2(bench.status().contains("damaged.graft is damaged; the rest of it is open."),
             qPrintable(bench.status()));
    QVERIFY(static_cast<bool>(bench.fusion().part) != static_cast<bool>(bench.fusion().base));
    // It goes on: the missing mesh can be loaded.
    QVERIFY(bench.action("loadPart")->isEnabled() && bench.action("loadBase")->isEnabled());
  }

  void aNewerFormatAndOtherFilesAreRefusedPolitely() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const auto before = bench.fusion();
    const QString newer = bench.folder.filePath("newer.graft");
    write(newer, projects::withDocument([](nlohmann::json& document) {
            for (auto& [key, value] : document.items()) {
              if (value.is_number_integer()) {
                value = 1000;
              }
            }
          }));
    bench.window->openFile(newer);
    QVERIFY(bench.settle());
    QVERIFY2(bench.status().contains("newer"), qPrintable(bench.status()));
    QVERIFY(bench.fusion() == before);
    for (const auto& [name, bytes] : std::initializer_list<std::pair<const char*, std::string>>{
             {"empty.graft", ""},
             {"noise.graft", "PK\3\4 nothing of the kind"},
             {"text.json", "{\"m1\": 1"},
             {"empty.obj", ""},
             {"noise.ply", "ply\nformat nonsense"},
             {"noise.stl", "\x7f\x7f\x7f"},
             {"noise.off", "OFF\n3 1 0\n0 0 0\n"},
             {"unknown.xyz", "1 2 3\n"}}) {
      const QString path = bench.folder.filePath(name);
      write(path, bytes);
      bench.drop(bench.pane(Side::Base), path);
      QVERIFY(bench.settle());
      QVERIFY2(bench.status().contains(name), qPrintable(QString(name) + ": " + bench.status()));
      QVERIFY(bench.window->findChild<QLabel*>("statusIcon")->isVisible());
      QVERIFY(bench.fusion() == before);
    }
  }

  void whatCannotBeWrittenIsToldAndStaysUnsaved() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.resultPane(), Qt::Key_4, Qt::ShiftModifier);
    QVERIFY(bench.settle());
    const QString nowhere = bench.folder.filePath("no such folder/a.graft");
    bench.window->files().save(nowhere);
    QVERIFY(bench.settle());
    QVERIFY2(bench.status().contains("a.graft"), qPrintable(bench.status()));
    QVERIFY(bench.window->isWindowModified());
  }

  void closingAsksAndSaveClosesAfterwards() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.resultPane(), Qt::Key_4, Qt::ShiftModifier);
    QVERIFY(bench.settle());
    QTest::keyClick(bench.window.get(), Qt::Key_Q, Qt::ControlModifier);
    QVERIFY(bench.window->isVisible());
    auto* box = bench.window->findChild<QMessageBox*>("unsavedBox");
    QVERIFY(box);
    QTest::mouseClick(box->button(QMessageBox::Save), Qt::LeftButton);
    bench.answerFileDialog("saveDialog", bench.folder.filePath("last.graft"));
    QTRY_VERIFY(!bench.window->isVisible());
    const Result<LoadedProject> saved = readProject(bench.folder.filePath("last.graft").toStdString(), {});
    QVERIFY(saved && saved->project.document.fusions.front()->inputs.fcf == FCF::preset(FCF::Preset::Half));
    QVERIFY(saved->project.thumbnail.starts_with("\x89PNG"));
  }

  void anAutosaveComesEveryTwoMinutes() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QCOMPARE(Autosave::kIntervalMs, 120'000);
    const auto timers = bench.window->autosave().findChildren<QTimer*>();
    QCOMPARE(timers.size(), 1);
    QVERIFY(timers.first()->isActive() && !timers.first()->isSingleShot());
    QCOMPARE(timers.first()->interval(), Autosave::kIntervalMs);
    QTest::keyClick(bench.resultPane(), Qt::Key_4, Qt::ShiftModifier);
    QSignalSpy saved(&bench.window->autosave(), &Autosave::autosaved);
    timers.first()->setInterval(1);
    QVERIFY(saved.wait(kPatienceMs));
    QVERIFY(bench.window->isWindowModified());
  }
};

QTEST_MAIN(FilesTest)
#include "files_test.moc"
