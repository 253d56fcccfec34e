#include <QMenu>
#include <QTreeView>

#include "app/document/commands.h"
#include "core/project/edits.h"
#include "core/project/evaluate.h"
#include "tests/support/fusions_bench.h"
#include "tests/support/stacked.h"
#include "tests/support/workbench.h"
#include "widgets/panels/elided_label.h"
#include "widgets/panels/fusion_tree_panel.h"
#include "widgets/panels/pairs_model.h"

using namespace graftsman;

class FusionsShownTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theWindowWorksWhileAResultIsStillBeingComputed() {
    Bench bench;
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    for (int round = 0; round < 3; ++round) {
      bench.model().show(1);
      bench.action("runAdjustment")->trigger();
      bench.action(round % 2 == 0 ? "half" : "linear")->trigger();
      bench.action("fuseOnto")->trigger();
      QVERIFY(!bench.fusion().inputs.part);
      bench.window->lookAtFirst();
      for (QAction* action : bench.window->actions().all()) {
        const QString name = action->objectName();
        const bool asks = name == "quit" || action->text().contains("…") || name == "newProject" ||
                          name == "save" || name == "shortcuts" || name == "about" || name == "cancel";
        if (action->isEnabled() && !asks) {
          action->trigger();
        }
      }
      bench.model().history()->setIndex(0);
      bench.model().history()->setIndex(bench.model().history()->count());
    }
    bench.model().show(1);
    QVERIFY(bench.settle());
    QVERIFY(bench.showsTheResult());
  }

  void aFusionWhoseRunIsOvertakenByAnotherIsNotShownForIt() {
    Bench bench;
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    bench.model().reset(samples::twoConesOnASphere(), 2);
    for (int i = 0; i < 20; ++i) {
      bench.model().show(1 + i % 2);
      QVERIFY(!bench.window->fusionPage().shown());
      if (i % 3 == 0) {
        QVERIFY(bench.settle());
        QVERIFY(bench.showsTheResult());
      }
    }
    QVERIFY(bench.settle());
    QVERIFY(bench.showsTheResult());
  }

  void aResultIsTakenAsAPartFromTheMenuAndACircleIsRefused() {
    Bench bench;
    bench.model().reset(samples::twoConesOnASphere(), 2);
    QVERIFY(bench.settle());
    bench.action("newFusion")->trigger();
    QCOMPARE(bench.model().shown(), 3);
    QVERIFY(!bench.fusion().part && !bench.fusion().base);
    const auto take = [&](const char* name, int entry) {
      QMenu* menu = bench.window->actions().menu(name);
      Q_EMIT menu->aboutToShow();
      menu->actions().at(entry)->trigger();
    };
    take("takePartMenu", 1);
    QCOMPARE(bench.fusion().upstream(Side::Part), 2);
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().inputs.part);
    QCOMPARE(bench.model().history()->undoText(), QString("Take “part on part on base” as the part"));
    // Fusion 1 of fusion 3 would be a circle.
    bench.model().show(1);
    const Document before = bench.model().document();
    take("takeBaseMenu", 1);
    QVERIFY(bench.model().document() == before);
    QVERIFY2(bench.status().contains("is itself made of"), qPrintable(bench.status()));
  }

  void theContextMenuOfARowActsOnThatFusion() {
    Bench bench;
    bench.model().reset(samples::twoConesOnASphere(), 2);
    QVERIFY(bench.settle());
    bench.action("newFusion")->trigger();
    const auto choose = [&](FusionId row, const QString& text) {
      bench.raiseTree();
      QTreeView* view = bench.tree()->view();
      const QPoint at = view->visualRect(bench.tree()->model()->find(row)).center();
      QContextMenuEvent event(QContextMenuEvent::Mouse, at, view->viewport()->mapToGlobal(at));
      QApplication::sendEvent(view->viewport(), &event);
      auto* menu = bench.window->findChild<QMenu*>("fusionsMenu");
      QVERIFY(menu && menu->isVisible());
      const QList<QAction*> entries = menu->actions();
      const auto entry = std::ranges::find(entries, text, &QAction::text);
      QVERIFY2(entry != entries.end(), qPrintable(text));
      (*entry)->trigger();
      menu->close();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    choose(2, "Take as the part of “Fusion 3”");
    QCOMPARE(bench.fusion().upstream(Side::Part), 2);
    choose(1, "Take as the base of “Fusion 3”");
    QCOMPARE(bench.fusion().upstream(Side::Base), 1);
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().inputs.part && bench.fusion().inputs.base);
    choose(1, "Show");
    QCOMPARE(bench.model().shown(), 1);
    choose(2, "Remove");
    QVERIFY(!find(bench.fusions(), 2));
    QCOMPARE(bench.model().shown(), 1);
    choose(1, "Fuse onto this result");
    QCOMPARE(bench.fusion().upstream(Side::Base), 1);
    QVERIFY(bench.settle());
    // The last one that goes leaves an empty one.
    while (bench.fusions().size() > 1 || bench.fusion().base) {
      bench.action("removeFusion")->trigger();
    }
    QVERIFY(!bench.action("removeFusion")->isEnabled());
    QVERIFY(bench.settle());
  }

  void aFusionIsSeenAgainAsItWasLeft() {
    Bench bench;
    bench.model().reset(samples::twoConesOnASphere(), 2);
    bench.window->setMode(MainWindow::Mode::Tiles);
    QVERIFY(bench.settle());
    const Camera camera{Point(1, 2, 3), Point(0.1, 0, 0), Eigen::Vector3d::UnitZ()};
    bench.pane(Side::Base)->setCamera(camera);
    bench.clickRow(1);
    QVERIFY(bench.settle());
    QVERIFY(!(bench.pane(Side::Base)->camera() == camera));
    bench.action("half")->trigger();
    bench.clickRow(2);
    QVERIFY(bench.settle());
    QVERIFY(bench.pane(Side::Base)->camera() == camera);
  }
};

QTEST_MAIN(FusionsShownTest)
#include "fusions_shown_test.moc"
