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

namespace {

// Eight vertices of the mesh on a circle about `centre`, counter-clockwise seen from outside.
std::vector<Index> ring(const TriangleMesh& mesh, Index centre, double radius) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Index h = mesh.outgoing(centre);
  const Index first = h;
  do {
    const Face& face = mesh.face(TriangleMesh::faceOf(h));
    normal += (mesh.point(face[1]) - mesh.point(face[0])).cross(mesh.point(face[2]) - mesh.point(face[0]));
    h = mesh.twin(TriangleMesh::prev(h));
  } while (h >= 0 && h != first);
  normal.normalize();
  const Eigen::Vector3d a = normal.unitOrthogonal();
  const Eigen::Vector3d b = normal.cross(a);
  std::vector<Index> vertices;
  for (int i = 0; i < 8; ++i) {
    const double angle = EIGEN_PI / 4 * i;
    SurfacePoint point = SurfacePoint::atVertex(0);
    point.place = mesh.point(centre) + radius * (std::cos(angle) * a + std::sin(angle) * b);
    vertices.push_back(attach(mesh, point).vertex);
  }
  return vertices;
}

// The vertex that lies farthest in the direction.
Index farthest(const TriangleMesh& mesh, const Eigen::Vector3d& direction) {
  Index best = 0;
  for (Index v = 1; v < mesh.vertexCount(); ++v) {
    best = mesh.point(v).dot(direction) > mesh.point(best).dot(direction) ? v : best;
  }
  return best;
}

}  // namespace

class FusionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aSecondFusionIsMadeOnTheResultOfTheFirst() {
    Bench bench;
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    const std::vector<Point> nose = bench.fused();
    bench.action("renameFusion")->trigger();
    bench.typeName(1, "Nose");

