#include <Eigen/Geometry>
#include <QtTest>
#include <numbers>
#include <random>

#include "widgets/viewport/camera_view.h"

using namespace graftsman;

class CameraViewTest : public QObject {
  Q_OBJECT

 private:
  static CameraView view(const Camera& camera, double ratio = 1) { return {camera, QSizeF(640, 480), ratio}; }
  static Camera oblique(const Eigen::Vector3d& axis) { return {{3, -5, 4}, {1, 0, 1}, axis, axis}; }

 private Q_SLOTS:
  void whatIsProjectedIsFoundByItsRay() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> in(-1, 1);
    for (const double ratio : {1.0, 1.5, 2.0}) {
      const CameraView v = view(oblique(Eigen::Vector3d::UnitZ()), ratio);
      for (int i = 0; i < 200; ++i) {
        const Point point(in(random), in(random), in(random));
        const Ray ray = v.rayThrough(v.project(point));
        QVERIFY((point - ray.origin).cross(ray.direction).norm() < 1e-9);
        QVERIFY((v.onPlane(v.project(point), point) - point).norm() < 1e-9);
      }
    }
  }

  void orbitingKeepsAxisPivotAndDistance() {
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 1, 0)}) {
      const Camera start = oblique(axis);
      Camera camera = start;
      for (int i = 0; i < 1000; ++i) {
        camera = orbited(camera, 0.3, i % 2 == 0 ? 0.2 : -0.19);
        QCOMPARE(camera.axis, axis);
        QVERIFY((camera.pivot - start.pivot).norm() < 1e-12);
        QVERIFY(std::abs((camera.position - camera.pivot).norm() - (start.position - start.pivot).norm()) <
                1e-9);
        // Upright: the axis never points down on the screen, nor to a side.
        QVERIFY(view(camera).up().dot(axis) > -1e-9);
        QVERIFY(std::abs(view(camera).right().dot(axis)) < 1e-9);
      }
    }
  }

  void theFirstOrbitDoesNotJump() {
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 1, 0)}) {
      const Camera start = oblique(axis);
      const Camera next = orbited(start, 1e-6, 1e-6);
      QVERIFY((view(next).up() - view(start).up()).norm() < 1e-4);
      QVERIFY((next.position - start.position).norm() < 1e-4);
    }
  }

  void itStopsAboveInsteadOfTurningOver() {
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 1, 0)}) {
      const Camera above = orbited(oblique(axis), 0, 10);
      QVERIFY((above.position - above.pivot).normalized().dot(axis) > 1 - 1e-9);
      const Camera back = orbited(above, 0, -0.5);
      QVERIFY(view(back).up().dot(axis) > 0);
    }
  }

  void theFrontOfAYUpSceneIsSeenFromPlusZ() {
    const Camera z = oblique(Eigen::Vector3d::UnitZ());
    const Camera y = oblique(Eigen::Vector3d::UnitY());
    const auto from = [](const Camera& camera, AxisView side) -> Eigen::Vector3d {
      const Camera looking = lookingFrom(camera, side);
      return (looking.position - looking.pivot).normalized();
    };
    QVERIFY((from(z, AxisView::Front) - Eigen::Vector3d(0, -1, 0)).norm() < 1e-9);
    QVERIFY((from(y, AxisView::Front) - Eigen::Vector3d(0, 0, 1)).norm() < 1e-9);
    QVERIFY((from(z, AxisView::Right) - Eigen::Vector3d(1, 0, 0)).norm() < 1e-9);
    QVERIFY((from(y, AxisView::Right) - Eigen::Vector3d(1, 0, 0)).norm() < 1e-9);
    QVERIFY((from(z, AxisView::Top) - Eigen::Vector3d(0, 0, 1)).norm() < 1e-9);
    QVERIFY((from(y, AxisView::Top) - Eigen::Vector3d(0, 1, 0)).norm() < 1e-9);
    QVERIFY((from(y, AxisView::Back) + from(y, AxisView::Front)).norm() < 1e-9);
    QVERIFY((from(y, AxisView::Left) + from(y, AxisView::Right)).norm() < 1e-9);
    QVERIFY((from(y, AxisView::Bottom) + from(y, AxisView::Top)).norm() < 1e-9);
  }

  void whatIsFramedIsAllInView() {
    const Eigen::AlignedBox3d box(Point(-3, 2, 10), Point(5, 2.5, 11));
    for (const QSizeF& size : {QSizeF(640, 480), QSizeF(200, 900), QSizeF(900, 200)}) {
      CameraView v{oblique(Eigen::Vector3d::UnitZ()), size, 1};
      v.camera = v.framing(box);
      double widest = 0;
      for (int i = 0; i < 8; ++i) {
        const QPointF at = v.project(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
        QVERIFY(at.x() > 0 && at.x() < size.width() && at.y() > 0 && at.y() < size.height());
        widest =
            std::max({widest, std::abs(at.x() / size.width() - 0.5), std::abs(at.y() / size.height() - 0.5)});
      }
      QVERIFY(widest > 0.4);
    }
  }

  void zoomingKeepsTheAnchorWhereItIs() {
    const Camera camera = oblique(Eigen::Vector3d::UnitZ());
    const Point anchor(0.5, 0.25, 1);
    const Camera nearer = zoomed(camera, anchor, 0.5);
    const QPointF moved = view(nearer).project(anchor) - view(camera).project(anchor);
    QVERIFY(std::hypot(moved.x(), moved.y()) < 1e-9);
    QVERIFY(std::abs((nearer.position - anchor).norm() - 0.5 * (camera.position - anchor).norm()) < 1e-12);
  }
};

QTEST_APPLESS_MAIN(CameraViewTest)
#include "camera_view_test.moc"
