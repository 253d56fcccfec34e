#include "app/workbench/sweep_dialog.h"
#include <QCheckBox>
#include <QDir>
#include <QMessageBox>
#include <QPushButton>

#include "app/document/document_commands.h"
#include "core/sweep/sweep_folder.h"
#include "core/sweep/sweep_run.h"
#include "tests/support/gallery.h"
#include "tests/support/stacked.h"
#include "tests/support/sweep_hands.h"

using namespace graftsman;

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

  void whatCannotBeRunSaysWhy() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_1, Qt::ShiftModifier);  // the present curve is Linear
    QVERIFY(bench.settle());
    const SweepHands hands{bench};
    hands.open();
    auto* run = hands.the<QPushButton>("sweepRun");
    const std::pair<const char*, const char*> lines[] = {
        {"1, two", "“two” is no number"},
        {"1, inf", "“inf” is no number"},
        {"1, 0", "“0” is no falloff. Write numbers greater than 0."},
        {"-2.5 1", "“-2.5” is no falloff. Write numbers greater than 0."},
        {"3 3.0", "“3.0” is among the falloffs twice. Write it once."}};
    for (const auto& [typed, said] : lines) {
      hands.type("sweepFalloffs", typed);
      QVERIFY2(hands.problem().contains(said), qPrintable(hands.problem()));
      QVERIFY(!hands.problem().contains("deform_exponent"));
      QVERIFY(!run->isEnabled());
    }
    QStringList many;
    for (int i = 1; i <= 1001; ++i) {
      many.append(QString::number(i));
    }
    hands.the<QLineEdit>("sweepFalloffs")->setText(many.join(' '));
    QVERIFY2(hands.problem().contains("more variants than 1000"), qPrintable(hands.problem()));
    QVERIFY(!run->isEnabled());
    // 1001 × 3 curves × 4 embeddings × 4 adjustments × 3 shifts.
    const auto tickMore = [&] {
      hands.click("sweepCurves", {"Paste", "Half"});
      hands.click("sweepEmbeddings", {"Cotangent", "Mean value", "Low stretch"});
      hands.click("sweepAdjustments", {"Without line field", "Rigid only", "Without exact fit"});
      hands.click("sweepShifts", {"1", "2"});
    };
    tickMore();
    QVERIFY2(hands.problem().contains("More than 100000 would be more variants than 1000."),
             qPrintable(hands.problem()));
    tickMore();  // no more
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
