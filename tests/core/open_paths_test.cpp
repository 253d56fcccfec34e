#include <QtTest>

#include "core/fusion/open_paths.h"
#include "core/fusion/path_position.h"
#include "tests/support/samples.h"

using namespace graftsman;

class OpenPathsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anOpenLoopHasOnePathLessThanPairs() {
    const FusionInputs inputs = samples::load("fig8b_cone_nose");
    const OpenPaths open = findOpenPaths(inputs.base, inputs.loop, false, Side::Base, inputs.paths, {}, {});
    QVERIFY(!open.error);
    QCOMPARE(open.paths.size(), inputs.loop.size() - 1);
    const OpenPaths closed = findOpenPaths(inputs.base, inputs.loop, true, Side::Base, inputs.paths, {}, {});
    QCOMPARE(closed.paths.size(), inputs.loop.size());
    QCOMPARE(closed.paths.back()->points.front().vertex, inputs.loop.back().base.vertex);
    QCOMPARE(closed.paths.back()->points.back().vertex, inputs.loop.front().base.vertex);
  }

  void nothingAndOnePairHaveNoPath() {
    const FusionInputs inputs = samples::load("fig4a_cone_sphere");
    QVERIFY(findOpenPaths(inputs.base, {}, false, Side::Base, inputs.paths, {}, {}).paths.empty());
    QVERIFY(
        findOpenPaths(inputs.base, {inputs.loop[0]}, true, Side::Base, inputs.paths, {}, {}).paths.empty());
  }

  void pathsThatDidNotChangeAreTheSameObjects() {
    FusionInputs inputs = samples::load("fig8b_cone_nose");
    const OpenPaths before = findOpenPaths(inputs.base, inputs.loop, true, Side::Base, inputs.paths, {}, {});
    inputs.loop.erase(inputs.loop.begin() + 3);
    const OpenPaths after =
        findOpenPaths(inputs.base, inputs.loop, true, Side::Base, inputs.paths, before, {});
    QCOMPARE(after.paths[0], before.paths[0]);
    QVERIFY(after.paths[2] != before.paths[2]);
    QCOMPARE(after.paths[3], before.paths[4]);
    QCOMPARE(after.paths.back(), before.paths.back());
  }

  void aPointThatIsNoneNamesItsCV() {
    FusionInputs inputs = samples::load("fig4a_cone_sphere");
    inputs.loop[2].part = SurfacePoint::atVertex(1'000'000);
    const OpenPaths open = findOpenPaths(inputs.part, inputs.loop, false, Side::Part, inputs.paths, {}, {});
    QVERIFY(open.error);
    QCOMPARE(open.error->code, ErrorCode::LoopIndexOutOfRange);
    QCOMPARE(open.error->cvs, std::vector<int>{2});
  }

  void anUnreachableCVCostsItsPathsAlone() {
    // Two triangles apart, and a strip.
    const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0},  {0, 1, 0}, {1, 1, 0},
                                       {9, 0, 0}, {10, 0, 0}, {9, 1, 0}};
    const auto mesh =
        std::make_shared<const TriangleMesh>(points, std::vector<Face>{{0, 1, 2}, {1, 3, 2}, {4, 5, 6}});
    const auto at = [](Index v) { return CVP{SurfacePoint::atVertex(v), SurfacePoint::atVertex(v)}; };
    const OpenPaths open =
        findOpenPaths(mesh, {at(0), at(4), at(1), at(3)}, false, Side::Part, PathMode::Straightened, {}, {});
    QVERIFY(open.error);
    QCOMPARE(open.error->code, ErrorCode::PathImpossible);
    QCOMPARE(open.error->paths, std::vector<int>{0});
    QVERIFY(!open.paths[0] && !open.paths[1] && open.paths[2]);
  }

  void aPointAlongAPathLiesThere() {
    for (const std::string& name : samples::kScenarios) {
      const FusionInputs inputs = samples::load(name);
      const OpenPaths open = findOpenPaths(inputs.base, inputs.loop, true, Side::Base, inputs.paths, {}, {});
      for (const auto& path : open.paths) {
        const Point start = inputs.base->point(path->points.front().vertex);
        QVERIFY(fractionNearest(*path, *inputs.base, start) < 1e-9);
        const auto middle = pointAlong(*path, *open.anchored, inputs.base->vertexCount(), 0.5);
        QVERIFY(middle);
        QVERIFY(!(*middle == SurfacePoint::atVertex(path->points.front().vertex)));
        QVERIFY(!(*middle == SurfacePoint::atVertex(path->points.back().vertex)));
        if (middle->vertex < 0) {
          QVERIFY(std::abs(middle->bary.sum() - 1) < 1e-12 && middle->bary.minCoeff() >= 0);
        }
        // No farther from the path than its edges are long.
        const double along = fractionNearest(*path, *inputs.base, positionOf(*inputs.base, *middle));
        QVERIFY2(along > 0.02 && along < 0.98, qPrintable(QString::number(along)));
      }
    }
  }

  void aCancelledSearchSaysSo() {
    const FusionInputs inputs = samples::load("fig8b_cone_nose");
    const Progress stop([](double) { return false; }, std::chrono::milliseconds(0));
    const OpenPaths open = findOpenPaths(inputs.base, inputs.loop, false, Side::Base, inputs.paths, {}, stop);
    QVERIFY(open.error);
    QCOMPARE(open.error->code, ErrorCode::Cancelled);
  }
};

QTEST_APPLESS_MAIN(OpenPathsTest)
#include "open_paths_test.moc"
