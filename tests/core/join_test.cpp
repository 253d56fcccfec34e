#include <QtTest>
#include <algorithm>
#include <cstring>

#include "core/fusion/join.h"
#include "core/fusion/paths.h"
#include "core/fusion/tile.h"
#include "tests/support/cut_checks.h"
#include "tests/support/embeddings.h"
#include "tests/support/loops.h"
#include "tests/support/shapes.h"

using namespace graftsman;
using checks::at;

namespace {

/// One mesh divided along its loop.
struct Prepared {
  TriangleMesh mesh;
  Cut cut;
  Tile tile;
};

Prepared prepared(TriangleMesh mesh, const LoopPaths& loop) {
  Cut cut = cutMesh(mesh, loop);
  auto tile = gatherTile(mesh, cut, Side::Base, {.allowLargeTile = true}, {});
  if (!tile) {
    throw std::runtime_error(tile.error().message);
  }
  return {std::move(mesh), std::move(cut), std::move(*tile)};
}

Prepared prepared(const TriangleMesh& mesh, const std::vector<Index>& cvs) {
  const auto loop = findPaths(mesh, cvs, PathMode::Straightened, Side::Base, nullptr, {}, {});
  if (!loop) {
    throw std::runtime_error(loop.error().message);
  }
  return prepared(mesh, **loop);
}

struct Joined {
  CombinedTile combined;
  Join join;
};

Joined joined(const Prepared& base, const EmbeddedTile& part) {
  const Embedding embedding = shapes::embedded(base.tile);
  auto combined = overlay(part, {base.tile.points, embedding}, {});
  if (!combined) {
    throw std::runtime_error(combined.error().message);
  }
  Join join = graftsman::join(base.mesh, base.cut, base.tile, *combined);
  return {std::move(*combined), std::move(join)};
}

long euler(const TriangleMesh& mesh) {
  return checks::eulerCharacteristic(mesh);
}

bool sameBits(const Point& a, const Point& b) {
  return std::memcmp(a.data(), b.data(), sizeof(Point)) == 0;
}

// What the contract says of the numbering and of the faces' parents.
void verifyNumbers(const Prepared& base, const Joined& j) {
  const Join& join = j.join;
  QVERIFY(std::is_sorted(join.baseVertices.begin(), join.baseVertices.end()));
  std::vector<bool> inside(base.mesh.points().size(), false);
  for (std::size_t v = at(base.tile.boundarySize); v < base.tile.vertices.size(); ++v) {
    inside[at(base.tile.vertices[v])] = true;
  }
  QCOMPARE(join.baseVertices.size(),
           static_cast<std::size_t>(std::count(inside.begin(), inside.end(), false)));
  for (std::size_t v = 0; v < join.baseVertices.size(); ++v) {
    QVERIFY(!inside[at(join.baseVertices[v])]);
    QVERIFY(sameBits(join.points[v], base.mesh.point(join.baseVertices[v])));
  }
  QCOMPARE(join.tileVertices.size(), j.combined.base.size());
  Index next = static_cast<Index>(join.baseVertices.size());
  for (std::size_t v = 0; v < join.tileVertices.size(); ++v) {
    QVERIFY(sameBits(join.points[at(join.tileVertices[v])], j.combined.base[v]));
    if (join.tileVertices[v] >= static_cast<Index>(join.baseVertices.size())) {
      QCOMPARE(join.tileVertices[v], next++);
    } else {
      QVERIFY(v < at(j.combined.seamSize));
    }
  }
  QCOMPARE(at(next), join.points.size());
  QCOMPARE(join.baseFaces.size(), at(join.restFaces));
  QCOMPARE(join.faces.size(), at(join.restFaces) + j.combined.faces.size());
  QVERIFY(std::is_sorted(join.baseFaces.begin(), join.baseFaces.begin() + join.wholeFaces));
  for (std::size_t f = 0; f < at(join.restFaces); ++f) {
    const Face& parent = base.mesh.face(join.baseFaces[f]);
    if (f < at(join.wholeFaces)) {
      for (std::size_t k = 0; k < 3; ++k) {
        QCOMPARE(join.baseVertices[at(join.faces[f][k])], parent[k]);
      }
      continue;
    }
    const Point normal = (base.mesh.point(parent[1]) - base.mesh.point(parent[0]))
                             .cross(base.mesh.point(parent[2]) - base.mesh.point(parent[0]));
    const Point& a = join.points[at(join.faces[f][0])];
    const Point own = (join.points[at(join.faces[f][1])] - a).cross(join.points[at(join.faces[f][2])] - a);
    QVERIFY(own.dot(normal) > 0);
    QVERIFY(own.cross(normal).norm() < 1e-9 * normal.squaredNorm());
  }
}

void verify(const Prepared& base, const Joined& j) {
  verifyNumbers(base, j);
  const TriangleMesh result(j.join.points, j.join.faces);
  QCOMPARE(euler(result), euler(base.mesh));
  for (Index v = 0; v < result.vertexCount(); ++v) {
    if (result.outgoing(v) >= 0) {
      QVERIFY(!result.singular(v));
    } else {
      QVERIFY(base.mesh.outgoing(j.join.baseVertices[at(v)]) < 0);
    }
  }
  const double area = checks::area(base.mesh);
  QVERIFY(std::abs(checks::area(result) - area) < 1e-9 * area);
}

long borderEdges(const TriangleMesh& mesh) {
  return checks::borderEdges(mesh);
}

}  // namespace

class JoinTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theResultIsTheBaseWithTheCombinedTileInPlaceOfTheTile() {
    const auto grid = shapes::grid(8);
    const Prepared base = prepared(*grid, loops::polygon(*grid, 8, {{1, 1}, {7, 2}, {6, 7}, {2, 5}}));
    QVERIFY(!base.cut.faces.empty());
    for (const Index perSide : {0, 1, 7, 40}) {
      const auto part = shapes::randomTile(3, 4, perSide, 60);
      const Joined j = joined(base, part.view());
      verify(base, j);
      const TriangleMesh result(j.join.points, j.join.faces);
      QCOMPARE(borderEdges(result), borderEdges(*grid));
      for (const auto& [a, b, c] : j.join.faces) {
        const Point normal =
            (j.join.points[at(b)] - j.join.points[at(a)]).cross(j.join.points[at(c)] - j.join.points[at(a)]);
        QVERIFY(normal.z() > -1e-15);
      }
    }
  }

  void aClosedBaseStaysClosed() {
    const auto sphere = shapes::icosphere(3);
    for (const std::vector<Index>& cvs : {std::vector<Index>{0, 5, 11}, {1, 60, 9, 130, 7}, {12, 13, 14}}) {
      Prepared base = prepared(*sphere, cvs);
      const auto part = shapes::randomTile(5, static_cast<Index>(cvs.size()), 13, 200);
      const Joined j = joined(base, part.view());
      verify(base, j);
      QCOMPARE(borderEdges(TriangleMesh(j.join.points, j.join.faces)), 0L);
    }
  }

  void aSeamAlongEdgesDividesOnlyFacesBesideThePartsVertices() {
    const auto grid = shapes::grid(4);
    const Prepared base = prepared(*grid, loops::throughVertices({6, 7, 8, 13, 18, 17, 16, 11}));
    auto part = shapes::randomTile(5, 8, 0, 20);
    const Joined none = joined(base, part.view());
    verify(base, none);
    QCOMPARE(none.join.restFaces, none.join.wholeFaces);
    QCOMPARE(none.join.restFaces, Index(24));
    part = shapes::randomTile(5, 8, 2, 20);
    const Joined j = joined(base, part.view());
    verify(base, j);
    QCOMPARE(j.join.wholeFaces, Index(16));
    QCOMPARE(j.join.restFaces, Index(16 + 8 * 3));
  }

  void theSeamMayRunAlongTheBorder() {
    const auto grid = shapes::grid(4);
    const Prepared base =
        prepared(*grid, loops::throughVertices({0, 1, 2, 3, 4, 9, 14, 19, 24, 23, 22, 21, 20, 15, 10, 5}));
    const auto part = shapes::randomTile(5, 16, 2, 40);
    const Joined j = joined(base, part.view());
    verify(base, j);
    QCOMPARE(j.join.restFaces, Index(0));
    QCOMPARE(borderEdges(TriangleMesh(j.join.points, j.join.faces)), 16 * 3L);
    const Prepared half = prepared(*grid, loops::polygon(*grid, 4, {{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
    const auto square = shapes::randomTile(6, 4, 3, 40);
    verify(half, joined(half, square.view()));
  }

  void aRemainderFaceMayHaveAllItsEdgesOnTheSeam() {
    const auto sphere = shapes::icosphere(1);
    const auto [a, b, c] = sphere->face(7);
    const Prepared base = prepared(*sphere, loops::throughVertices({a, c, b}));
    const auto part = shapes::randomTile(6, 3, 4, 40);
    const Joined j = joined(base, part.view());
    verify(base, j);
    QCOMPARE(j.join.wholeFaces, Index(0));
    QCOMPARE(j.join.restFaces, Index(1 + 3 * 4));
    QCOMPARE(borderEdges(TriangleMesh(j.join.points, j.join.faces)), 0L);
  }

  void isolatedAndSingularVerticesElsewhereStay() {
    const auto grid = shapes::grid(6);
    std::vector<Point> points = grid->points();
    std::vector<Face> faces = grid->faces();
    const auto first = static_cast<Index>(points.size());
    points.insert(points.begin(), Point(9, 9, 9));  // isolated, before all others
    for (Face& face : faces) {
      for (Index& v : face) {
        ++v;
      }
    }
    points.emplace_back(-1, 0, 0);
    points.emplace_back(-1, 1, 0);
    faces.push_back({first + 1, first + 2, 1});  // meets the grid in one vertex
    const TriangleMesh mesh(points, faces);
    QVERIFY(mesh.singular(1));
    std::vector<Index> loop;
    for (const Index v : {16, 17, 18, 25, 32, 31, 30, 23}) {
      loop.push_back(v + 1);
    }
    const Prepared base = prepared(mesh, loops::throughVertices(loop));
    const auto part = shapes::randomTile(6, 8, 1, 40);
    const Joined j = joined(base, part.view());
    verifyNumbers(base, j);
    const TriangleMesh result(j.join.points, j.join.faces);
    QCOMPARE(euler(result), euler(mesh));
    QCOMPARE(result.outgoing(0), Index(-1));
    QVERIFY(result.singular(1));
  }

  void theSameInputsGiveTheSameBits() {
    const auto sphere = shapes::icosphere(3);
    const Prepared base = prepared(*sphere, {0, 5, 11});
    const auto part = shapes::randomTile(5, 3, 13, 200);
    const Join one = joined(base, part.view()).join;
    const Join two = joined(base, part.view()).join;
    QCOMPARE(one.faces, two.faces);
    QCOMPARE(one.points, two.points);
    QCOMPARE(one.baseFaces, two.baseFaces);
  }
};

QTEST_APPLESS_MAIN(JoinTest)
#include "join_test.moc"
