#include <QtTest>

#include "tests/support/cut_checks.h"
#include "tests/support/loops.h"
#include "tests/support/shapes.h"

using namespace graftsman;
using loops::between;
using loops::vertex;

namespace {

TriangleMesh tetrahedron() {
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

QByteArray fault(const TriangleMesh& mesh, const LoopPaths& paths) {
  return QByteArray::fromStdString(checks::cutFault(mesh, paths, cutMesh(mesh, paths)));
}

}  // namespace

class CutTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aLoopAlongEdgesDividesNothing() {
    const auto mesh = shapes::grid(4);
    const Cut cut = cutMesh(*mesh, loops::throughVertices({6, 7, 8, 13, 18, 17, 16, 11}));
    QVERIFY(cut.points.empty());
    QVERIFY(cut.faces.empty());
    QVERIFY(cut.parents.empty());
    QCOMPARE(cut.boundary, std::vector<Index>({6, 7, 8, 13, 18, 17, 16, 11}));
    QCOMPARE(cut.corners, std::vector<Index>({0, 1, 2, 3, 4, 5, 6, 7}));
  }

  void aPathThroughAFaceDividesIt() {
    const auto mesh = shapes::grid(4);
    const LoopPaths loop = loops::polygon(*mesh, 4, {{0, 0}, {2, 1}, {1, 3}});  // crosses x = 1 at y = 1/2
    const Cut cut = cutMesh(*mesh, loop);
    QCOMPARE(QByteArray::fromStdString(checks::cutFault(*mesh, loop, cut)), QByteArray());
    QCOMPARE(cut.where[0], between(*mesh, 1, 6, 0.5));
    QCOMPARE(cut.points[0], Point(0.25, 0.125, 0));
    QVERIFY(std::ssize(cut.faces) > 4);
  }

  void aPointOnAnEdgeDividesBothFacesBesideIt() {
    const TriangleMesh mesh = tetrahedron();
    const LoopPaths loop =
        loops::fromChain({vertex(0), between(mesh, 1, 2, 0.25), vertex(3), vertex(1)}, {0, 3, 1});
    const Cut cut = cutMesh(mesh, loop);
    QCOMPARE(QByteArray::fromStdString(checks::cutFault(mesh, loop, cut)), QByteArray());
    QCOMPARE(cut.parents, std::vector<Index>({0, 0, 2, 2}));
    QCOMPARE(cut.boundary, std::vector<Index>({0, 4, 3, 1}));
    QCOMPARE(cut.corners, std::vector<Index>({0, 2, 3}));
  }

  void aPathThatLeavesAnEdgeInItsMiddleDividesTheOtherFaceToo() {
    const TriangleMesh mesh = tetrahedron();
    const LoopPaths loop =
        loops::fromChain({vertex(0), between(mesh, 0, 1, 0.5), between(mesh, 1, 3, 0.5), vertex(2)}, {0, 2});
    const Cut cut = cutMesh(mesh, loop);
    QCOMPARE(QByteArray::fromStdString(checks::cutFault(mesh, loop, cut)), QByteArray());
    QCOMPARE(cut.parents, std::vector<Index>({0, 0, 1, 1, 1, 2, 2}));
  }

  void severalSegmentsPassThroughOneFace() {
    const auto mesh = shapes::grid(1);  // faces 0 1 3 and 0 3 2
    const LoopPaths loop = loops::fromChain({vertex(1), between(*mesh, 1, 3, 0.4), between(*mesh, 0, 3, 0.6),
                                             vertex(2), between(*mesh, 0, 3, 0.2), between(*mesh, 0, 1, 0.3)},
                                            {1, 2});
    const Cut cut = cutMesh(*mesh, loop);
    QCOMPARE(QByteArray::fromStdString(checks::cutFault(*mesh, loop, cut)), QByteArray());
    QCOMPARE(cut.parents, std::vector<Index>({0, 0, 0, 0, 0, 1, 1, 1}));
  }

  void aLoopThatWindsManyTimesRoundACornerNestsItsSegments() {
    const TriangleMesh mesh = tetrahedron();
    constexpr int kTurns = 200;
    const LoopPaths loop = loops::doubleSpiral(mesh, kTurns);
    const Cut cut = cutMesh(mesh, loop);
    QCOMPARE(QByteArray::fromStdString(checks::cutFault(mesh, loop, cut)), QByteArray());
    QCOMPARE(std::ssize(cut.points), 2 * (3 * kTurns + 1));
  }

  void randomPolygonsOnAGridAreCutExactly() {
    constexpr Index kSize = 12;
    const auto mesh = shapes::grid(kSize);
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
      // A star-shaped polygon round the middle, so simple.
      std::vector<std::pair<Index, Index>> corners;
      const int count = 3 + static_cast<int>(random() % 7);
      for (int i = 0; i < count; ++i) {
        const double angle =
            2 * std::numbers::pi * (i + 0.5 * static_cast<double>(random() % 100) / 100) / count;
        const double radius = 2.5 + 3.5 * static_cast<double>(random() % 100) / 100;
        corners.emplace_back(6 + std::lround(radius * std::cos(angle)),
                             6 + std::lround(radius * std::sin(angle)));
      }
      const LoopPaths loop = loops::polygon(*mesh, kSize, corners);
      QCOMPARE(fault(*mesh, loop), QByteArray());
    }
  }

  void randomLoopsOnASphereAreCut() {
    const auto mesh = shapes::icosphere(3);
    for (unsigned seed = 0; seed < 60; ++seed) {
      const loops::AnchoredLoopPaths loop = loops::randomLoop(mesh, seed);
      QCOMPARE(fault(*loop.mesh, loop.paths), QByteArray());
    }
  }
};

QTEST_APPLESS_MAIN(CutTest)
#include "cut_test.moc"