    // Onto the result; it is the base at once.
    bench.action("fuseOnto")->trigger();
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Tiles);
    QCOMPARE(bench.model().shown(), 2);
    QCOMPARE(bench.fusion().upstream(Side::Base), 1);
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().inputs.base && bench.fusion().inputs.base->points() == nose);
    QVERIFY2(bench.title(Side::Base).startsWith("Result of “Nose” · "), qPrintable(bench.title(Side::Base)));
    QVERIFY(bench.window->windowTitle().contains("Fusion 2"));

    // A hemisphere on the top of the head.
    bench.drop(bench.pane(Side::Part), QString::fromStdString(samples::modelPath("hemisphere.stl").string()));
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().part);
    const TriangleMesh& base = *bench.fusion().inputs.base;
    const Loop& first = find(bench.fusions(), 1)->inputs.loop;
    const TriangleMesh& head = *find(bench.fusions(), 1)->inputs.base;
    const double radius = 0.5 * (head.point(first[0].base.vertex) - head.point(first[4].base.vertex)).norm();
    const std::vector<Index> onBase = ring(base, farthest(base, Eigen::Vector3d::UnitY()), radius);
    for (int i = 0; i < 8; ++i) {
      const Side side = i % 2 == 0 ? Side::Part : Side::Base;
      for (const Side clicked : {side, side == Side::Part ? Side::Base : Side::Part}) {
        bench.clickVertex(clicked, clicked == Side::Part ? 97 + 3 * i : onBase[static_cast<std::size_t>(i)]);
      }
      QCOMPARE(bench.fusion().inputs.loop.size(), static_cast<std::size_t>(i) + 1);
      QCOMPARE(bench.fusion().inputs.loop.back().base.vertex, onBase[static_cast<std::size_t>(i)]);
    }
    QTest::keyClick(bench.pane(Side::Base), Qt::Key_Return);
    QVERIFY(bench.settle());
    QVERIFY2(bench.problem(Side::Base).isEmpty(), qPrintable(bench.problem(Side::Base)));
    QVERIFY(bench.showsTheResult());
    const std::vector<Point> both = bench.fused();

    // The curve of the first changes both.
    bench.clickRow(1);
    QCOMPARE(bench.model().shown(), 1);
    QVERIFY(bench.settle());
    QVERIFY(bench.fused() == nose);
    bench.action("half")->trigger();
    QVERIFY(bench.settle());
    QVERIFY(bench.fused() != nose && bench.showsTheResult());
    bench.clickRow(2);
    QVERIFY(bench.settle());
    QVERIFY(bench.fused() != both && bench.showsTheResult());
    QVERIFY2(bench.problem(Side::Base).isEmpty(), "its CVs are elsewhere");
    const std::vector<Point> changed = bench.fused();

    // Saved, closed, opened again.
    const QString path = bench.folder.filePath("head.graft");
    bench.window->files().save(path);
    QVERIFY(bench.settle());
    bench.action("newProject")->trigger();
    QCOMPARE(bench.fusions().size(), std::size_t{1});
    bench.window->openFile(path);
    QVERIFY(bench.settle());
    QCOMPARE(bench.model().shown(), 2);
    QVERIFY(bench.fused() == changed);
    QCOMPARE(bench.tree()->model()->find(1).data().toString(), QString("Nose"));

    // Without the first one the second stays, on the head as it was.
    bench.clickRow(1);
    QTest::keyClick(bench.tree()->view(), Qt::Key_Delete);
    QCOMPARE(bench.fusions().size(), std::size_t{1});
    QCOMPARE(bench.model().shown(), 2);
    QCOMPARE(bench.fusion().base->name, std::string("head.obj"));
    QVERIFY(bench.settle());
    QVERIFY(bench.showsTheResult());
    bench.action("undo")->trigger();
    QVERIFY(bench.settle());
    QCOMPARE(bench.fusions().size(), std::size_t{2});
  }

  void everyStepIsUndoneAndDoneAgain() {
    Bench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    bench.model().reset(samples::twoConesOnASphere(), 2);
    QVERIFY(bench.settle());
    QUndoStack* history = bench.model().history();
    std::vector<std::pair<Document, std::vector<Point>>> states;
    const auto keep = [&] {
      QVERIFY(bench.settle());
      QVERIFY(bench.showsTheResult());
      states.emplace_back(bench.model().document(), bench.fused());
    };
    keep();
    bench.action("half")->trigger();
    keep();
    bench.model().show(1);
    QVERIFY(bench.settle());
    bench.action("linear")->trigger();
    keep();
    bench.name(2, "Second");
    QCOMPARE(history->undoText(), QString("Rename “part on part on base” to “Second”"));
    keep();
    bench.action("removeFusion")->trigger();
    keep();
    QCOMPARE(bench.model().shown(), 2);
    QCOMPARE(history->count(), 4);
    for (int i = 4; i >= 0; --i) {
      history->setIndex(i);
      QVERIFY(bench.model().document() == states[static_cast<std::size_t>(i)].first);
    }
    QVERIFY(bench.settle());
    QVERIFY(bench.fused() == states[0].second);
    history->setIndex(4);
    QVERIFY(bench.settle());
    QVERIFY(bench.model().document() == states[4].first);
    QVERIFY(bench.fused() == states[4].second);
  }

  void aSourceWithoutAResultSaysWhyAndIsShownOnDemand() {
    Bench bench;
    Document document = samples::twoConesOnASphere();
    document = edits::withFusion(document, edits::openLoop(*find(document.fusions, 1)));
    document = edits::renameFusion(document, 1, "First");
    bench.model().reset(document, 2);
    QVERIFY(bench.settle());
    bench.window->setMode(MainWindow::Mode::Tiles);
    bench.window->lookAtFirst();
    QVERIFY(!bench.fusion().inputs.base);
    QVERIFY2(bench.problem(Side::Base).contains("“First”") &&
                 bench.problem(Side::Base).contains("its loop is open"),
             qPrintable(bench.problem(Side::Base)));
    QVERIFY(bench.problem(Side::Part).isEmpty());
    QVERIFY(!bench.window->fusionPage().shown());
    QVERIFY(!bench.action("exportResult")->isEnabled());
    const QModelIndex row = bench.tree()->model()->find(2);
    QCOMPARE(row.siblingAtColumn(FusionTreeModel::What).data().toString(), QString("no result"));
    QCOMPARE(bench.tree()->model()->find(1).siblingAtColumn(FusionTreeModel::What).data().toString(),
             QString("open loop"));

    QCOMPARE(bench.remedy(Side::Base)->text(), QString("Show that fusion"));
    QTest::mouseClick(bench.remedy(Side::Base), Qt::LeftButton);
    QCOMPARE(bench.model().shown(), 1);
    bench.action("closeLoop")->trigger();
    bench.clickRow(2);
    QVERIFY(bench.settle());
    QVERIFY(bench.problem(Side::Base).isEmpty());
    QVERIFY(bench.showsTheResult());
    // And it goes again: the last result stays in sight, and what is wrong is told.
    bench.model().show(1);
    bench.action("openLoop")->trigger();
    bench.model().show(2);
    QVERIFY(bench.settle());
    QVERIFY(!bench.fusion().inputs.base);
    QVERIFY(bench.problem(Side::Base).contains("its loop is open"));
  }

  void anOpenLoopOnASourceWithoutAResultSaysWhy() {
    Bench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    bench.action("openLoop")->trigger();
    bench.action("fuseOnto")->trigger();
    QVERIFY(bench.settle());
    QVERIFY2(bench.problem(Side::Base).contains("its loop is open"), qPrintable(bench.problem(Side::Base)));
    QVERIFY(bench.problem(Side::Part).isEmpty());
  }

  void aCVThatMovedWithItsResultIsToldUntilThePersonMovesItOrLeavesItThere() {
    Bench bench;
    Document document = samples::twoConesOnASphere();
    Fusion second = *find(document.fusions, 2);
    *second.inputs.loop[3].base.place *= 1.2;
    bench.model().reset(edits::withFusion(document, second), 2);
    bench.window->setMode(MainWindow::Mode::Tiles);
    QVERIFY(bench.settle());
    QVERIFY2(bench.problem(Side::Base).contains("CV 3 on the base moved"),
             qPrintable(bench.problem(Side::Base)));
    QVERIFY(bench.problem(Side::Part).isEmpty());
    QVERIFY(bench.pairProblem(3).contains("moved") && bench.pairProblem(2).isEmpty());
    QVERIFY(bench.showsTheResult());

    // Moved by the person: its place is new.
    const Fusion& now = bench.fusion();
    const TriangleMesh& mesh = *now.inputs.base;
    const Index to = mesh.to(mesh.outgoing(now.inputs.loop[3].base.vertex));
    bench.model().push(std::make_unique<MoveCVP>(
        bench.model(), *edits::moveCV(bench.model().committed(), 3, Side::Base, SurfacePoint::atVertex(to)),
        3, Side::Base));
    QVERIFY(bench.problem(Side::Base).isEmpty() && bench.pairProblem(3).isEmpty());
    bench.action("undo")->trigger();
    QVERIFY(bench.settle());
    QVERIFY(bench.problem(Side::Base).contains("moved"));

    // Left where it is.
    QCOMPARE(bench.remedy(Side::Base)->text(), QString("Leave them there"));
    QTest::mouseClick(bench.remedy(Side::Base), Qt::LeftButton);
    QVERIFY(bench.problem(Side::Base).isEmpty() && bench.pairProblem(3).isEmpty());
    QCOMPARE(bench.model().history()->undoText(), QString("Leave the moved CVs on the base"));

    // A real problem comes before it.
    bench.action("undo")->trigger();
    bench.action("reverse")->trigger();
    QVERIFY(bench.settle());
    QVERIFY2(!bench.problem(Side::Base).contains("moved"), qPrintable(bench.problem(Side::Base)));
    QVERIFY(!bench.problem(Side::Base).isEmpty());
  }
};

QTEST_MAIN(FusionsTest)
#include "fusions_test.moc"
