#include <QtTest>

#include "tests/support/cut_checks.h"
#include "tests/support/loops.h"
#include "tests/support/shapes.h"

using namespace graftsman;
using loops::between;
using loops::vertex;

namespace {

Result<Tile> gather(const TriangleMesh& mesh, const LoopPaths& loop, Side side = Side::Part,
                    const TileOptions& options = {}, const Progress& progress = {}) {
  return gatherTile(mesh, cutMesh(mesh, loop), side, options, progress);
}

/// What is wrong with the tile left of the loop; an error's message if there is none.
QByteArray fault(const TriangleMesh& mesh, const LoopPaths& loop) {
  const Cut cut = cutMesh(mesh, loop);
  const auto tile = gatherTile(mesh, cut, Side::Part, {}, {});
  return QByteArray::fromStdString(tile ? checks::tileFault(mesh, cut, *tile) : tile.error().message);
}

double area(const Tile& tile) {
  return checks::area(TriangleMesh(tile.points, tile.faces));
}

/// The mesh less some faces.
TriangleMesh without(const TriangleMesh& mesh, const std::vector<Index>& holes) {
  std::vector<Face> faces;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    if (std::find(holes.begin(), holes.end(), f) == holes.end()) {
      faces.push_back(mesh.face(f));
    }
  }
  return {mesh.points(), std::move(faces)};
}

std::vector<Index> backwards(std::vector<Index> vertices) {
  std::reverse(vertices.begin() + 1, vertices.end());
  return vertices;
}

bool mentions(const Error& error, const char* text) {
  return error.message.find(text) != std::string::npos;
}

/// A square round the vertex (2, 2) of grid(4), and the grid's whole border.
const std::vector<Index> kSquare = {6, 7, 8, 13, 18, 17, 16, 11};
const std::vector<Index> kRim = {0, 1, 2, 3, 4, 9, 14, 19, 24, 23, 22, 21, 20, 15, 10, 5};

}  // namespace

class TileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTileIsWhatLiesLeftOfTheLoop() {
    const auto mesh = shapes::grid(4);
    const LoopPaths loop = loops::throughVertices(kSquare);
    QCOMPARE(fault(*mesh, loop), QByteArray());
    const auto tile = gather(*mesh, loop);
    QCOMPARE(std::ssize(tile->faces), 8);
    QCOMPARE(std::ssize(tile->wholeFaces), 8);
    QCOMPARE(tile->vertices, std::vector<Index>({6, 7, 8, 13, 18, 17, 16, 11, 12}));
    QVERIFY(std::abs(area(*tile) - 0.25) < 1e-15);
  }

  void aLoopThroughFacesTakesTheirPiecesOnItsLeft() {
    const auto mesh = shapes::grid(8);
    const LoopPaths loop = loops::polygon(*mesh, 8, {{1, 2}, {7, 1}, {6, 7}, {2, 6}});
    QCOMPARE(fault(*mesh, loop), QByteArray());
    const double exact = (1 * 1 - 7 * 2 + 7 * 7 - 6 * 1 + 6 * 6 - 2 * 7 + 2 * 2 - 1 * 6) / 2.0 / 64;
    QVERIFY(std::abs(area(*gather(*mesh, loop)) - exact) < 1e-15);
  }

  void aLoopAlongTheMeshsOwnBorderTakesAllOfIt() {
    const auto mesh = shapes::grid(4);
    const LoopPaths loop = loops::throughVertices(kRim);
    QCOMPARE(fault(*mesh, loop), QByteArray());
    QVERIFY(std::abs(area(*gather(*mesh, loop, Side::Base)) - 1) < 1e-15);
  }

  void aLoopMayRunAlongTheBorderForAWhileAndTouchItElsewhere() {
    const auto mesh = shapes::grid(4);
    const LoopPaths along = loops::polygon(*mesh, 4, {{0, 0}, {4, 0}, {2, 3}});
    QCOMPARE(fault(*mesh, along), QByteArray());
    const LoopPaths touching = loops::polygon(*mesh, 4, {{2, 0}, {4, 3}, {0, 2}});
    QCOMPARE(fault(*mesh, touching), QByteArray());
    const LoopPaths partly = loops::fromChain(
        {vertex(5), between(*mesh, 0, 5, 0.5), between(*mesh, 0, 6, 0.5), vertex(6), vertex(11)}, {5, 6, 11});
    QCOMPARE(fault(*mesh, partly), QByteArray());
  }

  void aLoopRoundASingleFaceIsATileWithoutInterior() {
    const auto mesh = shapes::icosphere(1);
    const auto& [a, b, c] = mesh->face(7);
    const auto tile = gather(*mesh, loops::throughVertices({a, b, c}), Side::Base);
    QVERIFY(tile.has_value());
    QCOMPARE(tile->faces, std::vector<Face>({{0, 1, 2}}));
    QCOMPARE(tile->wholeFaces, std::vector<Index>({7}));
  }

  void coarseMeshesAreDividedIntoTheTileAndTheRest() {
    const TriangleMesh tetrahedron({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    const LoopPaths small =
        loops::fromChain({vertex(0), between(tetrahedron, 1, 2, 0.25), vertex(3), vertex(1)}, {0, 3, 1});
    const TriangleMesh octahedron(
        {Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(0, -1, 0), Point(0, 0, 1), Point(0, 0, -1)},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
    const LoopPaths equator = loops::throughVertices({0, 2, 1, 3});
    const LoopPaths tilted = loops::fromChain(
        {vertex(0), between(octahedron, 2, 4, 0.3), vertex(1), between(octahedron, 3, 5, 0.6)}, {0, 1});
    for (const auto& [mesh, loop] :
         {std::pair(tetrahedron, small), std::pair(tetrahedron, loops::doubleSpiral(tetrahedron, 50)),
          std::pair(octahedron, equator), std::pair(octahedron, tilted)}) {
      QCOMPARE(fault(mesh, loop), QByteArray());
      QCOMPARE(fault(mesh, loops::reversed(loop)), QByteArray());
      const double both = area(*gather(mesh, loop)) + area(*gather(mesh, loops::reversed(loop)));
      QVERIFY(std::abs(both - checks::area(mesh)) < 1e-12);
    }
  }

  void tileAndRestTogetherAreTheMesh() {
    const auto sphere = shapes::icosphere(3);
    for (unsigned seed = 0; seed < 60; ++seed) {
      const loops::AnchoredLoopPaths loop = loops::randomLoop(sphere, seed);
      const TriangleMesh& mesh = *loop.mesh;
      QCOMPARE(fault(mesh, loop.paths), QByteArray());
      QCOMPARE(fault(mesh, loops::reversed(loop.paths)), QByteArray());
      const Cut cut = cutMesh(mesh, loop.paths);
      const auto tile = gatherTile(mesh, cut, Side::Part, {}, {});
      const TriangleMesh rest = checks::assembled(
          mesh, cut,
          [&](Index f) { return !std::binary_search(tile->wholeFaces.begin(), tile->wholeFaces.end(), f); },
          [&](Index p) { return !std::binary_search(tile->pieces.begin(), tile->pieces.end(), p); });
      QCOMPARE(rest.faceCount() + std::ssize(tile->faces), checks::dividedMesh(mesh, cut).faceCount());
      QCOMPARE(checks::eulerCharacteristic(rest), 1L);
      QVERIFY(std::abs(checks::area(rest) + area(*tile) - checks::area(mesh)) < 1e-12);
    }
  }

  void randomPolygonsOnAGridHaveTheAreaOfThePolygon() {
    constexpr Index kSize = 12;
    const auto mesh = shapes::grid(kSize);
    std::mt19937 random(1);
    for (int round = 0; round < 100; ++round) {
      std::vector<std::pair<Index, Index>> corners;
      const int count = 3 + static_cast<int>(random() % 7);
      for (int i = 0; i < count; ++i) {
        const double angle =
            2 * std::numbers::pi * (i + 0.4 * static_cast<double>(random() % 100) / 100) / count;
        const double radius = 2.5 + 3.5 * static_cast<double>(random() % 100) / 100;
        corners.emplace_back(6 + std::lround(radius * std::cos(angle)),
                             6 + std::lround(radius * std::sin(angle)));
      }
      double exact = 0;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto [x, y] = corners[i];
        const auto [u, v] = corners[(i + 1) % corners.size()];
        exact += (x * v - u * y) / 2.0 / (kSize * kSize);
      }
      const LoopPaths loop = loops::polygon(*mesh, kSize, corners);
      QCOMPARE(fault(*mesh, loop), QByteArray());
      QVERIFY(std::abs(area(*gather(*mesh, loop)) - exact) < 1e-14);
    }
  }

  void aLoopRoundATubeDoesNotDivideTheSurface() {
    const auto mesh = shapes::torus(12, 8);
    const auto tile = gather(*mesh, loops::throughVertices({0, 1, 2, 3, 4, 5, 6, 7}), Side::Base);
    QCOMPARE(tile.error().code, ErrorCode::TileNotSeparated);
    QCOMPARE(tile.error().side, Side::Base);
    QVERIFY(mentions(tile.error(), "The loop on the base"));
  }

  void aClockwiseLoopOnATorusEnclosesItsHandle() {
    const auto mesh = shapes::torus(12, 8);
    const std::vector<Index> loop = {0, 8, 16, 17, 18, 10, 2, 1};  // counter-clockwise round vertex 9
    QCOMPARE(fault(*mesh, loops::throughVertices(loop)), QByteArray());
    const auto tile = gather(*mesh, loops::throughVertices(backwards(loop)));
    QCOMPARE(tile.error().code, ErrorCode::TileHasHandle);
    QVERIFY(mentions(tile.error(), "on the part encloses a handle"));
    QVERIFY(mentions(tile.error(), "Reverse it"));
  }

  void aLoopRoundAHandleOfTwoIsNotToldToBeReversed() {
    // Two tori joined by a tube in place of a face of each; the loop runs round the tube.
    const auto torus = shapes::torus(12, 8);
    std::vector<Point> points = torus->points();
    std::vector<Face> faces(torus->faces().begin() + 1, torus->faces().end());
    const auto [a, b, c] = torus->face(0);
    const Index count = torus->vertexCount();
    for (const Point& p : torus->points()) {
      points.emplace_back(-p.x() + 5, p.y(), p.z());
    }
    for (std::size_t f = 1; f < torus->faces().size(); ++f) {
      const auto [x, y, z] = torus->faces()[f];
      faces.push_back({count + x, count + z, count + y});
    }
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      faces.push_back({u, v, count + v});
      faces.push_back({u, count + v, count + u});
    }
    const TriangleMesh mesh(std::move(points), std::move(faces));
    QCOMPARE(checks::eulerCharacteristic(mesh), -2L);
    const auto tile = gather(mesh, loops::throughVertices({a, b, c}));
    QCOMPARE(tile.error().code, ErrorCode::TileHasHandle);
    QVERIFY(!mentions(tile.error(), "everse"));
  }

  void aHoleInsideIsNamedByAVertexOfItsBorder() {
    const auto grid = shapes::grid(6);
    const Index middle = 3 * 7 + 3;  // the first corner of the face that is missing
    const TriangleMesh holed = without(*grid, {2 * (3 * 6 + 3)});
    const std::vector<std::pair<Index, Index>> square = {{1, 1}, {5, 1}, {5, 5}, {1, 5}};
    const auto tile = gather(holed, loops::polygon(holed, 6, square), Side::Base);
    QCOMPARE(tile.error().code, ErrorCode::TileHasHole);
    QVERIFY(mentions(tile.error(), ("vertex " + std::to_string(middle)).c_str()));
    QVERIFY(!mentions(tile.error(), "everse"));
  }

  void aClockwiseLoopOnAnOpenMeshEnclosesTheMeshsBorder() {
    const auto mesh = shapes::grid(4);
    const auto tile = gather(*mesh, loops::throughVertices(backwards(kSquare)), Side::Base);
    QCOMPARE(tile.error().code, ErrorCode::TileHasHole);
    QVERIFY(mentions(tile.error(), "Reverse it"));
  }

  void aClockwiseLoopAlongTheBorderHasNothingOnItsLeft() {
    const auto mesh = shapes::grid(4);
    const auto tile = gather(*mesh, loops::throughVertices(backwards(kRim)), Side::Base);
    QCOMPARE(tile.error().code, ErrorCode::TileEmpty);
    QCOMPARE(tile.error().cvs, std::vector<int>({0, 1}));
    QCOMPARE(tile.error().paths, std::vector<int>({0}));
    QVERIFY(mentions(tile.error(), "Reverse it"));
    const auto last = gather(*mesh, loops::throughVertices({0, 6, 1}));
    QCOMPARE(last.error().code, ErrorCode::TileEmpty);
    QCOMPARE(last.error().cvs, std::vector<int>({2, 0}));
  }

  void aSingularVertexInsideIsNamed() {
    // Two fans touch at vertex 12 of the grid: faces on opposite sides of it are missing.
    const auto grid = shapes::grid(4);
    std::vector<Index> missing;
    for (Index f = 0; f < grid->faceCount(); ++f) {
      const Face& face = grid->face(f);
      const bool at = std::find(face.begin(), face.end(), 12) != face.end();
      const bool above = std::find(face.begin(), face.end(), 17) != face.end();
      const bool below = std::find(face.begin(), face.end(), 7) != face.end();
      if (at && (above || below)) {
        missing.push_back(f);
      }
    }
    const TriangleMesh mesh = without(*grid, missing);
    QVERIFY(mesh.singular(12));
    const auto tile = gather(mesh, loops::throughVertices(kRim), Side::Base);
    QCOMPARE(tile.error().code, ErrorCode::TileNotManifold);
    QVERIFY(mentions(tile.error(), "encloses vertex 12,"));
  }

  void aSingularVertexOnTheLoopIsNamed() {
    const TriangleMesh mesh(
        {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(-1, 0, 0), Point(0, -1, 0)},
        {{0, 1, 2}, {0, 3, 4}});
    const auto tile = gather(mesh, loops::throughVertices({1, 2, 0}), Side::Part);
    QCOMPARE(tile.error().code, ErrorCode::TileNotManifold);
    QVERIFY(mentions(tile.error(), "passes vertex 0,"));
  }

  void aBaseTileOfMostOfASphereIsTakenForClockwiseUnlessAllowed() {
    const auto mesh = shapes::icosphere(3);
    const auto& [a, b, c] = mesh->face(100);
    const LoopPaths loop = loops::throughVertices({a, c, b});
    const auto tile = gather(*mesh, loop, Side::Base);
    QCOMPARE(tile.error().code, ErrorCode::TileClockwise);
    QVERIFY(mentions(tile.error(), "encloses 99.9 % of a closed mesh"));
    QVERIFY(mentions(tile.error(), "allow a large tile"));
    QCOMPARE(std::ssize(gather(*mesh, loop, Side::Base, {.allowLargeTile = true})->faces), 1279);
    QCOMPARE(std::ssize(gather(*mesh, loop, Side::Part)->faces), 1279);
  }

  void aBaseTileOfMoreThanHalfOfATorusIsNotTakenForClockwise() {
    // The torus opened along one ring and one meridian, and a little more: what is left over has a handle.
    const auto mesh = shapes::torus(12, 8);
    std::vector<Index> loop;
    for (Index i = 1; i <= 10; ++i) {
      loop.push_back(i * 8 + 1);
    }
    for (Index j = 2; j <= 6; ++j) {
      loop.push_back(10 * 8 + j);
    }
    for (Index i = 9; i >= 1; --i) {
      loop.push_back(i * 8 + 6);
    }
    for (Index j = 5; j >= 2; --j) {
      loop.push_back(8 + j);
    }
    const auto tile = gather(*mesh, loops::throughVertices(loop), Side::Base);
    QVERIFY(tile.has_value());
    QCOMPARE(std::ssize(tile->faces), 2 * 9 * 5);
  }

  void anotherComponentDoesNotCount() {
    const auto sphere = shapes::icosphere(2);
    std::vector<Point> points = sphere->points();
    std::vector<Face> faces = sphere->faces();
    for (const Point& p : sphere->points()) {
      points.push_back(10 * p + Point(20, 0, 0));
    }
    for (const auto& [a, b, c] : sphere->faces()) {
      const Index n = sphere->vertexCount();
      faces.push_back({n + a, n + b, n + c});
    }
    const TriangleMesh mesh(std::move(points), std::move(faces));
    const auto& [a, b, c] = mesh.face(0);
    QCOMPARE(gather(mesh, loops::throughVertices({a, c, b}), Side::Base).error().code,
             ErrorCode::TileClockwise);
    QVERIFY(gather(mesh, loops::throughVertices({a, b, c}), Side::Base).has_value());
  }

  void itStopsWhenAsked() {
    const auto mesh = shapes::icosphere(3);
    const auto& [a, b, c] = mesh->face(0);
    const Progress stop([](double) { return false; }, std::chrono::seconds(0));
    const auto tile = gather(*mesh, loops::throughVertices({a, b, c}), Side::Base, {}, stop);
    QCOMPARE(tile.error().code, ErrorCode::Cancelled);
  }
};

QTEST_APPLESS_MAIN(TileTest)
#include "tile_test.moc"
