#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <QtTest>
#include <algorithm>
#include <numbers>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/paths.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/simple_loop.h"

using namespace graftsman;
using shapes::MeshPtr;

namespace {

/// Exact geodesic distances from one vertex, by CGAL.
class ExactDistances {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Paths = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

 public:
  ExactDistances(const TriangleMesh& mesh, Index source) {
    for (const Point& p : mesh.points()) {
      mesh_.add_vertex({p.x(), p.y(), p.z()});
    }
    for (const Face& f : mesh.faces()) {
      mesh_.add_face(at(f[0]), at(f[1]), at(f[2]));
    }
    paths_ = std::make_unique<Paths>(mesh_);
    paths_->add_source_point(at(source));
  }

  double to(Index target) { return paths_->shortest_distance_to_source_points(at(target)).first; }

 private:
  static Mesh::Vertex_index at(Index v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); }
  Mesh mesh_;
  std::unique_ptr<Paths> paths_;
};

MeshPtr meshOf(std::vector<Point> points, std::vector<Face> faces) {
  return std::make_shared<TriangleMesh>(std::move(points), std::move(faces));
}

MeshPtr octahedron() {
  return meshOf({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

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

/// The mesh, each point multiplied and moved.
MeshPtr moved(const TriangleMesh& mesh, double scale, const Point& offset) {
  std::vector<Point> points = mesh.points();
  for (Point& p : points) {
    p = scale * p + offset;
  }
  return meshOf(std::move(points), mesh.faces());
}

std::shared_ptr<const Path> path(const TriangleMesh& mesh, Index from, Index to,
                                 PathMode mode = PathMode::Straightened) {
  const auto found = findPath(mesh, from, to, mode, {});
  if (!found) {
    qFatal("%s", found.error().message.c_str());
  }
  return *found;
}

Result<std::shared_ptr<const LoopPaths>> loop(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                                              PathMode mode = PathMode::Straightened) {
  return findPaths(mesh, cvs, mode, Side::Base, nullptr, {}, {});
}

/// What is wrong with the loop through these CVs, the error if there is one; empty if it is simple.
QByteArray faultOfLoop(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                       PathMode mode = PathMode::Straightened) {
  const auto found = loop(mesh, cvs, mode);
  return QByteArray::fromStdString(found ? simple_loop::fault(mesh, cvs, **found) : found.error().message);
}

QByteArray faultOf(const TriangleMesh& mesh, const Path& p) {
  return QByteArray::fromStdString(
      simple_loop::faultOf(mesh, p, p.points.front().vertex, p.points.back().vertex));
}

bool samePoints(const LoopPaths& a, const LoopPaths& b) {
  return std::equal(a.paths.begin(), a.paths.end(), b.paths.begin(), b.paths.end(),
                    [](const auto& p, const auto& q) { return p->points == q->points; });
}

/// So many different vertices, none singular.
std::vector<Index> randomVertices(const TriangleMesh& mesh, std::size_t count, std::mt19937& random) {
  std::vector<Index> result;
  while (result.size() < count) {
    const auto v = static_cast<Index>(random() % static_cast<std::uint32_t>(mesh.vertexCount()));
    if (!mesh.singular(v) && std::find(result.begin(), result.end(), v) == result.end()) {
      result.push_back(v);
    }
  }
  return result;
}

/// How far paths between random vertices exceed the exact length, as parts of it, ascending.
std::vector<double> excesses(const TriangleMesh& mesh, int sources, int targets, PathMode mode) {
  std::mt19937 random(20);
  std::vector<double> result;
  for (int i = 0; i < sources; ++i) {
    const std::vector<Index> ends = randomVertices(mesh, static_cast<std::size_t>(targets) + 1, random);
    ExactDistances exact(mesh, ends[0]);
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double distance = exact.to(ends[k]);
      if (distance >= 0) {  // on the same component
        const auto found = path(mesh, ends[0], ends[k], mode);
        if (!faultOf(mesh, *found).isEmpty()) {
          qFatal("from %d to %d: %s", ends[0], ends[k], faultOf(mesh, *found).constData());
        }
        result.push_back(found->length / distance - 1);
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
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

class PathsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPathBetweenNeighboursIsTheirEdge() {
    const MeshPtr mesh = shapes::icosphere(1);
    for (const PathMode mode : {PathMode::Paper, PathMode::Straightened}) {
      const Index to = mesh->to(mesh->outgoing(5));
      QCOMPARE(path(*mesh, 5, to, mode)->points, (std::vector<EdgePoint>{{5, -1, 0}, {to, -1, 0}}));
    }
  }

  void aPathOnAPlaneIsTheStraightLine() {
    const Index n = 20;
    const MeshPtr mesh = shapes::grid(n);
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
      const auto ends = randomVertices(*mesh, 2, random);
      const auto found = path(*mesh, ends[0], ends[1]);
      const double distance = (mesh->point(ends[1]) - mesh->point(ends[0])).norm();
      QVERIFY2(std::abs(found->length - distance) <= 1e-11 * distance, qPrintable(QString::number(i)));
      QVERIFY(faultOf(*mesh, *found).isEmpty());
    }
  }

  void aStraightLineThroughVerticesPassesThem() {
    const Index n = 8;
    const MeshPtr mesh = shapes::grid(n);  // the other diagonal crosses the cells' diagonals at their middle
    const auto found = path(*mesh, n, n * (n + 1));
    QCOMPARE(found->points.size(), std::size_t{2 * n + 1});
    for (std::size_t i = 0; i < found->points.size(); ++i) {
      QCOMPARE(found->points[i].isVertex(), i % 2 == 0);
    }
  }

  void aPathBendsRoundAHoleAlongItsBorder() {
    // A 10×10 grid without its middle 6×6 cells: from the middle of the left side to that of the right.
    const Index n = 10;
    const MeshPtr full = shapes::grid(n);
    std::vector<Face> faces;
    for (Index f = 0; f < full->faceCount(); ++f) {
      const Index i = (f / 2) % n;
      const Index j = (f / 2) / n;
      if (i < 2 || i >= 8 || j < 2 || j >= 8) {
        faces.push_back(full->face(f));
      }
    }
    const MeshPtr mesh = meshOf(full->points(), faces);
    const auto found = path(*mesh, 5 * (n + 1), 5 * (n + 1) + n);
    const double expected = 0.6 + 2 * std::hypot(0.2, 0.3);
    QVERIFY(std::abs(found->length - expected) < 1e-12);
    QVERIFY(faultOf(*mesh, *found).isEmpty());
  }

  void straightenedPathsAreWithinATenthOfAPercentOfExact_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::newRow("sphere") << shapes::icosphere(4);
    QTest::newRow("torus") << shapes::torus(60, 24);
    QTest::newRow("flat torus") << shapes::torus(80, 12, 0.1);
    for (const std::string& name : samples::kModels) {
      if (name != "head.obj" && name != "nefertiti.ply") {  // too long for CGAL here: see the benchmark
        QTest::newRow(name.c_str()) << samples::model(name);
      }
    }
  }

  void straightenedPathsAreWithinATenthOfAPercentOfExact() {
    QFETCH(MeshPtr, mesh);
    const auto over = excesses(*mesh, 4, 25, PathMode::Straightened);
    const auto good = std::count_if(over.begin(), over.end(), [](double e) { return e <= 1e-3; });
    qInfo("%d of %d pairs within 0.1 %%, worst %.4f %%", static_cast<int>(good),
          static_cast<int>(over.size()), 100 * over.back());
    QVERIFY(over.front() > -1e-9);  // never shorter than exact
    QVERIFY(static_cast<double>(good) >= 0.99 * static_cast<double>(over.size()));
  }

  void paperPathsAreCloseToExact_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::addColumn<double>("share");  // of pairs within half a percent
    // The refinement stays on the side of a bump where the edge graph's path ran: the rest of the pairs.
    QTest::newRow("sphere") << shapes::icosphere(3) << 1.0;
    QTest::newRow("torus") << shapes::torus(40, 16) << 0.8;
    QTest::newRow("bottle") << samples::model("bottle.ply") << 0.8;
  }

  void paperPathsAreCloseToExact() {
    QFETCH(MeshPtr, mesh);
    QFETCH(double, share);
    const auto over = excesses(*mesh, 3, 10, PathMode::Paper);
    const auto good = std::count_if(over.begin(), over.end(), [](double e) { return e <= 5e-3; });
    qInfo("%d of %d pairs within 0.5 %%, median %.4f %%, worst %.4f %%", static_cast<int>(good),
          static_cast<int>(over.size()), 100 * over[over.size() / 2], 100 * over.back());
    QVERIFY(over.front() > -1e-9);
    QVERIFY(over[over.size() / 2] <= 2e-3);
    QVERIFY(static_cast<double>(good) >= share * static_cast<double>(over.size()));
  }

  void onlyNonSingularVerticesAreUsed() {
    // Two squares of four triangles each that touch in the vertex 4, and a third row that joins them.
    std::vector<Point> points;
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 5; ++i) {
        points.emplace_back(i, j, 0);
      }
    }
    std::vector<Face> faces;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 4; ++i) {
        const int a = 5 * j + i;
        if (j == 1 && i == 1) continue;  // a hole of one cell …
        if (j == 0 && i == 2) continue;  // … and one diagonal to it: vertex 7 is singular
        faces.push_back({a, a + 1, a + 6});
        faces.push_back({a, a + 6, a + 5});
      }
    }
    const MeshPtr mesh = meshOf(points, faces);
    QVERIFY(mesh->singular(7));
    // The only ways from left to right lead through vertex 7 or do not exist.
    const auto none = findPath(*mesh, 0, 4, PathMode::Straightened, {});
    QVERIFY(!none);
    QCOMPARE(none.error().code, ErrorCode::PathImpossible);
    for (const PathMode mode : {PathMode::Paper, PathMode::Straightened}) {
      const auto found = path(*mesh, 0, 6, mode);
      QVERIFY(faultOf(*mesh, *found).isEmpty());
    }
  }

  void aPathKeepsOffASingularVertexThatItsEdgesMeet() {
    // A fan of six triangles round vertex 0, and a seventh triangle that touches it there: 0 is singular, and
    // yet the way from 1 to 4 across the fan is open.
    std::vector<Point> points = {{0, 0, 0}};
    for (int i = 0; i < 6; ++i) {
      points.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0);
    }
    points.insert(points.end(), {{1, 0, 2}, {0, 1, 2}});
    std::vector<Face> faces = {{0, 7, 8}};
    for (Index i = 0; i < 6; ++i) {
      faces.push_back({0, i + 1, (i + 1) % 6 + 1});
    }
    const MeshPtr mesh = meshOf(points, faces);
    QVERIFY(mesh->singular(0));
    for (const PathMode mode : {PathMode::Paper, PathMode::Straightened}) {
      const auto found = path(*mesh, 1, 4, mode);
      QVERIFY(faultOf(*mesh, *found).isEmpty());
      QVERIFY(found->length <= 3 + 1e-12);
    }
  }

  void sliversAndDegenerateTrianglesDoNoHarm() {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> anywhere(0, 1);
    MeshPtr grid = shapes::grid(12);
    std::vector<Point> points = grid->points();
    for (Point& p : points) {
      p.y() *= 1e-4;                      // needles
      p.x() = std::floor(p.x() * 4) / 4;  // triangles of no area, edges of no length
      p.z() = anywhere(random) < 0.3 ? 1e-7 : 0;
    }
    const MeshPtr mesh = meshOf(points, grid->faces());
    for (int i = 0; i < 100; ++i) {
      const auto ends = randomVertices(*mesh, 2, random);
      for (const PathMode mode : {PathMode::Paper, PathMode::Straightened}) {
        const auto found = path(*mesh, ends[0], ends[1], mode);
        QVERIFY(std::isfinite(found->length));
        QVERIFY2(faultOf(*mesh, *found).isEmpty(), faultOf(*mesh, *found).constData());
      }
    }
  }

  void differentComponentsAreImpossibleAndNamed() {
    std::vector<Point> points = octahedron()->points();
    std::vector<Face> faces = octahedron()->faces();
    for (int i = 0; i < 6; ++i) {
      points.push_back(points[static_cast<std::size_t>(i)] + Point(5, 0, 0));
    }
    for (int i = 0; i < 8; ++i) {
      const Face f = faces[static_cast<std::size_t>(i)];
      faces.push_back({f[0] + 6, f[1] + 6, f[2] + 6});
    }
    const MeshPtr mesh = meshOf(points, faces);
    const auto found = findPaths(*mesh, {0, 2, 7}, PathMode::Straightened, Side::Part, nullptr, {}, {});
    QVERIFY(!found);
    QCOMPARE(found.error().code, ErrorCode::PathImpossible);
    QVERIFY(found.error().side == Side::Part);
    QCOMPARE(found.error().cvs, (std::vector<int>{1, 2}));
    QCOMPARE(found.error().paths, std::vector<int>{1});
    QVERIFY(QString::fromStdString(found.error().message).contains("CV 1 to CV 2"));
  }

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

  void unchangedDirectPathsAreTakenOver() {
    const MeshPtr mesh = shapes::icosphere(3);
    std::mt19937 random(3);
    const std::vector<Index> cvs = randomVertices(*mesh, 6, random);
    const auto first = *loop(*mesh, cvs);
    const auto same = *findPaths(*mesh, cvs, PathMode::Straightened, Side::Base, first.get(), cvs, {});
    QVERIFY(same->paths == first->paths);
    QVERIFY(same->direct == first->direct);

    std::vector<Index> one = cvs;
    one[2] = mesh->to(mesh->outgoing(cvs[2]));
    const auto changed = *findPaths(*mesh, one, PathMode::Straightened, Side::Base, first.get(), cvs, {});
    for (std::size_t i = 0; i < cvs.size(); ++i) {
      QCOMPARE(changed->direct[i] == first->direct[i], i != 1 && i != 2);
    }
    const auto fresh = *loop(*mesh, one);
    QVERIFY(samePoints(*changed, *fresh));

    std::vector<Index> inserted = cvs;
    inserted.insert(inserted.begin() + 1, one[2]);
    const auto longer = *findPaths(*mesh, inserted, PathMode::Straightened, Side::Base, first.get(), cvs, {});
    QVERIFY(longer->direct[2] == first->direct[1]);
    const auto freshLonger = *loop(*mesh, inserted);
    QVERIFY(samePoints(*longer, *freshLonger));
  }

  void theNumberOfThreadsChangesNoBit() {
    const MeshPtr mesh = samples::model("spot.obj");
    std::mt19937 random(13);
    for (int i = 0; i < 5; ++i) {
      const auto cvs = randomVertices(*mesh, 8, random);
      setThreadCount(1);
      const auto one = *loop(*mesh, cvs);
      setThreadCount(2);
      const auto two = *loop(*mesh, cvs);
      setThreadCount(0);
      QVERIFY(samePoints(*one, *two));
    }
  }

  void sizeAndPlaceOfTheModelDoNotMatter() {
    const MeshPtr mesh = shapes::icosphere(3);
    std::mt19937 random(14);
    // Powers of two leave all bits of the coordinates: then the points are the same to the bit.
    const MeshPtr tiny = moved(*mesh, std::ldexp(1, -30), Point::Zero());
    const MeshPtr huge = moved(*mesh, std::ldexp(1, 30), Point::Zero());
    const MeshPtr far = moved(*mesh, 1e-4, {100, 200, 300});
    const MeshPtr large = moved(*mesh, 1e6, Point::Zero());
    for (int i = 0; i < 10; ++i) {
      const auto cvs = randomVertices(*mesh, 6, random);
      const auto expected = *loop(*mesh, cvs);
      for (const MeshPtr& other : {tiny, huge}) {
        const auto found = *loop(*other, cvs);
        QVERIFY(samePoints(*expected, *found));
      }
      for (const MeshPtr& other : {far, large}) {
        QCOMPARE(faultOfLoop(*other, cvs), QByteArray());
      }
      const auto scaled = *loop(*large, cvs);
      for (std::size_t k = 0; k < cvs.size(); ++k) {
        QVERIFY(std::abs(scaled->direct[k]->length / (1e6 * expected->direct[k]->length) - 1) < 1e-3);
      }
    }
  }

  void aGridFarAwayHasTheSamePathsUpToRounding() {
    const Index n = 10;
    const MeshPtr mesh = shapes::grid(n);
    const MeshPtr far = moved(*mesh, 1e-4, {100, 200, 300});
    const MeshPtr large = moved(*mesh, 1e6, Point::Zero());
    std::mt19937 random(15);
    for (int i = 0; i < 50; ++i) {
      const auto ends = randomVertices(*mesh, 2, random);
      const auto expected = path(*mesh, ends[0], ends[1]);
      for (const MeshPtr& other : {far, large}) {
        const auto found = path(*other, ends[0], ends[1]);
        QCOMPARE(found->points.size(), expected->points.size());
        for (std::size_t k = 0; k < found->points.size(); ++k) {
          QCOMPARE(found->points[k].vertex, expected->points[k].vertex);
          QCOMPARE(found->points[k].halfedge, expected->points[k].halfedge);
          QVERIFY(std::abs(found->points[k].t - expected->points[k].t) < 1e-6);
        }
      }
    }
  }

  void cancellingAtAnyCallGivesCancelled() {
    const MeshPtr mesh = shapes::icosphere(5);
    std::mt19937 random(16);
    const auto cvs = randomVertices(*mesh, 8, random);
    for (const PathMode mode : {PathMode::Straightened, PathMode::Paper}) {
      int calls = 0;
      const auto count = [&](double) { return ++calls, true; };
      const auto zero = std::chrono::steady_clock::duration::zero();
      QVERIFY(findPaths(*mesh, cvs, mode, Side::Base, nullptr, {}, Progress(count, zero)));
      QVERIFY(calls > 10);
      const int all = calls;
      const int step = mode == PathMode::Paper ? std::max(1, all / 12) : std::max(1, all / 40);
      for (int k = 1; k <= all; k += step) {
        int left = k;
        const auto stop = [&](double) { return --left > 0; };
        setThreadCount(1);
        const auto found = findPaths(*mesh, cvs, mode, Side::Base, nullptr, {}, Progress(stop, zero));
        setThreadCount(0);
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::Cancelled);
      }
    }
  }
};

QTEST_APPLESS_MAIN(PathsTest)
#include "paths_test.moc"
