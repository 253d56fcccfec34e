#include <Eigen/Geometry>

#include "app/workbench/camera_link.h"
#include "app/workbench/first_view.h"
#include "tests/support/documents.h"
#include "tests/support/workbench.h"

using namespace graftsman;

namespace {

Eigen::Vector3d side(const Camera& camera) {
  return (camera.position - camera.pivot).normalized();
}

}  // namespace

class ViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aRegionIsLookedAtFromOutside() {
    for (const char* name : {"fig8b_cone_nose", "fig9b_bird_plane", "fig7_letters_bottle"}) {
      const Fusion fusion = samples::fusion(name);
      const FusionResults results = update(fusion.inputs, {}, {});
      // The tile's own faces look to the camera on the whole.
      Eigen::Vector3d outward = Eigen::Vector3d::Zero();
      for (const Face& face : results.base.tile->faces) {
        const auto at = [&](int k) {
          return results.base.tile->points[static_cast<std::size_t>(face[static_cast<std::size_t>(k)])];
        };
        outward += (at(1) - at(0)).cross(at(2) - at(0));
      }
      const Camera camera = firstView(fusion, Side::Base);
      QVERIFY(side(camera).dot(outward.normalized()) > 0.3);
      QVERIFY(std::abs(side(camera).dot(camera.axis)) < 0.95);
    }
  }

  void changingWhatIsUpTwiceGivesTheViewBack() {
    const Camera camera{{3, -4, 2}, {1, 1, 1}};
    const Camera other = withOtherUp(camera);
    QCOMPARE(other.axis, Eigen::Vector3d(Eigen::Vector3d::UnitY()));
    QVERIFY(std::abs(side(other).dot(other.axis) - side(camera).dot(camera.axis)) < 1e-12);
    QVERIFY((withOtherUp(other).position - camera.position).norm() < 1e-12);
  }

  void linkedCamerasKeepOneRelation() {
    const Camera leader{{0, -5, 2}, {0, 0, 0}};
    const Camera follower{{103, 0, 5}, {100, 0, 0}, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitY()};
    const CameraLink link = linkCameras(leader, follower);
    const Camera same = follow(link, leader);
    QVERIFY((same.pivot - follower.pivot).norm() < 1e-12);
    QVERIFY((same.axis - follower.axis).norm() < 1e-12);
    QVERIFY(std::abs((same.position - same.pivot).norm() - (follower.position - follower.pivot).norm()) <
            1e-12);
    // A quarter turn of the leader about its axis is a quarter turn of the follower about its own.
    const Eigen::AngleAxisd quarter(EIGEN_PI / 2, leader.axis);
    const Camera turned{quarter * leader.position, leader.pivot, leader.up, leader.axis};
    const Eigen::Vector3d before = same.position - same.pivot;
    const Camera after = follow(link, turned);
    QVERIFY((after.position - after.pivot - Eigen::AngleAxisd(EIGEN_PI / 2, follower.axis) * before).norm() <
            1e-9);
    // Twice as far is twice as far.
    const Camera farther = follow(link, {2 * leader.position, leader.pivot});
    QVERIFY((farther.position - farther.pivot - 2 * before).norm() < 1e-9);
  }

  void linkedPanesTurnTogether() {
    Workbench bench;
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    bench.window->setMode(MainWindow::Mode::Tiles);
    bench.action("link")->setChecked(true);
    MeshPane* part = bench.pane(Side::Part);
    MeshPane* base = bench.pane(Side::Base);
    const Camera before = base->camera();
    QTest::mousePress(part, Qt::MiddleButton, {}, {100, 100});
    QTest::mouseMove(part, {160, 120});
    QTest::mouseRelease(part, Qt::MiddleButton, {}, {160, 120});
    const Camera turned = base->camera();
    QVERIFY((side(turned) - side(before)).norm() > 0.05);
    bench.action("link")->setChecked(false);
    QTest::mousePress(part, Qt::MiddleButton, {}, {100, 100});
    QTest::mouseMove(part, {160, 120});
    QTest::mouseRelease(part, Qt::MiddleButton, {}, {160, 120});
    QVERIFY(base->camera() == turned);
  }

  void aProjectOpensWithItsCameras() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const Camera camera{{5, 4, 3}, {0.5, 0, 0}};
    bench.resultPane()->setCamera(camera);
    const QString path = bench.folder.filePath("a.graft");
    bench.window->files().save(path);
    QVERIFY(bench.settle());
    bench.resultPane()->frameAll();
    bench.action("newProject")->trigger();
    bench.window->openFile(path);
    QVERIFY(bench.settle());
    QVERIFY(bench.resultPane()->camera() == camera);
  }
};

QTEST_MAIN(ViewsTest)
#include "views_test.moc"
