#include <QSignalSpy>
#include <QtTest>
#include <random>

#include "core/fusion/path_position.h"
#include "tests/support/mesh_pane_shown.h"
#include "tests/support/panes.h"
#include "tests/support/shapes.h"

using namespace graftsman;

class MeshPaneTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void verticesInSightArePickedWhereTheyAreSeen() {
    Shown shown("sphere.off");
    int inSight = 0;
    int exact = 0;
    const Camera camera = shown.pane.camera();
    for (Index v = 0; v < shown.mesh->vertexCount(); ++v) {
      // On a sphere what faces the camera is in sight.
      const Point& point = shown.mesh->point(v);
      const Point centre = camera.pivot;
      if ((point - centre).normalized().dot((camera.position - point).normalized()) > 0.3) {
        ++inSight;
        const QPointF place = shown.pane.screenPosition(point);
        const auto picked = shown.pane.pickAt(place, false);
        QVERIFY(picked);
        exact += *picked == SurfacePoint::atVertex(v) ? 1 : 0;
        // A pixel's centre can lie in a thin face beside the vertex's own: then one of that face's is taken.
        const QPointF off = shown.pane.screenPosition(shown.mesh->point(picked->vertex)) - place;
        QVERIFY2(
            std::hypot(off.x(), off.y()) < 4,
            qPrintable(
                QString("vertex %1 took %4: %2, %3").arg(v).arg(off.x()).arg(off.y()).arg(picked->vertex)));
      }
    }
    QVERIFY(inSight > 200);
    QVERIFY(exact > inSight * 98 / 100);
  }

  void aFreePickIsThePointUnderThePointer() {
    Shown shown("head.obj");
    int hits = 0;
    for (int x = 20; x < 480; x += 17) {
      for (int y = 20; y < 400; y += 17) {
        const auto free = shown.pane.pickAt(QPointF(x, y), true);
        if (!free) {
          continue;
        }
        ++hits;
        QVERIFY(free->vertex < 0);
        QVERIFY(free->bary.minCoeff() >= 0 && std::abs(free->bary.sum() - 1) < 1e-12);
        const QPointF back = shown.pane.screenPosition(positionOf(*shown.mesh, *free));
        QVERIFY(std::hypot(back.x() - x, back.y() - y) < 0.01);
        const auto vertex = shown.pane.pickAt(QPointF(x, y), false);
        const Face& face = shown.mesh->face(free->face);
        QVERIFY(std::find(face.begin(), face.end(), vertex->vertex) != face.end());
      }
    }
    QVERIFY(hits > 50);
    QVERIFY(!shown.pane.pickAt(QPointF(1, 1), false));
  }

  void aClickTakesAVertexAndWithCtrlThePoint() {
    Shown shown("spot.obj");
    std::mt19937 random(1);
    const Index vertex = shown.pickable(random);
    QTest::mouseClick(&shown.pane, Qt::LeftButton, {}, shown.place(vertex));
    QCOMPARE(shown.picked.size(), std::size_t{1});
    QCOMPARE(shown.picked[0], SurfacePoint::atVertex(vertex));
    const Index other = shown.pickable(random);
    QTest::mouseClick(&shown.pane, Qt::LeftButton, Qt::ControlModifier, shown.place(other));
    QCOMPARE(shown.picked.size(), std::size_t{2});
    QVERIFY(shown.picked[1].vertex < 0 && shown.picked[1].face >= 0);
    shown.pane.setPicking(false);
    QTest::mouseClick(&shown.pane, Qt::LeftButton, {}, shown.place(vertex));
    QCOMPARE(shown.picked.size(), std::size_t{2});
  }

  void theVertexThatAClickWouldTakeIsTold() {
    Shown shown("spot.obj");
    std::mt19937 random(2);
    const Index vertex = shown.pickable(random);
    QSignalSpy hovered(&shown.pane, &MeshPane::vertexHovered);
    panes::moveTo(shown.pane, shown.place(vertex));
    QTRY_VERIFY(!hovered.isEmpty());
    QCOMPARE(hovered.last().first().value<Index>(), vertex);
    panes::moveTo(shown.pane, QPoint(2, 2));
    QTRY_COMPARE(hovered.last().first().value<Index>(), Index{-1});
  }

  void aCVIsClickedAndDraggedAndEscCancels() {
    Shown shown("spot.obj");
    std::mt19937 random(3);
    const Index vertex = shown.pickable(random);
    LoopMarks marks;
    marks.cvs.push_back({SurfacePoint::atVertex(vertex), 4});
    shown.pane.setMarks(marks);
    QSignalSpy clicked(&shown.pane, &MeshPane::cvClicked);
    QSignalSpy started(&shown.pane, &MeshPane::cvDragStarted);
    QSignalSpy dragged(&shown.pane, &MeshPane::cvDragged);
    QSignalSpy finished(&shown.pane, &MeshPane::cvDragFinished);
    QSignalSpy cancelled(&shown.pane, &MeshPane::cvDragCancelled);
    const QPoint at = shown.place(vertex);
    QTest::mouseClick(&shown.pane, Qt::LeftButton, {}, at);
    QCOMPARE(clicked.size(), 1);
    QCOMPARE(clicked.first().first().toInt(), 4);
    QVERIFY(shown.picked.empty());
    // Within the hit area of 16 px, too.
    QTest::mouseClick(&shown.pane, Qt::LeftButton, {}, at + QPoint(6, 0));
    QCOMPARE(clicked.size(), 2);

    panes::drag(shown.pane, at, at + QPoint(40, 20), Qt::LeftButton);
    QCOMPARE(started.size(), 1);
    QVERIFY(!dragged.isEmpty());
    QCOMPARE(finished.size(), 1);
    QVERIFY(shown.picked.empty());

    QTest::mousePress(&shown.pane, Qt::LeftButton, {}, at);
    panes::moveHeld(shown.pane, at + QPoint(20, 10), Qt::LeftButton);
    QCOMPARE(started.size(), 2);
    QTest::keyClick(&shown.pane, Qt::Key_Escape);
    QCOMPARE(cancelled.size(), 1);
    QTest::mouseRelease(&shown.pane, Qt::LeftButton, {}, at + QPoint(20, 10));
    QCOMPARE(finished.size(), 1);
  }

  void aClickOnAPathInsertsThere() {
    Shown shown("head.obj");
    const FusionResults results = update(samples::load("fig8b_cone_nose"), {}, {});
    // The sample's own mesh is another object of the same file.
    QVERIFY(panes::showMesh(shown.pane, results.inputs.base));
    shown.pane.aim({{0.4, 0.2, 3}, {0, 0, 0}, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitY()});
    shown.pane.setMarks(panes::marksOf(results, Side::Base));
    QSignalSpy clicked(&shown.pane, &MeshPane::pathClicked);
    int hit = 0;
    for (std::size_t i = 0; i < results.base.paths->paths.size(); ++i) {
      const Path& path = *results.base.paths->paths[i];
      const EdgePoint& middle = path.points[path.points.size() / 2];
      const Point at = position(*results.base.anchored->mesh, middle);
      shown.pane.setCamera({at + Point(0, 0, 0.3 * results.inputs.base->diagonal()), at,
                            Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitY()});
      const int before = clicked.size();
      QTest::mouseClick(&shown.pane, Qt::LeftButton, {}, shown.pane.screenPosition(at).toPoint());
      if (clicked.size() > before) {
        QCOMPARE(clicked.last().first().toInt(), static_cast<int>(i));
        ++hit;
      }
    }
    QVERIFY2(hit >= 5, qPrintable(QString::number(hit)));
  }

  void whatIsPaintedOverTheSceneLeavesItUndrawn() {
    struct Counting : MeshPane {
      using MeshPane::MeshPane;
      int drawn = 0;
      void prepareFrame(const CameraView& view) override {
        ++drawn;
        MeshPane::prepareFrame(view);
      }
    };
    Counting pane(Side::Base);
    pane.resize(480, 400);
    pane.show();
    QVERIFY(panes::showMesh(pane, samples::model("spot.obj")));
    const auto frame = [&] { return pane.grabFramebuffer(); };
    panes::moveTo(pane, {240, 200});
    QImage before = frame();
    const int drawn = pane.drawn;
    for (const QPointF& at : {QPointF(225, 190), QPointF(260, 210)}) {
      panes::moveTo(pane, at);
      QVERIFY(frame() != before);
      before = frame();
    }
    pane.setBusy(0.5);
    QVERIFY(frame() != before);
    pane.setBusy({});
    QVERIFY(frame() == before);
    QCOMPARE(pane.drawn, drawn);
    // A path, another camera, another palette, a picture of another size: drawn.
    LoopMarks marks;
    const std::shared_ptr<const TriangleMesh> model = samples::model("spot.obj");
    const TriangleMesh& mesh = *model;
    marks.paths.push_back({{mesh.point(0), mesh.point(100)}, 0});
    pane.setMarks(marks);
    (void)frame();
    QCOMPARE(pane.drawn, drawn + 1);
    pane.frameAll();
    pane.lookFrom(AxisView::Top);
    const QImage top = frame();
    QCOMPARE(pane.drawn, drawn + 2);
    QVERIFY(pane.picture(QSize(100, 80)).size() == QSize(100, 80));
    QVERIFY(frame() == top);
    QCOMPARE(pane.drawn, drawn + 4);
    pane.setPalette(panes::darkPalette());
    QVERIFY(frame() != top);
  }

  void aPathIsTwoPixelsWide() {
    MeshPane pane(Side::Base);
    pane.resize(400, 300);
    pane.show();
    QVERIFY(panes::showMesh(pane, shapes::grid(10)));
    const auto mesh = shapes::grid(10);
    const Point& middle = mesh->point(60);
    pane.setCamera({middle + Point(0, 0, 2 * mesh->diagonal()), middle, Eigen::Vector3d::UnitY(),
                    Eigen::Vector3d::UnitY()});
    LoopMarks marks;
    marks.paths.push_back({{mesh->point(57), mesh->point(63)}, 0});
    pane.setMarks(marks);
    const QImage picture = pane.picture();
    const QPoint at = pane.screenPosition((mesh->point(60) + mesh->point(61)) / 2).toPoint();
    const bool across =
        pane.screenPosition(mesh->point(57)).x() < pane.screenPosition(mesh->point(63)).x() - 5 ||
        pane.screenPosition(mesh->point(57)).x() > pane.screenPosition(mesh->point(63)).x() + 5;
    int dark = 0;
    for (int i = -8; i <= 8; ++i) {
      const QColor colour = picture.pixelColor(across ? at + QPoint(0, i) : at + QPoint(i, 0));
      dark += colour.lightness() < 128 ? 1 : 0;
    }
    QVERIFY2(dark >= 2 && dark <= 3, qPrintable(QString::number(dark)));
  }

  void theKeyboardInsertsOnAPath() {
    Shown shown("spot.obj");
    std::mt19937 random(3);
    const Index vertex = shown.pickable(random);
    LoopMarks marks;
    const Point& at = shown.mesh->point(vertex);
    const Point aside = 0.1 * shown.mesh->diagonal() * Point(1, 0.3, 0).normalized();
    marks.paths.push_back({{at - aside, at, at + aside}, 4});
    shown.pane.setMarks(marks);
    shown.pane.setFocus();
    QSignalSpy onPath(&shown.pane, &MeshPane::pathClicked);
    panes::moveTo(shown.pane, shown.place(vertex));
    // To a neighbour and back: the keyboard's cursor stands on the path.
    QSignalSpy hovered(&shown.pane, &MeshPane::vertexHovered);
    const std::array<Qt::Key, 4> keys = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
    for (int i = 0; i < 40 && onPath.isEmpty(); ++i) {
      QTest::keyClick(&shown.pane, keys[random() % 4]);
      QTest::keyClick(&shown.pane, Qt::Key_Return);
    }
    QVERIFY(!onPath.isEmpty());
    QCOMPARE(onPath.first().first().toInt(), 4);
  }

  void aFlashedCVOutOfSightIsBroughtIntoSight() {
    Shown shown("spot.obj");
    // One on the far side, and one beyond the pane's edge.
    const Camera before = shown.pane.camera();
    Index behind = 0;
    double farthest = -1e9;
    for (Index v = 0; v < shown.mesh->vertexCount(); ++v) {
      const double depth = (before.pivot - before.position).dot(shown.mesh->point(v));
      if (depth > farthest) {
        farthest = depth;
        behind = v;
      }
    }
    LoopMarks marks;
    marks.cvs.push_back({SurfacePoint::atVertex(behind), 0});
    shown.pane.setMarks(marks);
    QVERIFY(shown.pane.pickAt(shown.place(behind), false) != SurfacePoint::atVertex(behind));
    QSignalSpy moved(&shown.pane, &Viewport::cameraChanged);
    shown.pane.flashCV(0);
    QCOMPARE(moved.size(), 1);
    QCOMPARE(shown.pane.pickAt(shown.place(behind), false), std::optional(SurfacePoint::atVertex(behind)));
    // In sight it stays where it is.
    const Camera seen = shown.pane.camera();
    shown.pane.flashCV(0);
    QVERIFY(shown.pane.camera() == seen);
    const Point aside = 3 * shown.mesh->diagonal() * Point(0, 0, 1);
    shown.pane.setCamera({seen.position + aside, seen.pivot + aside, seen.up, seen.axis});
    QVERIFY(!shown.pane.rect().contains(shown.place(behind)));
    shown.pane.flashCV(0);
    QVERIFY(shown.pane.rect().contains(shown.place(behind)));
  }
};

QTEST_MAIN(MeshPaneTest)
#include "mesh_pane_test.moc"
