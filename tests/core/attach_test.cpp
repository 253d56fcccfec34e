#include <QtTest>

#include "core/fusion/path_position.h"
#include "core/mesh/attach.h"
#include "tests/support/shapes.h"

using namespace graftsman;

class AttachTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aVertexIsFoundAgainAtItsPlace() {
    const auto ball = shapes::icosphere(3);
    for (Index v = 0; v < ball->vertexCount(); v += 7) {
      SurfacePoint point = SurfacePoint::atVertex(0);
      point.place = ball->point(v);
      QCOMPARE(attach(*ball, point).vertex, v);
    }
  }

  void aVertexBesideTheSurfaceTakesTheNearestVertex() {
    const auto ball = shapes::icosphere(2);
    SurfacePoint point = SurfacePoint::atVertex(0);
    point.place = 1.3 * ball->point(17) + Eigen::Vector3d(1e-3, -1e-3, 1e-3);
    const SurfacePoint found = attach(*ball, point);
    QCOMPARE(found.vertex, 17);
    QVERIFY(found == point);
  }

  void anIsolatedVertexIsNoPlaceForACV() {
    const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}}, {{0, 1, 2}});
    SurfacePoint point = SurfacePoint::atVertex(0);
    point.place = mesh.point(3);
    QCOMPARE(attach(mesh, point).vertex, 0);
  }

  void aPointOfAFaceIsTheSurfacesNearestPoint() {
    const auto ring = shapes::torus(12, 9);
    SurfacePoint point{-1, 0, Eigen::Vector3d::UnitX(), {}};
    for (Index f = 0; f < ring->faceCount(); f += 5) {
      const SurfacePoint within{-1, f, {0.2, 0.3, 0.5}, {}};
      point.place = positionOf(*ring, within);
      const SurfacePoint found = attach(*ring, point);
      QCOMPARE(found.vertex, -1);
      QVERIFY((positionOf(*ring, found) - *point.place).norm() < 1e-12);
    }
  }

  void outsideATriangleTheNearestPointLiesOnItsEdgeOrCorner() {
    const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const auto nearest = [&](const Point& place) {
      return positionOf(mesh, attach(mesh, {-1, 0, Eigen::Vector3d::UnitX(), place}));
    };
    QVERIFY((nearest({0.5, -1, 0}) - Point(0.5, 0, 0)).norm() < 1e-15);
    QVERIFY((nearest({2, -1, 3}) - Point(1, 0, 0)).norm() < 1e-15);
    QVERIFY((nearest({1, 1, 0}) - Point(0.5, 0.5, 0)).norm() < 1e-15);
  }
};

QTEST_GUILESS_MAIN(AttachTest)
#include "attach_test.moc"
