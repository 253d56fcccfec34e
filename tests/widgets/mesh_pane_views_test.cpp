#include <QApplication>
#include <QElapsedTimer>
#include <QMimeData>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>
#include <random>

#include "core/fusion/path_position.h"
#include "tests/support/mesh_pane_shown.h"
#include "tests/support/panes.h"
#include "tests/support/shapes.h"

using namespace graftsman;

class MeshPaneViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theRightButtonOpensTheMenuOnlyOnAClick() {
    Shown shown("spot.obj");
    QSignalSpy menu(&shown.pane, &Viewport::contextMenuWanted);
    const Camera camera = shown.pane.camera();
    panes::drag(shown.pane, {100, 100}, {180, 140}, Qt::RightButton);
    QCOMPARE(menu.size(), 0);
    QVERIFY(shown.pane.camera() == camera);
    QTest::mouseClick(&shown.pane, Qt::RightButton, {}, {100, 100});
    QCOMPARE(menu.size(), 1);
  }

  void everyNavigationOrbitsPansAndZooms_data() {
    QTest::addColumn<int>("navigation");
    QTest::addColumn<Qt::MouseButton>("orbitButton");
    QTest::addColumn<int>("orbitKeys");
    QTest::addColumn<Qt::MouseButton>("panButton");
    QTest::addColumn<int>("panKeys");
    QTest::addColumn<Qt::MouseButton>("zoomButton");
    QTest::addColumn<int>("zoomKeys");
    const int none = Qt::NoModifier;
    const int shift = Qt::ShiftModifier;
    const int ctrl = Qt::ControlModifier;
    const int alt = Qt::AltModifier;
    QTest::newRow("Blender") << int(Navigation::Blender) << Qt::MiddleButton << none << Qt::MiddleButton
                             << shift << Qt::MiddleButton << ctrl;
    QTest::newRow("CAD") << int(Navigation::Cad) << Qt::MiddleButton << shift << Qt::MiddleButton << none
                         << Qt::MiddleButton << ctrl;
    QTest::newRow("Maya") << int(Navigation::Maya) << Qt::LeftButton << alt << Qt::MiddleButton << alt
                          << Qt::RightButton << alt;
  }

  void everyNavigationOrbitsPansAndZooms() {
    QFETCH(int, navigation);
    QFETCH(Qt::MouseButton, orbitButton);
    QFETCH(int, orbitKeys);
    QFETCH(Qt::MouseButton, panButton);
    QFETCH(int, panKeys);
    QFETCH(Qt::MouseButton, zoomButton);
    QFETCH(int, zoomKeys);
    Shown shown("spot.obj");
    shown.pane.setNavigation(static_cast<Navigation>(navigation));
    const auto arm = [](const Camera& camera) -> Eigen::Vector3d { return camera.position - camera.pivot; };
    const Camera start = shown.pane.camera();
    panes::drag(shown.pane, {200, 200}, {260, 230}, orbitButton, Qt::KeyboardModifiers(orbitKeys));
    const Camera orbited = shown.pane.camera();
    QVERIFY((orbited.pivot - start.pivot).norm() < 1e-9);
    QVERIFY(std::abs(arm(orbited).norm() - arm(start).norm()) < 1e-9);
    QVERIFY((arm(orbited) - arm(start)).norm() > 0.1 * arm(start).norm());
    panes::drag(shown.pane, {200, 200}, {260, 230}, panButton, Qt::KeyboardModifiers(panKeys));
    const Camera panned = shown.pane.camera();
    QVERIFY((arm(panned) - arm(orbited)).norm() < 1e-9);
    QVERIFY((panned.pivot - orbited.pivot).norm() > 0.01 * arm(start).norm());
    panes::drag(shown.pane, {200, 200}, {200, 260}, zoomButton, Qt::KeyboardModifiers(zoomKeys));
    QVERIFY(std::abs(arm(shown.pane.camera()).norm() - arm(panned).norm()) > 0.05 * arm(panned).norm());
    QVERIFY(shown.picked.empty());
  }

  void theWheelKeepsThePointUnderThePointer() {
    Shown shown("spot.obj");
    std::mt19937 random(5);
    const Index vertex = shown.pickable(random);
    const QPointF at = shown.pane.screenPosition(shown.mesh->point(vertex));
    const double before = (shown.pane.camera().position - shown.mesh->point(vertex)).norm();
    panes::turnWheel(shown.pane, at, 360);
    const QPointF after = shown.pane.screenPosition(shown.mesh->point(vertex));
    QVERIFY(std::hypot(after.x() - at.x(), after.y() - at.y()) < 2);
    QVERIFY((shown.pane.camera().position - shown.mesh->point(vertex)).norm() < 0.9 * before);
  }

  void theArrowsWalkAndEnterPicks() {
    Shown shown("spot.obj");
    shown.pane.setFocus();
    QTest::keyClick(&shown.pane, Qt::Key_Return);
    QVERIFY(shown.picked.empty());  // left to the window
    QSignalSpy hovered(&shown.pane, &MeshPane::vertexHovered);
    QTest::keyClick(&shown.pane, Qt::Key_Right);
    QVERIFY(!hovered.isEmpty());
    const Index first = hovered.last().first().value<Index>();
    QVERIFY(first >= 0);
    QTest::keyClick(&shown.pane, Qt::Key_Up);
    const Index second = hovered.last().first().value<Index>();
    QVERIFY(second != first);
    QVERIFY(shown.place(second).y() < shown.place(first).y());
    QTest::keyClick(&shown.pane, Qt::Key_Return);
    QCOMPARE(shown.picked.size(), std::size_t{1});
    QCOMPARE(shown.picked[0], SurfacePoint::atVertex(second));
  }

  void aDroppedFileIsTold() {
    Shown shown("spot.obj");
    QSignalSpy dropped(&shown.pane, &Viewport::fileDropped);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile("/tmp/a mesh.obj")});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&shown.pane, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&shown.pane, &drop);
    QCOMPARE(dropped.size(), 1);
    QCOMPARE(dropped.first().first().toString(), QString("/tmp/a mesh.obj"));
  }

  void twoPanesShowOneMesh() {
    Shown a("spot.obj");
    MeshPane b(Side::Part);
    b.resize(480, 400);
    b.show();
    b.setCamera(a.pane.camera());
    QVERIFY(panes::showMesh(b, a.mesh));
    QVERIFY(b.pickAt(a.place(0), false) == a.pane.pickAt(a.place(0), false));
    const QImage first = a.pane.picture();
    const QImage second = b.picture();
    QVERIFY(first.pixel(240, 200) != first.pixel(2, 200));
    QVERIFY(first == second);
  }

  void aCameraThatWasSetStaysWhenTheMeshComes() {
    MeshPane pane(Side::Base);
    pane.resize(480, 400);
    pane.show();
    const Camera camera{{9, 8, 7}, {1, 2, 3}};
    pane.setCamera(camera);
    QVERIFY(panes::showMesh(pane, samples::model("spot.obj")));
    QVERIFY(pane.camera() == camera);
    pane.aim(camera);
    QVERIFY(!(pane.camera() == camera));
  }

  void aMillionFacesComeWithoutAStandstill() {
    MeshPane pane(Side::Base);
    pane.resize(480, 400);
    pane.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pane));
    const auto mesh = shapes::torus(720, 720);
    QVERIFY(mesh->faceCount() > 1'000'000);
    QElapsedTimer clock;
    qint64 longest = 0;
    qint64 last = 0;
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, this, [&] {
      longest = std::max(longest, clock.elapsed() - last);
      last = clock.elapsed();
    });
    ticks.start(0);
    clock.start();
    pane.setMesh(mesh);
    const qint64 setting = clock.elapsed();
    QSignalSpy shown(&pane, &MeshPane::meshShown);
    QVERIFY(shown.wait(60'000));
    qInfo("setMesh() took %lld ms; the longest standstill until it was shown, %lld ms", setting, longest);
    QVERIFY(pane.pickAt(pane.rect().center(), false) || pane.pickAt(QPointF(240, 300), false));
  }

  void theBackgroundFollowsThePalette() {
    Shown shown("spot.obj");
    const QRgb light = shown.pane.picture().pixel(2, 2);
    shown.pane.setPalette(panes::darkPalette());
    QTRY_VERIFY(qGray(shown.pane.picture().pixel(2, 2)) < qGray(light) - 80);
  }
};

QTEST_MAIN(MeshPaneViewsTest)
#include "mesh_pane_views_test.moc"
