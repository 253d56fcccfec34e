#include <QtTest>
#include <limits>
#include <random>

#include "core/fusion/loop.h"
#include "core/mesh/barycentric.h"
#include "tests/support/cut_checks.h"
#include "tests/support/shapes.h"

using namespace graftsman;
using shapes::MeshPtr;

namespace {

SurfacePoint at(Index vertex) {
  return SurfacePoint::atVertex(vertex);
}

SurfacePoint inFace(Index face, double a, double b, double c) {
  return {-1, face, Eigen::Vector3d(a, b, c)};
}

Result<AnchoredLoop> anchor(const MeshPtr& mesh, const std::vector<SurfacePoint>& points,
                            Side side = Side::Base) {
  Loop loop;
  for (const SurfacePoint& p : points) {
    loop.push_back(side == Side::Base ? CVP{at(0), p} : CVP{p, at(0)});
  }
  return anchorLoop(mesh, loop, side);
}

ErrorCode errorOf(const MeshPtr& mesh, const std::vector<SurfacePoint>& points) {
  return anchor(mesh, points).error().code;
}

Point place(const TriangleMesh& mesh, const SurfacePoint& p) {
  if (p.vertex >= 0) {
    return mesh.point(p.vertex);
  }
  const auto& [a, b, c] = mesh.face(p.face);
  return p.bary.x() * mesh.point(a) + p.bary.y() * mesh.point(b) + p.bary.z() * mesh.point(c);
}

/// What breaks the promises of AnchoredLoop, or nothing.
QByteArray fault(const MeshPtr& given, const std::vector<SurfacePoint>& points) {
  const auto anchored = anchor(given, points);
  if (!anchored) {
    return QByteArray::fromStdString(anchored.error().message);
  }
  const TriangleMesh& mesh = *anchored->mesh;
  if (!std::equal(given->points().begin(), given->points().end(), mesh.points().begin())) {
    return "an old vertex changed";
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off = (mesh.point(anchored->cvs[i]) - place(*given, points[i])).norm();
    if (off > 1e-15 * (given->diagonal() + mesh.point(anchored->cvs[i]).norm())) {
      return "a CV is not where it was picked";
    }
  }
  std::vector<double> areas(given->faces().size(), 0);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Index parent = anchored->parents[static_cast<std::size_t>(f)];
    const bool old = f < given->faceCount();
    if (old && parent != f) {
      return "an old face got another parent";
    }
    const auto& [a, b, c] = mesh.face(f);
    areas[static_cast<std::size_t>(parent)] += checks::area(mesh.point(a), mesh.point(b), mesh.point(c));
  }
  for (Index f = 0; f < given->faceCount(); ++f) {
    const auto& [a, b, c] = given->face(f);
    const double whole = checks::area(given->point(a), given->point(b), given->point(c));
    if (std::abs(areas[static_cast<std::size_t>(f)] - whole) > 1e-13 * whole) {
      return "the pieces do not fill their parent";
    }
  }
  if (!std::is_sorted(anchored->parents.begin() + given->faceCount(), anchored->parents.end())) {
    return "the new pieces are not in their parents' order";
  }
  if (checks::eulerCharacteristic(mesh) != checks::eulerCharacteristic(*given)) {
    return "the Euler characteristic changed";
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.singular(v)) {
      return "a vertex became singular";
    }
  }
  return {};
}

/// A grid's face 8 has the corners 4, 5, 9 (n = 3); see shapes::grid.
const MeshPtr kGrid = shapes::grid(3);

}  // namespace

class AnchorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aLoopOfVerticesKeepsTheMeshItself() {
    const auto anchored = anchor(kGrid, {at(5), at(6), at(10)});
    QCOMPARE(anchored->mesh.get(), kGrid.get());
    QCOMPARE(anchored->cvs, std::vector<Index>({5, 6, 10}));
    QVERIFY(anchored->parents.empty());
  }

  void aWeightOfOneMeansTheVertex() {
    const auto& [a, b, c] = kGrid->face(4);
    const auto anchored =
        anchor(kGrid, {inFace(4, 1, 0, 0), inFace(4, 0, 1 + 1e-9, 0), inFace(4, 1e-20, 0, 1)});
    QCOMPARE(anchored->mesh.get(), kGrid.get());
    QCOMPARE(anchored->cvs, std::vector<Index>({a, b, c}));
  }

  void aPointInAFaceDividesItInThree() {
    const std::vector<SurfacePoint> points = {at(0), inFace(8, 0.2, 0.3, 0.5), at(3)};
    QCOMPARE(fault(kGrid, points), QByteArray());
    const auto anchored = anchor(kGrid, points);
    QCOMPARE(anchored->cvs, std::vector<Index>({0, 16, 3}));
    QCOMPARE(anchored->mesh->faceCount(), kGrid->faceCount() + 2);
    QCOMPARE(std::count(anchored->parents.begin(), anchored->parents.end(), 8), 3);
  }

  void aPointOnAnEdgeDividesTheFacesBesideIt() {
    const std::vector<SurfacePoint> inside = {at(0), inFace(8, 0.25, 0, 0.75), at(3)};
    QCOMPARE(fault(kGrid, inside), QByteArray());
    QCOMPARE(anchor(kGrid, inside)->mesh->faceCount(), kGrid->faceCount() + 2);
    const std::vector<SurfacePoint> border = {at(4), inFace(0, 0.25, 0.75, 0), at(3)};
    QCOMPARE(fault(kGrid, border), QByteArray());
    QCOMPARE(anchor(kGrid, border)->mesh->faceCount(), kGrid->faceCount() + 1);
  }

  void severalPointsInOneFaceAndOnItsEdgesAreDividedExactly() {
    const std::vector<SurfacePoint> points = {
        inFace(8, 0.25, 0.25, 0.5),    inFace(8, 0.125, 0.125, 0.75),      // on the piece's edge to corner 2
        inFace(8, 0.625, 0.125, 0.25), inFace(8, 0.5, 0.5, 0),             // an edge
        inFace(8, 0.25, 0.75, 0),      inFace(8, 0, 0.5, 0.5),             // the same edge, another
        inFace(8, 0.3, 0.3, 0.4),      inFace(8, 1e-17, 0.5, 0.5 - 1e-17)  // beside the edge
    };
    QCOMPARE(fault(kGrid, points), QByteArray());
  }

  void pointsOfOneEdgePickedFromBothFacesAreInOrder() {
    const Index twin = kGrid->twin(3 * 8 + 2);  // the diagonal of face 8: from corner 2 to corner 0
    SurfacePoint other = {-1, twin / 3, Eigen::Vector3d::Zero()};
    other.bary[twin % 3] = 0.375;  // from the corner 0 of face 8
    other.bary[TriangleMesh::next(twin) % 3] = 0.625;
    QCOMPARE(fault(kGrid, {inFace(8, 0.25, 0, 0.75), other, inFace(8, 0.5, 0, 0.5)}), QByteArray());
    other.bary[twin % 3] = 0.25;
    other.bary[TriangleMesh::next(twin) % 3] = 0.75;
    QCOMPARE(errorOf(kGrid, {inFace(8, 0.25, 0, 0.75), at(0), other}), ErrorCode::LoopRepeatsPoint);
  }

  void randomPointsOnALatticeOfOneFaceNeverBreakTheMesh() {
    std::mt19937 random(1);
    for (int round = 0; round < 100; ++round) {
      std::vector<SurfacePoint> points;
      std::vector<Eigen::Vector3d> seen;
      const long parts = round % 2 == 0 ? 8 : 10;  // exact and inexact weights
      while (points.size() < 20) {
        const auto i = static_cast<long>(random() % static_cast<unsigned>(parts + 1));
        const auto j = static_cast<long>(random() % static_cast<unsigned>(parts + 1 - i));
        const auto denominator = static_cast<double>(parts);
        const Eigen::Vector3d weights(static_cast<double>(i) / denominator,
                                      static_cast<double>(j) / denominator,
                                      static_cast<double>(parts - i - j) / denominator);
        if (weights.maxCoeff() < 1 && std::find(seen.begin(), seen.end(), weights) == seen.end()) {
          seen.push_back(weights);
          points.push_back({-1, 8, weights});
        }
      }
      QCOMPARE(fault(kGrid, points), QByteArray());
    }
  }

  void aSmallModelFarFromTheOriginKeepsItsDigits() {
    std::vector<Point> points = kGrid->points();
    for (Point& p : points) {
      p = 1e-4 * p + Point(100, 200, 300);
    }
    const auto mesh = std::make_shared<TriangleMesh>(std::move(points), kGrid->faces());
    const auto anchored = anchor(mesh, {inFace(8, 0.2, 0.3, 0.5), inFace(8, 0.25, 0, 0.75), at(0)});
    const auto& [a, b, c] = mesh->face(8);
    const Point origin = mesh->point(a);
    const Point inside = 0.3 * (mesh->point(b) - origin) + 0.5 * (mesh->point(c) - origin);
    QVERIFY((anchored->mesh->point(16) - origin - inside).norm() < 1e-13);
  }

  void fewerThanThreePairsAreTooFew() {
    QCOMPARE(errorOf(kGrid, {}), ErrorCode::LoopTooShort);
    QCOMPARE(errorOf(kGrid, {at(0), at(1)}), ErrorCode::LoopTooShort);
  }

  void anIndexBeyondTheMeshIsNamed() {
    const auto vertex = anchor(kGrid, {at(0), at(16), at(2)}, Side::Part);
    QCOMPARE(vertex.error().code, ErrorCode::LoopIndexOutOfRange);
    QCOMPARE(vertex.error().side, Side::Part);
    QCOMPARE(vertex.error().cvs, std::vector<int>({1}));
    QVERIFY(vertex.error().message.starts_with("CV 1 on the part names vertex 16"));
    QCOMPARE(errorOf(kGrid, {at(0), at(1), inFace(18, 0.2, 0.3, 0.5)}), ErrorCode::LoopIndexOutOfRange);
    QCOMPARE(errorOf(kGrid, {at(0), at(1), SurfacePoint{}}), ErrorCode::LoopIndexOutOfRange);
  }

  void weightsThatAreNoPointOfTheFaceAreNamed() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& w :
         {Eigen::Vector3d(-0.1, 0.6, 0.5), Eigen::Vector3d(0.5, 0.5, 0.1), Eigen::Vector3d(0, 0, 0),
          Eigen::Vector3d(nan, 0.5, 0.5), Eigen::Vector3d(infinity, 0, 0)}) {
      const auto anchored = anchor(kGrid, {at(0), at(1), inFace(8, w.x(), w.y(), w.z())});
      QCOMPARE(anchored.error().code, ErrorCode::LoopPointInvalid);
      QCOMPARE(anchored.error().cvs, std::vector<int>({2}));
    }
  }

  void weightsWithRoundedDigitsAreNormalised() {
    QCOMPARE(fault(kGrid, {at(0), at(3), inFace(8, 0.3333333, 0.3333333, 0.3333334)}), QByteArray());
    QVERIFY(anchor(kGrid, {at(0), at(3), inFace(8, 0.3333333, 0.3333333, 0.3333333)}).has_value());
  }

  void theSamePointTwiceIsNamedWithBothCVs() {
    const auto vertex = anchor(kGrid, {at(0), at(5), at(6), at(5)});
    QCOMPARE(vertex.error().code, ErrorCode::LoopRepeatsPoint);
    QCOMPARE(vertex.error().cvs, std::vector<int>({1, 3}));
    QVERIFY(vertex.error().message.starts_with("CV 1 and CV 3 on the base"));
    const auto face = anchor(kGrid, {inFace(8, 0.2, 0.3, 0.5), at(0), inFace(8, 0.2, 0.3, 0.5)});
    QCOMPARE(face.error().code, ErrorCode::LoopRepeatsPoint);
    QCOMPARE(face.error().cvs, std::vector<int>({0, 2}));
    const Index corner = kGrid->face(8)[1];
    QCOMPARE(errorOf(kGrid, {at(0), at(corner), inFace(8, 0, 1, 0)}), ErrorCode::LoopRepeatsPoint);
  }

  void aPointWhereTheMeshIsNotManifoldIsRefused() {
    const auto bowtie = std::make_shared<TriangleMesh>(
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {9, 9, 9}},
        std::vector<Face>{{0, 1, 2}, {0, 3, 4}});
    QCOMPARE(errorOf(bowtie, {at(1), at(2), at(0)}), ErrorCode::LoopPointSingular);
    const auto isolated = anchor(bowtie, {at(1), at(2), at(5)});
    QCOMPARE(isolated.error().code, ErrorCode::LoopPointSingular);
    QVERIFY(isolated.error().message.find("belongs to no face") != std::string::npos);
    QVERIFY(anchor(bowtie, {at(1), at(2), inFace(0, 0.5, 0.5, 0)}).has_value());
  }

  void aPointOnAnEdgeOfThreeFacesIsRefused() {
    const auto book = std::make_shared<TriangleMesh>(
        std::vector<Point>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
        std::vector<Face>{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    QCOMPARE(errorOf(book, {at(2), at(3), inFace(0, 0.5, 0.5, 0)}), ErrorCode::LoopPointSingular);
    QVERIFY(anchor(book, {at(2), at(3), inFace(0, 0.5, 0, 0.5)}).has_value());
  }

  void aPointOnAnEdgeWhoseFacesAreASecondTimeThereIsRefused() {
    // Faces 0 1 2 and 1 0 2 lie on each other; others at the edges to vertex 2 make it singular, but not 0–1.
    const auto mesh = std::make_shared<TriangleMesh>(
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {-1, 1, 0}},
        std::vector<Face>{{0, 1, 2}, {1, 0, 2}, {1, 3, 2}, {4, 0, 2}});
    QVERIFY(mesh->twin(0) == 3);
    QCOMPARE(errorOf(mesh, {at(3), at(4), inFace(0, 0.5, 0.5, 0)}), ErrorCode::LoopPointSingular);
  }

  void orientationOfWeightsIsExact() {
    const Eigen::Vector3d a(1, 0, 0);
    const Eigen::Vector3d b(0, 1, 0);
    QCOMPARE(orientBarycentric(a, b, Eigen::Vector3d(0, 0, 1)), 1);
    QCOMPARE(orientBarycentric(b, a, Eigen::Vector3d(0, 0, 1)), -1);
    QCOMPARE(orientBarycentric(a, b, Eigen::Vector3d(0.5, 0.5, 1e-300)), 1);
    QCOMPARE(orientBarycentric(a, b, Eigen::Vector3d(0.3, 0.7, 0)), 0);
    const Eigen::Vector3d p(0.1, 0.2, 0.7);
    const Eigen::Vector3d q(0.3, 0.3, 0.4);
    QCOMPARE(orientBarycentric(p, q, p + 2 * q), orientBarycentric(q, p + 2 * q, p));
  }
};

QTEST_APPLESS_MAIN(AnchorTest)
#include "anchor_test.moc"
