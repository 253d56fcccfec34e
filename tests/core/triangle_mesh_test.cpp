#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/mesh/triangle_mesh.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

std::vector<Point> somePoints(int count) {
  return std::vector<Point>(static_cast<std::size_t>(count), Point(1, 2, 3));
}

// What the class promises, from its definition.
void requireConsistent(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, std::vector<Index>> edges;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    edges[std::minmax({mesh.from(h), mesh.to(h)})].push_back(h);
  }
  std::vector<bool> singular(static_cast<std::size_t>(mesh.vertexCount()), false);
  for (const auto& [ends, halfedges] : edges) {
    const bool regular = halfedges.size() == 2 && mesh.from(halfedges[0]) != mesh.from(halfedges[1]);
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      QCOMPARE(mesh.twin(halfedges[i]), regular ? halfedges[1 - i] : -1);
    }
    if (halfedges.size() > 1 && !regular) {
      singular[static_cast<std::size_t>(ends.first)] = singular[static_cast<std::size_t>(ends.second)] = true;
    }
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    std::size_t leaving = 0;
    for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
      leaving += mesh.from(h) == v ? 1 : 0;
    }
    std::size_t reached = 0;
    const Index first = mesh.outgoing(v);
    QCOMPARE(first < 0, leaving == 0);
    for (Index h = first; h >= 0 && (reached == 0 || h != first); h = mesh.twin(TriangleMesh::prev(h))) {
      QCOMPARE(mesh.from(h), v);
      ++reached;
    }
    const bool oneFan = reached > 0 && reached == leaving;
    QCOMPARE(mesh.singular(v), singular[static_cast<std::size_t>(v)] || !oneFan);
  }
}

}  // namespace

class TriangleMeshTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void halfedgesLeadRoundTheirFace() {
    const TriangleMesh mesh(somePoints(4), {{0, 1, 2}, {2, 1, 3}});
    QCOMPARE(mesh.halfedgeCount(), 6);
    QCOMPARE(mesh.from(4), 1);
    QCOMPARE(mesh.to(4), 3);
    QCOMPARE(mesh.to(5), 2);
    for (Index h = 0; h < 6; ++h) {
      QCOMPARE(TriangleMesh::prev(TriangleMesh::next(h)), h);
      QCOMPARE(TriangleMesh::faceOf(TriangleMesh::next(h)), TriangleMesh::faceOf(h));
      QCOMPARE(mesh.from(TriangleMesh::next(h)), mesh.to(h));
    }
    QCOMPARE(mesh.twin(1), 3);
    QCOMPARE(mesh.twin(3), 1);
    QCOMPARE(mesh.twin(0), -1);
  }

  void whateverTheConnectivityTwinsFansAndSingularVerticesFollowTheDefinition() {
    requireConsistent(*shapes::grid(3));
    requireConsistent(*shapes::torus(5, 4));
    requireConsistent(*shapes::icosphere(1));
    std::mt19937 random(1);  // NOLINT: the same on every run
    for (int trial = 0; trial < 300; ++trial) {
      const auto vertices = 3 + random() % 8;
      std::vector<Face> faces;
      for (auto left = random() % 14; left > 0; --left) {
        Face face = {};
        while (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
          for (Index& v : face) {
            v = static_cast<Index>(random() % vertices);
          }
        }
        faces.push_back(face);
      }
      requireConsistent(TriangleMesh(somePoints(static_cast<int>(vertices)), faces));
    }
  }

  void aFanOnTheBorderBeginsAtItsHalfedgeWithoutTwin() {
    const auto mesh = shapes::grid(3);
    for (Index v = 0; v < mesh->vertexCount(); ++v) {
      const Index i = v % 4;
      const Index j = v / 4;
      const bool onBorder = i == 0 || i == 3 || j == 0 || j == 3;
      QCOMPARE(mesh->onBorder(v), onBorder);
      QCOMPARE(mesh->twin(mesh->outgoing(v)) < 0, onBorder);
    }
  }

  void findsTheHalfedgeBetweenTwoVertices() {
    const auto mesh = shapes::grid(3);
    for (Index h = 0; h < mesh->halfedgeCount(); ++h) {
      QCOMPARE(mesh->halfedgeBetween(mesh->from(h), mesh->to(h)), h);
      if (mesh->twin(h) < 0) {
        QCOMPARE(mesh->halfedgeBetween(mesh->to(h), mesh->from(h)), -1);
      }
    }
    QCOMPARE(mesh->halfedgeBetween(0, 15), -1);
    QCOMPARE(TriangleMesh(somePoints(1), {}).halfedgeBetween(0, 0), -1);
  }

  void theDiagonalIsThatOfTheUsedVertices() {
    const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 2, 2}, {9, 9, 9}}, {{0, 1, 2}});
    QCOMPARE(mesh.diagonal(), 3.0);
    QCOMPARE(TriangleMesh({{0, 0, 0}, {1, 0, 0}}, {}).diagonal(), 0.0);
    QCOMPARE(TriangleMesh().vertexCount(), 0);
  }

  void aVertexOfManyFacesCostsNoMoreThanTheyAre() {
    // A closed double cone: each apex has all of the rim's faces.
    constexpr Index kRim = 200000;
    std::vector<Face> faces;
    for (Index i = 0; i < kRim; ++i) {
      const Index next = (i + 1) % kRim;
      faces.push_back({i, next, kRim});
      faces.push_back({next, i, kRim + 1});
    }
    const TriangleMesh mesh(somePoints(kRim + 2), std::move(faces));
    for (const Index v : {0, kRim - 1, kRim, kRim + 1}) {
      QVERIFY(!mesh.singular(v) && !mesh.onBorder(v));
    }
    Index around = 0;
    Index h = mesh.outgoing(kRim);
    do {
      ++around;
      h = mesh.twin(TriangleMesh::prev(h));
    } while (h != mesh.outgoing(kRim));
    QCOMPARE(around, kRim);
  }
};

QTEST_APPLESS_MAIN(TriangleMeshTest)
#include "triangle_mesh_test.moc"
