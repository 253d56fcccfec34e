#include <QAbstractButton>
#include <QMenu>
#include <QTableView>

#include "app/document/commands.h"
#include "app/workbench/tiles_page.h"
#include "core/project/edits.h"
#include "tests/support/documents.h"
#include "tests/support/panes.h"
#include "tests/support/shapes.h"
#include "tests/support/workbench.h"

using namespace graftsman;

// Tiles mode, with real mouse and keys on the real window.
class TilesTest : public QObject {
  Q_OBJECT

 private:
  struct Tiles : Workbench {
    explicit Tiles(const char* sample = "fig9b_bird_plane") {
      if (!openSample(sample)) {
        qFatal("the sample makes no result");
      }
      QTest::keyClick(window.get(), Qt::Key_F2);
    }
    [[nodiscard]] const Outcome& outcome() const { return *window->findChild<TilesPage*>()->outcome(); }
    [[nodiscard]] QTableView* table() const { return window->findChild<QTableView*>("pairsView"); }
    [[nodiscard]] QString cell(int row, int column) const {
      return table()->model()->index(row, column).data().toString();
    }
    [[nodiscard]] QString undoText() const { return window->model().history()->undoText(); }
    /// What stands below a pane.
    [[nodiscard]] QString verdict(Side side) const {
      return frame(side)->findChild<QLabel*>("problemText")->text();
    }
    [[nodiscard]] QAbstractButton* remedy(Side side) const {
      return frame(side)->findChild<QAbstractButton*>("remedy");
    }
    [[nodiscard]] QWidget* frame(Side side) const {
      return window->findChild<QWidget*>(side == Side::Part ? "partFrame" : "baseFrame");
    }
    /// A vertex of a mesh that is far from the loop's.
    [[nodiscard]] Index farFromLoop(Side side) const {
      Index best = 0;
      double farthest = -1;
      for (Index v = 0; v < mesh(side).vertexCount(); v += 7) {
        double nearest = 1e300;
        for (const CVP& pair : fusion().inputs.loop) {
          const SurfacePoint& at = side == Side::Part ? pair.part : pair.base;
          nearest = std::min(nearest, (mesh(side).point(at.vertex) - mesh(side).point(v)).norm());
        }
        if (nearest > farthest) {
          farthest = nearest;
          best = v;
        }
      }
      return best;
    }
  };

 private Q_SLOTS:
  void hoveringShowsTheVertexThatAClickTakes() {
    Tiles bench;
    bench.action("openLoop")->trigger();
    QVERIFY(bench.settle());
    const Index vertex = bench.farFromLoop(Side::Part);
    const QPoint at = bench.placeOf(Side::Part, vertex);
    MeshPane* pane = bench.pane(Side::Part);
    panes::moveTo(*pane, {2, 2});
    const QImage before = pane->picture();
    QSignalSpy hovered(pane, &MeshPane::vertexHovered);
    panes::moveTo(*pane, at);
    QCOMPARE(hovered.last().first().value<Index>(), vertex);
    QVERIFY(pane->picture() != before);
    QTest::mouseClick(pane, Qt::LeftButton, {}, at);
    // Half made: in the last row the base is missing, and nothing is in the history.
    const int row = static_cast<int>(bench.fusion().inputs.loop.size());
    QCOMPARE(bench.table()->model()->rowCount(), row + 1);
    QCOMPARE(bench.cell(row, 1), QLocale().toString(vertex));
    QCOMPARE(bench.cell(row, 2), QString("–"));
    QVERIFY2(bench.verdict(Side::Base).contains(QString("partner of CV %1").arg(row)),
             qPrintable(bench.verdict(Side::Base)));
    QTest::keyClick(pane, Qt::Key_Escape);
    QCOMPARE(bench.table()->model()->rowCount(), row);
    QCOMPARE(bench.undoText(), QString("Open the loop"));
  }

