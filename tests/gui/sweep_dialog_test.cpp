#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QListWidget>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>

#include "app/document/document_commands.h"
#include "app/workbench/sweep_dialog.h"
#include "core/sweep/sweep_folder.h"
#include "core/sweep/sweep_run.h"
#include "tests/support/gallery.h"
#include "tests/support/stacked.h"

using namespace graftsman;

namespace {

/// The dialog under a test's hands.
struct SweepHands {
  const Workbench& bench;

  void open() const {
    QTest::keyClick(bench.window.get(), Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
    if (!QTest::qWaitForWindowExposed(dialog())) {
      qFatal("no dialog");
    }
  }
  [[nodiscard]] SweepDialog* dialog() const { return bench.window->findChild<SweepDialog*>("sweepDialog"); }
  template <class T>
  [[nodiscard]] T* the(const char* name) const {
    return dialog()->findChild<T*>(name);
  }
  [[nodiscard]] QString count() const { return the<QLabel>("sweepCount")->text(); }
  [[nodiscard]] QString summary() const { return the<QLabel>("sweepSummary")->text(); }
  [[nodiscard]] QString problem() const {
    QStringList texts;
    for (const QLabel* label : dialog()->findChild<QWidget*>("sweepProblem")->findChildren<QLabel*>()) {
      texts.append(label->text());
    }
    return texts.join(' ');
  }

  /// Clicks on the box of each of these entries, which begin so.
  void click(const char* list, const QStringList& entries) const {
    auto* view = the<QListWidget>(list);
    for (const QString& entry : entries) {
      const auto found = view->findItems(entry, Qt::MatchStartsWith);
      if (found.size() != 1) {
        qFatal("%s has %d of %s", list, static_cast<int>(found.size()), qPrintable(entry));
      }
      view->scrollToItem(found.front());
      const Qt::CheckState before = found.front()->checkState();
      const QRect rect = view->visualItemRect(found.front());
      QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, QPoint(rect.left() + 9, rect.center().y()));
      if (found.front()->checkState() == before) {
        qFatal("%s is not hit", qPrintable(entry));
      }
    }
  }
  void type(const char* line, const QString& text) const {
    auto* edit = the<QLineEdit>(line);
    QTest::mouseClick(edit, Qt::LeftButton);
    edit->clear();
    QTest::keyClicks(edit, text);
  }
  void press(const char* button) const { QTest::mouseClick(the<QPushButton>(button), Qt::LeftButton); }
  [[nodiscard]] bool done() const {
    return QTest::qWaitFor([this] { return !dialog()->busy(); }, kPatienceMs);
  }
  /// Files to be written there, meshes as PLY, without pictures.
  void writeTo(const QString& folder) const {
    auto* files = the<QCheckBox>("sweepFiles");
    if (!files->isChecked()) {
      QTest::mouseClick(files, Qt::LeftButton, {}, QPoint(8, files->height() / 2));
      auto* pictures = the<QCheckBox>("sweepPictures");
      QTest::mouseClick(pictures, Qt::LeftButton, {}, QPoint(8, pictures->height() / 2));
    }
    type("sweepFolder", folder);
  }
};

QStringList names(const VariantList& variants) {
  QStringList names;
  for (const auto& variant : variants) {
    names.append(QString::fromStdString(variant->name));
  }
  return names;
}

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable " + path.toUtf8());
}

}  // namespace

class SweepDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theResultsBecomeVariantsInOneStep() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_1, Qt::ShiftModifier);  // the present curve is Linear
    QVERIFY(bench.settle());
    const FusionInputs before = bench.fusion().inputs;
    QUndoStack& history = *bench.window->model().history();
    const int steps = history.count();
    const SweepHands hands{bench};
    hands.open();
    QVERIFY(!hands.dialog()->isModal());
    QVERIFY(!hands.the<QPushButton>("sweepRun")->isEnabled());
    QCOMPARE(hands.count(), QString("Nothing is varied yet"));

    hands.click("sweepCurves", {"Paste", "Half"});  // Linear is ticked
    QCOMPARE(hands.count(), QString("3 curves = 3 results"));
    hands.click("sweepCurves", {"Linear (now)"});
    hands.type("sweepFalloffs", "2, 5.5");
    hands.click("sweepShifts", {"1"});
    QCOMPARE(hands.count(), QString("2 curves × 2 falloffs × 2 shifts = 8 results"));
    hands.press("sweepRun");
    QVERIFY(hands.done());

    const VariantList& variants = bench.window->model().document().variants;
    QCOMPARE(names(variants), (QStringList{"Paste, falloff 2, shift 0", "Half, falloff 2, shift 0",
                                           "Paste, falloff 5.5, shift 0", "Half, falloff 5.5, shift 0",
                                           "Paste, falloff 2, shift 1", "Half, falloff 2, shift 1",
                                           "Paste, falloff 5.5, shift 1", "Half, falloff 5.5, shift 1"}));
    Sweep sweep;
    sweep.base = before;
    sweep.shifts = {0, 1};
    sweep.falloffs = {2, 5.5};
    sweep.curves = {{"Paste", FCF::preset(FCF::Preset::Paste)}, {"Half", FCF::preset(FCF::Preset::Half)}};
    // Combinations count shifts before falloffs before curves.
    for (std::size_t i = 0; i < variants.size(); ++i) {
      QVERIFY(same(variants[i]->fusions.front()->inputs, sweep.inputs(i)));
    }
    QVERIFY(same(bench.fusion().inputs, before));
    QCOMPARE(hands.summary(), QString("8 results are variants now."));
    QCOMPARE(history.count(), steps + 1);
    QCOMPARE(history.undoText(), QString("Sweep: 8 variants"));
    history.undo();
    QVERIFY(bench.window->model().document().variants.empty());
    history.redo();
    QCOMPARE(variants.size(), std::size_t{8});
    // The same again: names of their own.
    hands.press("sweepRun");
    QVERIFY(hands.done());
    QCOMPARE(variants.size(), std::size_t{16});
    QCOMPARE(names(variants)[8], QString("Paste, falloff 2, shift 0 2"));
    bench.window->setMode(MainWindow::Mode::Variants);
    QVERIFY(GalleryHands{bench}.drawn());
  }

  void theFolderIsAsCoreWritesIt() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_1, Qt::ShiftModifier);
    QVERIFY(bench.settle());
    const SweepHands hands{bench};
    hands.open();
    hands.click("sweepCurves", {"Paste"});
    hands.click("sweepAdjustments", {"Rigid only"});
    auto* files = hands.the<QCheckBox>("sweepFiles");
    QTest::mouseClick(files, Qt::LeftButton, {}, QPoint(8, files->height() / 2));
    QVERIFY(hands.problem().contains("Choose a folder"));
    QVERIFY(!hands.the<QPushButton>("sweepRun")->isEnabled());
    const QString folder = bench.folder.filePath("results");
    hands.type("sweepFolder", folder);
    hands.press("sweepRun");
    QVERIFY(hands.done());
    QCOMPARE(bench.window->model().document().variants.size(), std::size_t{4});

    Sweep sweep;
    sweep.base = bench.fusion().inputs;
    sweep.curves = {{"Linear", FCF::preset(FCF::Preset::Linear)}, {"Paste", FCF::preset(FCF::Preset::Paste)}};
    AdjustmentSettings rigid = sweep.base.adjustment;
    rigid.scale = rigid.lineField = false;
    sweep.adjustments = {{"All steps", sweep.base.adjustment}, {"Rigid only", rigid}};
    SweepOutput output;
    output.picture = SweepPicture();
    const auto loaded = std::make_shared<const LoadedSweep>(
        loadSweep(sweep, output, bench.fusion().base->report.format == MeshFormat::Obj).value());
    const QString wanted = bench.folder.filePath("wanted");
    auto core = SweepFolder::open(wanted.toStdString(), loaded, {});
    SweepRun run(std::shared_ptr<const Sweep>(loaded, &loaded->sweep));
    for (const std::size_t number : runOrder(loaded->sweep)) {
      QVERIFY(core->add(run.run(number, {}), {}));
    }
    QVERIFY(core->writeTable());
    const QStringList written = QDir(folder).entryList(QDir::Files);
    QCOMPARE(written, QDir(wanted).entryList(QDir::Files));
    QCOMPARE(written.size(), 9);  // four meshes, four pictures, the table
    for (const QString& name : written) {
      QVERIFY2(bytesOf(folder + '/' + name) == bytesOf(wanted + '/' + name), qPrintable(name));
    }

    // Once more: it asks, and without a yes nothing is touched.
    QVERIFY(QFile::remove(folder + "/table.csv"));
    const auto answer = [&](const char* button) {
      hands.press("sweepRun");
      auto* box = hands.the<QMessageBox>("sweepFolderBox");
      QVERIFY(box && QTest::qWaitForWindowExposed(box));
      QTest::mouseClick(box->findChild<QPushButton*>(button), Qt::LeftButton);
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      QVERIFY(hands.done());
    };
    answer("sweepKeepFolder");
    QVERIFY(!QFile::exists(folder + "/table.csv"));
    QCOMPARE(bench.window->model().document().variants.size(), std::size_t{4});
    answer("sweepOverwrite");
    QCOMPARE(bytesOf(folder + "/table.csv"), bytesOf(wanted + "/table.csv"));
    QCOMPARE(bench.window->model().document().variants.size(), std::size_t{8});
  }

  void aFolderThatCannotBeWrittenIsTold() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const SweepHands hands{bench};
    hands.open();
    hands.click("sweepCurves", {"Half"});
    const QString file = bench.folder.filePath("file");
    QVERIFY(QFile(file).open(QIODevice::WriteOnly));
    hands.writeTo(file);
    hands.press("sweepRun");
    QVERIFY(hands.done());
    QVERIFY2(hands.summary().contains("is no folder"), qPrintable(hands.summary()));
    QVERIFY(bench.window->model().document().variants.empty());
  }

  void cancelKeepsWhatIsDone() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const SweepHands hands{bench};
    hands.open();
    QStringList falloffs;
    for (int i = 1; i <= 200; ++i) {
      falloffs.append(QString::number(i));
    }
    hands.type("sweepFalloffs", falloffs.join(','));
    QCOMPARE(hands.count(), QString("200 falloffs = 200 results"));
    const QString folder = bench.folder.filePath("results");
    hands.writeTo(folder);
    auto* bar = hands.the<QProgressBar>("sweepProgress");
    hands.press("sweepRun");
    const int of = bar->format().section(' ', -1).toInt();
    QCOMPARE(of, 200);
    QVERIFY(QTest::qWaitFor([&] { return bar->format().section(' ', 0, 0).toInt() >= 2; }, kPatienceMs));
    QVERIFY(bench.action("cancel")->isEnabled());
    hands.press("sweepCancel");
    QVERIFY(hands.done());
    const auto kept = static_cast<int>(bench.window->model().document().variants.size());
    QVERIFY2(kept >= 2 && kept < of, qPrintable(QString::number(kept)));
    QVERIFY2(hands.summary().startsWith(QString("Stopped after %1 of %2.").arg(kept).arg(of)),
             qPrintable(hands.summary()));
    // The table has what is done, and so has the folder.
    QCOMPARE(bytesOf(folder + "/table.csv").count('\n'), kept + 1);
    QCOMPARE(QDir(folder).entryList({"*.ply"}).size(), kept);
    QVERIFY(!bar->isVisible() && hands.the<QPushButton>("sweepRun")->isEnabled());
  }

  void aCombinationThatDoesNotFuseIsListed() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    DocumentModel& model = bench.window->model();
    Fusion twice = model.committed();
    twice.inputs.loop[1].part = twice.inputs.loop[3].part;
    model.push(std::make_unique<AddVariant>(model, FusionList{std::make_shared<const Fusion>(twice)},
                                            model.shown(), "Twice"));
    const std::optional<Error> error = update(twice.inputs, {}, {}).error;
    QVERIFY(error);
    const SweepHands hands{bench};
    hands.open();
    hands.click("sweepParts", {"cone of Twice"});
    hands.click("sweepEmbeddings", {"Mean value"});
    QCOMPARE(hands.count(), QString("2 parts × 2 embeddings = 4 results"));
    hands.press("sweepRun");
    QVERIFY(hands.done());
    QCOMPARE(names(model.document().variants), (QStringList{"Twice", "cone, Automatic", "cone, Mean value"}));
    auto* failures = hands.the<QTreeWidget>("sweepFailures");
    QVERIFY(failures->isVisible());
    QCOMPARE(failures->topLevelItemCount(), 2);
    QCOMPARE(failures->topLevelItem(0)->text(0), QString("cone of Twice, Automatic"));
    QCOMPARE(failures->topLevelItem(0)->text(1), QString::fromStdString(error->message));
    QVERIFY(hands.summary().contains("2 do not fuse"));
  }

  void aFusionOfAnotherFusionsResultIsVaried() {
    Workbench bench;
    const Document document = samples::twoConesOnASphere();
    bench.window->model().reset(document, 2);
    QVERIFY(bench.settle());
    const SweepHands hands{bench};
    hands.open();
    hands.click("sweepCurves", {"Half"});
    hands.click("sweepShifts", {"1"});
    const int of = hands.count().section(' ', -2, -2).toInt();
    hands.press("sweepRun");
    QVERIFY(hands.done());
    QVERIFY2(of >= 2, qPrintable(hands.count()));
    const VariantList& variants = bench.window->model().document().variants;
    QCOMPARE(static_cast<int>(variants.size()), of);
    for (const auto& variant : variants) {
      QCOMPARE(variant->shown, 2);
      QCOMPARE(variant->fusions.size(), std::size_t{2});
      QCOMPARE(variant->fusions[0], bench.window->model().document().fusions[0]);  // no copy
      QCOMPARE(variant->fusions[1]->upstream(Side::Base), 1);
      Evaluated known;
      const Evaluation evaluation = evaluate(variant->fusions, 2, known, {});
      QVERIFY(evaluation.results.fused && !evaluation.results.error);
    }
    const Fusion& last = *variants.back()->fusions[1];
    QVERIFY(last.inputs.loop[1].part == find(document.fusions, 2)->inputs.loop[0].part);
    QVERIFY(last.inputs.loop[1].base == find(document.fusions, 2)->inputs.loop[1].base);
  }

  void anEditMeanwhileChangesNothingOfTheRun() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const FusionInputs before = bench.fusion().inputs;
    const SweepHands hands{bench};
    hands.open();
    hands.type("sweepFalloffs", "1 2 3 4");
    hands.press("sweepRun");
    QVERIFY(hands.dialog()->busy());
    bench.action("half")->trigger();
    bench.action("shift")->trigger();
    QVERIFY(hands.done() && bench.settle());
    const VariantList& variants = bench.window->model().document().variants;
    QCOMPARE(variants.size(), std::size_t{4});
    for (std::size_t i = 0; i < variants.size(); ++i) {
      FusionInputs wanted = before;
      wanted.adjustment.falloff = static_cast<double>(i + 1);
      QVERIFY(same(variants[i]->fusions.front()->inputs, wanted));
    }
    QVERIFY(!same(bench.fusion().inputs, before));
  }

  void aDragUnderWayIsOneStepAndTheVariantsAreTheNext() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    DocumentModel& model = bench.window->model();
    const SweepHands hands{bench};
    hands.open();
    hands.type("sweepFalloffs", "1 2");
    hands.press("sweepRun");
    Fusion dragged = model.committed();
    dragged.inputs.fcf = FCF::preset(FCF::Preset::Half);
    model.drag(dragged);
    QVERIFY(hands.done());
    QVERIFY(model.dragging());
    QVERIFY(model.document().variants.empty());
    model.push(std::make_unique<SetFCFPreset>(model, FCF::Preset::Half));
    QTRY_COMPARE(model.document().variants.size(), std::size_t{2});
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::Half));
    QVERIFY(!(model.document().variants.front()->fusions.front()->inputs.fcf == bench.fusion().inputs.fcf));
    model.history()->undo();
    QVERIFY(model.document().variants.empty());
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::Half));
  }

  void anotherDocumentAndAClosedWindowEndTheRun() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const SweepHands hands{bench};
    hands.open();
    hands.type("sweepFalloffs", "1 2 3 4 5 6 7 8 9");
    hands.press("sweepRun");
    QVERIFY(hands.dialog()->busy());
    bench.action("newProject")->trigger();
    QVERIFY(hands.done());
    QVERIFY(bench.window->model().document().variants.empty());
    QVERIFY(bench.window->model().history()->isClean());
    QVERIFY2(hands.problem().contains("nothing to vary yet"), qPrintable(hands.problem()));

    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTRY_VERIFY(hands.the<QPushButton>("sweepRun")->isEnabled());
    hands.press("sweepRun");
    QVERIFY(hands.dialog()->busy());
    bench.window->close();
    QVERIFY(hands.done());
    QVERIFY(bench.window->model().document().variants.empty());
  }

  void whatCannotBeRunSaysWhy() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const SweepHands hands{bench};
    hands.open();
    auto* run = hands.the<QPushButton>("sweepRun");
    const std::pair<const char*, const char*> lines[] = {
        {"1, two", "“two” is no number"}, {"1, 0", "greater than 0"}, {"3 3", "twice"}};
    for (const auto& [typed, said] : lines) {
      hands.type("sweepFalloffs", typed);
      QVERIFY2(hands.problem().contains(said), qPrintable(hands.problem()));
      QVERIFY(!run->isEnabled());
    }
    QStringList many;
    for (int i = 1; i <= 1001; ++i) {
      many.append(QString::number(i));
    }
    hands.the<QLineEdit>("sweepFalloffs")->setText(many.join(' '));
    QVERIFY2(hands.problem().contains("more variants than 1000"), qPrintable(hands.problem()));
    QVERIFY(!run->isEnabled());
    hands.the<QLineEdit>("sweepFalloffs")->setText("1 2");
    QVERIFY(run->isEnabled());
    bench.action("openLoop")->trigger();
    QTRY_VERIFY(!run->isEnabled());
    QVERIFY(hands.problem().contains("loop is open"));
  }

  void everyWidgetOfItHasItsNamesAndTooltip() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const SweepHands hands{bench};
    hands.open();
    for (const QWidget* widget : hands.dialog()->findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus ||
          widget->objectName().startsWith("qt_")) {
        continue;
      }
      QVERIFY2(!widget->objectName().isEmpty(), widget->metaObject()->className());
      if (widget->inherits("QAbstractButton")) {
        QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
      } else {
        QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->objectName()));
      }
    }
  }
};

QTEST_MAIN(SweepDialogTest)
#include "sweep_dialog_test.moc"
