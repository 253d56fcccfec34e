#include "core/sweep/sweep_run.h"
#include <QDir>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>

#include "app/document/document_commands.h"
#include "app/workbench/sweep_dialog.h"
#include "core/sweep/sweep_folder.h"
#include "tests/support/gallery.h"
#include "tests/support/stacked.h"
#include "tests/support/sweep_hands.h"

using namespace graftsman;

class SweepRunTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
};

QTEST_MAIN(SweepRunTest)
#include "sweep_run_test.moc"