  void bothPathsOfADraggedCVFollowTheHand() {
    Tiles bench;
    const auto before = bench.outcome().results;
    MeshPane* pane = bench.pane(Side::Base);
    const QPoint from = bench.placeOf(Side::Base, bench.fusion().inputs.loop[2].base.vertex);
    QTest::mousePress(pane, Qt::LeftButton, {}, from);
    panes::moveHeld(*pane, from + QPoint(30, 18), Qt::LeftButton);
    QVERIFY(bench.window->model().dragging());
    QVERIFY(bench.settle());
    // Not let go yet: the two paths beside CV 2 are others, the rest is what it was.
    const auto& now = bench.outcome().results;
    QVERIFY(now->inputs.loop[2].base == bench.fusion().inputs.loop[2].base);
    QVERIFY(!(now->inputs.loop[2].base == before->inputs.loop[2].base));
    const auto& paths = now->base.paths->paths;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const auto& old = before->base.paths->paths[i];
      QCOMPARE(paths[i]->length != old->length, i == 1 || i == 2);
    }
    QVERIFY(now->part.paths == before->part.paths);
    QTest::mouseRelease(pane, Qt::LeftButton, {}, from + QPoint(30, 18));
    QCOMPARE(bench.undoText(), QString("Move CV 2 on the base"));
  }

  void escDuringADragRestores() {
    Tiles bench;
    const auto before = bench.fusion();
    MeshPane* pane = bench.pane(Side::Part);
    const QPoint from = bench.placeOf(Side::Part, before.inputs.loop[1].part.vertex);
    QTest::mousePress(pane, Qt::LeftButton, {}, from);
    panes::moveHeld(*pane, from + QPoint(30, 18), Qt::LeftButton);
    QVERIFY(!(bench.fusion() == before));
    QTest::keyClick(pane, Qt::Key_Escape);
    QVERIFY(bench.fusion() == before);
    QTest::mouseRelease(pane, Qt::LeftButton, {}, from + QPoint(30, 18));
    QCOMPARE(bench.window->model().history()->count(), 0);
  }

  void aClickOnAPathInsertsAPairOnBoth() {
    Tiles bench("fig8b_cone_nose");
    const Outcome& seen = bench.outcome();
    const Path& path = *seen.results->base.paths->paths[1];
    const TriangleMesh& anchored = *seen.results->base.anchored->mesh;
    const Point middle = position(anchored, path.points[path.points.size() / 2]);
    Index nearest = 0;
    for (Index v = 0; v < bench.mesh(Side::Base).vertexCount(); ++v) {
      if ((bench.mesh(Side::Base).point(v) - middle).norm() <
          (bench.mesh(Side::Base).point(nearest) - middle).norm()) {
        nearest = v;
      }
    }
    (void)bench.placeOf(Side::Base, nearest);
    const std::size_t pairs = bench.fusion().inputs.loop.size();
    QTest::mouseClick(bench.pane(Side::Base), Qt::LeftButton, {},
                      bench.pane(Side::Base)->screenPosition(middle).toPoint());
    QCOMPARE(bench.fusion().inputs.loop.size(), pairs + 1);
    QCOMPARE(bench.undoText(), QString("Insert pair 2"));
    QVERIFY(bench.settle());
    QVERIFY(bench.window->fusionPage().shown()->inputs.loop.size() == pairs + 1);
    QCOMPARE(bench.table()->selectionModel()->selectedRows().first().row(), 2);
  }

  void aClickOnCV0ClosesTheLoop() {
    Tiles bench;
    QTest::keyClick(bench.window.get(), Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!bench.fusion().closed);
    bench.clickVertex(Side::Base, bench.fusion().inputs.loop[0].base.vertex);
    QVERIFY(bench.fusion().closed);
    QCOMPARE(bench.undoText(), QString("Close the loop"));
    QVERIFY(bench.settle());
    QVERIFY(bench.verdict(Side::Base).contains("disk"));
  }

  void aClickOnACVSelectsItsRowAndDeleteRemovesIt() {
    Tiles bench;
    const auto before = bench.fusion();
    bench.clickVertex(Side::Part, before.inputs.loop[3].part.vertex);
    QCOMPARE(bench.table()->selectionModel()->selectedRows().first().row(), 3);
    QTest::keyClick(bench.pane(Side::Part), Qt::Key_Delete);
    QVERIFY(bench.fusion() == edits::removePairs(before, {3}));
    QCOMPARE(bench.undoText(), QString("Remove pair 3"));
  }

  void reverseShiftAndMirrorHaveKeysAndSpaceRepeats() {
    Tiles bench;
    const auto before = bench.fusion();
    QWidget* pane = bench.pane(Side::Part);
    QTest::keyClick(pane, Qt::Key_R);
    QVERIFY(bench.fusion() == edits::reverseLoop(before));
    QCOMPARE(bench.undoText(), QString("Reverse the loop"));
    QTest::keyClick(pane, Qt::Key_Space);
    QVERIFY(bench.fusion() == before);
    QTest::keyClick(pane, Qt::Key_M);
    QVERIFY(bench.fusion() == edits::mirrorCorrespondence(before));
    QTest::keyClick(pane, Qt::Key_T);
    QVERIFY(bench.fusion() == edits::shiftCorrespondence(edits::mirrorCorrespondence(before)));
    QCOMPARE(bench.undoText(), QString("Shift the correspondence"));
  }

  void pairsAreMadeByKeyboardAlone() {
    Tiles bench("fig4c_cone_sphere");
    QTest::keyClick(bench.window.get(), Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(bench.fusion().inputs.loop.empty());
    const std::array<Qt::Key, 3> ways = {Qt::Key_Up, Qt::Key_Right, Qt::Key_Down};
    for (const Qt::Key way : ways) {
      for (const Side side : {Side::Part, Side::Base}) {
        bench.pane(side)->setFocus(Qt::TabFocusReason);
        for (int i = 0; i < 3; ++i) {
          QTest::keyClick(bench.pane(side), way);
        }
        QTest::keyClick(bench.pane(side), Qt::Key_Return);
      }
    }
    QCOMPARE(bench.fusion().inputs.loop.size(), std::size_t{3});
    // The mouse has moved since: Enter closes.
    panes::moveTo(*bench.pane(Side::Base), {3, 3});
    QTest::keyClick(bench.pane(Side::Base), Qt::Key_Return);
    QVERIFY(bench.fusion().closed);
  }

  void aDoubleClickTurnsTheViewAboutThePlaceAndPicksNothing() {
    Tiles bench;
    bench.action("openLoop")->trigger();
    const Index vertex = bench.farFromLoop(Side::Part);
    const QPoint at = bench.placeOf(Side::Part, vertex) + QPoint(12, 9);
    MeshPane* pane = bench.pane(Side::Part);
    const int rows = bench.table()->model()->rowCount();
    QTest::mouseClick(pane, Qt::LeftButton, {}, at);
    QTest::mouseDClick(pane, Qt::LeftButton, {}, at);
    const Camera camera = pane->camera();
    QVERIFY((pane->screenPosition(camera.pivot) - QPointF(pane->rect().center())).manhattanLength() < 3);
    QVERIFY((camera.pivot - bench.mesh(Side::Part).point(vertex)).norm() <
            0.2 * bench.mesh(Side::Part).diagonal());
    QCOMPARE(bench.table()->model()->rowCount(), rows);
  }

  void theRightButtonOnlyOpensTheMenu() {
    Tiles bench;
    MeshPane* pane = bench.pane(Side::Base);
    const Camera before = pane->camera();
    auto* menu = bench.window->findChild<QMenu*>("fusionMenu");
    panes::drag(*pane, {60, 60}, {160, 90}, Qt::RightButton);
    QVERIFY(!menu->isVisible() && pane->camera() == before);
    QTest::mouseClick(pane, Qt::RightButton, {}, {60, 60});
    QVERIFY(menu->isVisible());
    menu->close();
  }

  void aLoopRoundAHandleSaysSoAndOffersTheRemedy() {
    Workbench empty;
    auto fusion = samples::fusion("fig4c_cone_sphere");
    const auto torus = shapes::torus(40, 30);
    fusion.base = std::make_shared<const MeshAsset>(MeshAsset{"ring", "ring.ply", {}, torus});
    fusion.inputs.base = torus;
    fusion.inputs.loop.resize(4);
    // Clockwise round a patch: what is left of the loop is all of the ring with its handle.
    const std::array<Index, 4> corners = {5 * 30 + 5, 5 * 30 + 10, 10 * 30 + 10, 10 * 30 + 5};
    for (std::size_t i = 0; i < 4; ++i) {
      fusion.inputs.loop[i].base = SurfacePoint::atVertex(corners[i]);
    }
    empty.window->model().reset(fusion);
    empty.window->setMode(MainWindow::Mode::Tiles);
    QVERIFY(empty.settle());
    auto* frame = empty.window->findChild<QWidget*>("baseFrame");
    const QString said = frame->findChild<QLabel*>("problemText")->text();
    QVERIFY2(said.contains("handle") && said.contains("clockwise"), qPrintable(said));
    auto* remedy = frame->findChild<QAbstractButton*>("remedy");
    QCOMPARE(remedy->text(), QString("Reverse the loop"));
    QTest::mouseClick(remedy, Qt::LeftButton);
    QVERIFY(empty.fusion() == edits::reverseLoop(fusion));
    QVERIFY(empty.settle());
    QVERIFY(!frame->findChild<QLabel*>("problemText")->text().contains("handle"));
  }

  void aLoopThatCrossesItselfSaysWhereAndShowsIt() {
    Workbench bench;
    auto fusion = samples::fusion("fig4c_cone_sphere");
    constexpr Index n = 12;
    const auto grid = shapes::grid(n);
    fusion.base = std::make_shared<const MeshAsset>(MeshAsset{"sheet", "sheet.ply", {}, grid});
    fusion.inputs.base = grid;
    fusion.inputs.loop.resize(4);
    // The corners of a sheet, two of them exchanged.
    const std::array<Index, 4> corners = {0, (n + 1) * (n + 1) - 1, n, n * (n + 1)};
    for (std::size_t i = 0; i < 4; ++i) {
      fusion.inputs.loop[i].base = SurfacePoint::atVertex(corners[i]);
    }
    bench.window->model().reset(fusion);
    bench.window->setMode(MainWindow::Mode::Tiles);
    QVERIFY(bench.settle());
    auto* frame = bench.window->findChild<QWidget*>("baseFrame");
    const QString said = frame->findChild<QLabel*>("problemText")->text();
    QVERIFY2(said.contains("crosses path") && said.contains("Move CV"), qPrintable(said));
    // The same in the rows of the pairs concerned.
    auto* table = bench.window->findChild<QTableView*>("pairsView");
    int concerned = 0;
    for (int row = 0; row < 4; ++row) {
      concerned += table->model()->index(row, 5).data().toString() == said ? 1 : 0;
    }
    QVERIFY(concerned >= 3);
    auto* remedy = frame->findChild<QAbstractButton*>("remedy");
    QVERIFY2(remedy->isVisible() && remedy->text().startsWith("Show CV "), qPrintable(remedy->text()));
    QTest::mouseClick(remedy, Qt::LeftButton);
    const int shown = remedy->text().section(' ', -1).toInt();
    QVERIFY(said.contains(QString("Move CV %1").arg(shown)));
    QCOMPARE(table->selectionModel()->selectedRows().first().row(), shown);
  }

  void anUndoScrollsToWhatItChangedAndFlashesItOnce() {
    Tiles bench;
    const auto before = bench.fusion();
    bench.window->model().push(std::make_unique<MoveCVP>(
        bench.window->model(), *edits::moveCV(before, 2, Side::Base, SurfacePoint::atVertex(0)), 2,
        Side::Base));
    QVERIFY(bench.settle());
    // The CV's place is on the far side.
    MeshPane* pane = bench.pane(Side::Base);
    const Index vertex = before.inputs.loop[2].base.vertex;
    (void)bench.placeOf(Side::Base, vertex);
    const Camera near = pane->camera();
    pane->setCamera({2 * near.pivot - near.position, near.pivot, near.up, near.axis});
    const Camera part = bench.pane(Side::Part)->camera();
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.status(), QString("Undone: Move CV 2 on the base"));
    const QPoint at = pane->screenPosition(bench.mesh(Side::Base).point(vertex)).toPoint();
    QVERIFY(pane->rect().contains(at));
    QCOMPARE(pane->pickAt(at, false), std::optional(SurfacePoint::atVertex(vertex)));
    QVERIFY(bench.pane(Side::Part)->camera() == part);
    auto* flash = bench.table()->findChild<QWidget*>("flash");
    QVERIFY(flash && flash->geometry().contains(
                         bench.table()->visualRect(bench.table()->model()->index(2, 0)).center()));
    QSignalSpy gone(flash, &QObject::destroyed);
    QVERIFY(gone.wait());
    // Camera moves are not in the history.
    QCOMPARE(bench.window->model().history()->count(), 1);
  }
};

QTEST_MAIN(TilesTest)
#include "tiles_test.moc"
