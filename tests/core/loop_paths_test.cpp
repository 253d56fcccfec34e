#include <QtTest>
#include <algorithm>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/paths.h"
#include "tests/support/paths_meshes.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/simple_loop.h"

using namespace graftsman;

namespace {

MeshPtr tetrahedron() {
  return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

MeshPtr cube() {
  std::vector<Point> p;
  for (int i = 0; i < 8; ++i) {
    p.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  }
  return meshOf(p, {{0, 2, 1},
                    {1, 2, 3},
                    {4, 5, 6},
                    {5, 7, 6},
                    {0, 1, 4},
                    {1, 5, 4},
                    {2, 6, 3},
                    {3, 6, 7},
                    {0, 4, 2},
                    {2, 4, 6},
                    {1, 3, 5},
                    {3, 7, 5}});
}

/// The border's vertices of the n×n grid, in order round it.
std::vector<Index> gridBorder(Index n) {
  std::vector<Index> border;
  for (Index i = 0; i < n; ++i) border.push_back(i);
  for (Index j = 0; j < n; ++j) border.push_back(j * (n + 1) + n);
  for (Index i = n; i > 0; --i) border.push_back(n * (n + 1) + i);
  for (Index j = n; j > 0; --j) border.push_back(j * (n + 1));
  return border;
}

/// Whether a simple closed curve on a disk can go through the CVs: those on the border must come in its
/// order.
bool possibleOnGrid(const std::vector<Index>& cvs, const std::vector<Index>& border) {
  std::vector<std::size_t> places;
  for (const Index cv : cvs) {
    const auto at = std::find(border.begin(), border.end(), cv);
    if (at != border.end()) {
      places.push_back(static_cast<std::size_t>(at - border.begin()));
    }
  }
  const auto turns = [&](auto less) {
    int falls = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      falls += less(places[(i + 1) % places.size()], places[i]) ? 1 : 0;
    }
    return falls <= 1;
  };
  return turns(std::less<>()) || turns(std::greater<>());
}

}  // namespace

class LoopPathsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void loopsOnTheCoarsestMeshesAreSimple_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::newRow("tetrahedron") << tetrahedron();
    QTest::newRow("octahedron") << octahedron();
    QTest::newRow("cube") << cube();
  }

  void loopsOnTheCoarsestMeshesAreSimple() {
    QFETCH(MeshPtr, mesh);
    std::mt19937 random(4);
    for (std::size_t n = 3; n <= static_cast<std::size_t>(mesh->vertexCount()); ++n) {
      for (int i = 0; i < 40; ++i) {
        const auto cvs = randomVertices(*mesh, n, random);
        for (const PathMode mode : {PathMode::Paper, PathMode::Straightened}) {
          QCOMPARE(faultOfLoop(*mesh, cvs, mode), QByteArray());
        }
      }
    }
  }

  void everyOrderOfFourCornersOfAPlaneInsideIsPossible() {
    // Concave and star-shaped orders, all CVs inside: a way round is always left.
    const Index n = 10;
    const MeshPtr mesh = shapes::grid(n);
    const auto at = [&](Index i, Index j) { return j * (n + 1) + i; };
    std::vector<Index> cvs = {at(3, 3), at(7, 3), at(7, 7), at(3, 7), at(5, 5)};
    std::sort(cvs.begin(), cvs.end());
    do {
      QCOMPARE(faultOfLoop(*mesh, cvs), QByteArray());
    } while (std::next_permutation(cvs.begin(), cvs.end()));
  }

  void aCVOnTheDirectPathIsPassedBy() {
    const Index n = 8;
    const MeshPtr mesh = shapes::grid(n);
    const auto at = [&](Index i, Index j) { return j * (n + 1) + i; };
    // The direct path 0 → 1 runs along row 4, through CV 2.
    const std::vector<Index> cvs = {at(1, 4), at(7, 4), at(4, 4)};
    const auto found = loop(*mesh, cvs);
    QVERIFY(found);
    QCOMPARE(QByteArray::fromStdString(simple_loop::fault(*mesh, cvs, **found)), QByteArray());
    QVERIFY((*found)->paths[0] != (*found)->direct[0]);
    QVERIFY((*found)->paths[1] == (*found)->direct[1]);
    QVERIFY((*found)->paths[2] == (*found)->direct[2]);
    QVERIFY((*found)->paths[0]->length < 1.2 * (*found)->direct[0]->length);
  }

  void pathsThatWouldRunTogetherAreParted() {
    // A comb: the direct paths from both teeth's tips run along the same edge of the notch between them.
    const Index n = 8;
    const MeshPtr mesh = shapes::grid(n);
    const auto at = [&](Index i, Index j) { return j * (n + 1) + i; };
    const std::vector<Index> cvs = {at(0, 4), at(6, 4), at(2, 4), at(8, 4), at(4, 8)};
    QCOMPARE(faultOfLoop(*mesh, cvs), QByteArray());
  }

  void threeNeighboursMakeALoopOfTheirEdges() {
    const MeshPtr mesh = shapes::icosphere(2);
    const Face f = mesh->face(17);
    const auto found = loop(*mesh, {f[0], f[1], f[2]});
    QVERIFY(found);
    for (const auto& p : (*found)->paths) {
      QCOMPARE(p->points.size(), std::size_t{2});
    }
  }

  void loopsOnADiskFailExactlyWhereNoSimpleOneExists() {
    const Index n = 9;
    const MeshPtr mesh = shapes::grid(n);
    const auto border = gridBorder(n);
    std::mt19937 random(8);
    int possible = 0;
    int impossible = 0;
    for (int i = 0; i < 150; ++i) {
      const auto cvs = randomVertices(*mesh, 3 + random() % 7, random);
      const auto found = loop(*mesh, cvs);
      if (possibleOnGrid(cvs, border)) {
        ++possible;
        QCOMPARE(found ? QByteArray::fromStdString(simple_loop::fault(*mesh, cvs, **found))
                       : QByteArray::fromStdString(found.error().message),
                 QByteArray());
      } else {
        ++impossible;
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::PathsCross);
      }
    }
    qInfo("%d loops found, %d impossible", possible, impossible);
    QVERIFY(possible > 50 && impossible > 5);
  }

  void crossingPathsAreNamed() {
    const Index n = 4;
    const MeshPtr mesh = shapes::grid(n);
    // The four corners, two of them exchanged.
    const auto found = loop(*mesh, {0, (n + 1) * (n + 1) - 1, n, n * (n + 1)});
    QVERIFY(!found);
    const Error& error = found.error();
    QCOMPARE(error.code, ErrorCode::PathsCross);
    QVERIFY(error.side == Side::Base);
    QCOMPARE(error.paths.size(), std::size_t{2});
    QVERIFY(error.cvs.size() >= 3);
    QCOMPARE(QString::fromStdString(error.message),
             QString("Path %1 → %2 crosses path %3 → %4 on the base and there is no way round. Move CV %2 or "
                     "insert a pair between them.")
                 .arg(error.paths[0])
                 .arg((error.paths[0] + 1) % 4)
                 .arg(error.paths[1])
                 .arg((error.paths[1] + 1) % 4));
  }

  void randomLoopsOnClosedSurfacesAreAlwaysSimple_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::addColumn<int>("count");
    QTest::newRow("icosahedron") << shapes::icosphere(0) << 60;
    QTest::newRow("sphere 80") << shapes::icosphere(1) << 60;
    QTest::newRow("sphere 1280") << shapes::icosphere(3) << 30;
    QTest::newRow("torus") << shapes::torus(16, 8) << 60;
    for (const char* name : {"cone.stl", "sphere.off", "hemisphere.stl", "letters.obj", "bottle.ply",
                             "penguin.obj", "spot.obj"}) {
      QTest::newRow(name) << samples::model(name) << 20;
    }
  }

  void randomLoopsOnClosedSurfacesAreAlwaysSimple() {
    QFETCH(MeshPtr, mesh);
    QFETCH(int, count);
    std::mt19937 random(5);
    double longer = 0;
    int led = 0;
    int all = 0;
    for (int i = 0; i < count; ++i) {
      const auto cvs = randomVertices(*mesh, 3 + random() % 8, random);
      const auto found = loop(*mesh, cvs);
      QVERIFY2(found, found ? "" : found.error().message.c_str());
      QCOMPARE(QByteArray::fromStdString(simple_loop::fault(*mesh, cvs, **found)), QByteArray());
      double direct = 0;
      double final = 0;
      for (std::size_t k = 0; k < cvs.size(); ++k) {
        direct += (*found)->direct[k]->length;
        final += (*found)->paths[k]->length;
        led += (*found)->paths[k] != (*found)->direct[k] ? 1 : 0;
        ++all;
      }
      longer += final / direct / count;
    }
    qInfo("%d of %d paths led round others, loops %.1f %% longer", led, all, 100 * (longer - 1));
    QVERIFY(longer < 1.5);
  }

  void randomLoopsOnOpenModelsAreSimpleOrTold() {
    int simple = 0;
    int crossing = 0;
    int impossible = 0;
    for (const char* name : {"beetle.off", "boxcar.off"}) {
      const auto mesh = samples::model(name);
      std::mt19937 random(6);
      for (int i = 0; i < 40; ++i) {
        const auto cvs = randomVertices(*mesh, 3 + random() % 4, random);
        const auto found = loop(*mesh, cvs);
        if (found) {
          ++simple;
          QCOMPARE(QByteArray::fromStdString(simple_loop::fault(*mesh, cvs, **found)), QByteArray());
        } else {
          ++(found.error().code == ErrorCode::PathsCross ? crossing : impossible);
          QVERIFY(found.error().code == ErrorCode::PathsCross ||
                  found.error().code == ErrorCode::PathImpossible);
        }
      }
    }
    qInfo("%d simple, %d crossing, %d on different components", simple, crossing, impossible);
    QVERIFY(simple >= 30);
  }

  void theSampleScenariosHaveSimpleLoops() {
    for (const std::string& name : samples::kScenarios) {
      const FusionInputs inputs = samples::load(name);
      for (const Side side : {Side::Part, Side::Base}) {
        const auto& mesh = side == Side::Part ? inputs.part : inputs.base;
        const auto anchored = anchorLoop(mesh, inputs.loop, side);
        QVERIFY(anchored);
        QCOMPARE(faultOfLoop(*anchored->mesh, anchored->cvs), QByteArray());
      }
    }
  }

  void paperLoopsAreSimpleToo() {
    std::mt19937 random(12);
    for (const MeshPtr& mesh : {shapes::icosphere(2), shapes::torus(12, 8), samples::model("cone.stl")}) {
      for (int i = 0; i < 10; ++i) {
        QCOMPARE(faultOfLoop(*mesh, randomVertices(*mesh, 3 + random() % 5, random), PathMode::Paper),
                 QByteArray());
      }
    }
  }
};

QTEST_APPLESS_MAIN(LoopPathsTest)
#include "loop_paths_test.moc"
