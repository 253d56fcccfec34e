#include "core/fusion/paths.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <QtTest>
#include <algorithm>
#include <numbers>
#include <random>

#include "core/base/parallel.h"
#include "tests/support/paths_meshes.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/simple_loop.h"

using namespace graftsman;

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

/// The mesh, each point multiplied and moved.
MeshPtr moved(const TriangleMesh& mesh, double scale, const Point& offset) {
  std::vector<Point> points = mesh.points();
  for (Point& p : points) {
    p = scale * p + offset;
  }
  return meshOf(std::move(points), mesh.faces());
}

QByteArray faultOf(const TriangleMesh& mesh, const Path& p) {
  return QByteArray::fromStdString(
      simple_loop::faultOf(mesh, p, p.points.front().vertex, p.points.back().vertex));
}

bool samePoints(const LoopPaths& a, const LoopPaths& b) {
  return std::equal(a.paths.begin(), a.paths.end(), b.paths.begin(), b.paths.end(),
                    [](const auto& p, const auto& q) { return p->points == q->points; });
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
