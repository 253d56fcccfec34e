#include "widgets/viewport/coarse_faces.h"

#include <Eigen/Geometry>
#include <QtTest>
#include <map>
#include <set>

#include "tests/support/panes.h"
#include "tests/support/shapes.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/shading.h"

using namespace graftsman;

namespace {

constexpr Index kFine = 520;  // n×n vertices, 2n² faces: more than are always drawn

struct Surface {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Face> faces;

  explicit Surface(const TriangleMesh& mesh) : faces(mesh.faces()) {
    for (const Point& point : mesh.points()) {
      positions.push_back(point.cast<float>());
    }
    normals = shade(mesh).normals;
  }
  [[nodiscard]] CoarseFaces coarse(const ClusterGrid& grid) const {
    return coarsen(positions[0].data(), normals[0].data(), static_cast<Index>(positions.size()), faces, grid);
  }
  [[nodiscard]] Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& position : positions) {
      box.extend(position.cast<double>());
    }
    return box;
  }
  [[nodiscard]] ClusterGrid grid() const {
    return ClusterGrid::across(box().sizes().maxCoeff(), box().min());
  }
  [[nodiscard]] const Eigen::Vector3f& at(Index v) const { return positions[static_cast<std::size_t>(v)]; }
};

using Edge = std::pair<Index, Index>;

// The edges that one face alone has.
std::set<Edge> borderOf(const std::vector<Face>& faces) {
  std::map<Edge, int> count;
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++count[std::minmax(face[k], face[(k + 1) % 3])];
    }
  }
  std::set<Edge> border;
  for (const auto& [edge, times] : count) {
    if (times == 1) {
      border.insert(edge);
    }
  }
  return border;
}

}  // namespace

// What is drawn of many faces while frames must be quick.
class CoarseFacesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void fewFacesAreDrawnAsTheyAre() {
    const Surface surface(*shapes::torus(100, 100));
    QVERIFY(surface.coarse(surface.grid()).faces.empty());
  }

  void theyLieWhereTheOthersDo() {
    const Surface surface(*shapes::torus(kFine, kFine));
    QVERIFY(surface.faces.size() > kManyDrawnFaces);
    const ClusterGrid grid = surface.grid();
    const CoarseFaces coarse = surface.coarse(grid);
    QVERIFY(coarse.faces.size() > 5000 && coarse.faces.size() < kManyDrawnFaces / 2);
    QCOMPARE(coarse.sources.size(), coarse.faces.size());
    const double reach = 2 * grid.cell;
    for (std::size_t f = 0; f < coarse.faces.size(); ++f) {
      const Face& face = coarse.faces[f];
      const Face& source = surface.faces[static_cast<std::size_t>(coarse.sources[f])];
      Eigen::Vector3f outward = Eigen::Vector3f::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        outward += surface.normals[static_cast<std::size_t>(face[k])];
        QVERIFY(std::ranges::any_of(
            source, [&](Index v) { return (surface.at(v) - surface.at(face[k])).norm() < reach; }));
      }
      const Eigen::Vector3f area =
          (surface.at(face[1]) - surface.at(face[0])).cross(surface.at(face[2]) - surface.at(face[0]));
      QVERIFY(area.dot(outward) >= 0);
    }
    QVERIFY(borderOf(coarse.faces).empty());
  }

  void aBorderStaysAsItIs() {
    Surface surface(*shapes::torus(kFine, kFine));
    std::erase_if(surface.faces, [&](const Face& face) {
      return std::ranges::any_of(face, [&](Index v) { return surface.at(v).x() > 0.5F; });
    });
    const std::set<Edge> border = borderOf(surface.faces);
    QVERIFY(border.size() > 100);
    QVERIFY(surface.faces.size() > kManyDrawnFaces);
    const CoarseFaces coarse = surface.coarse(surface.grid());
    QVERIFY(!coarse.faces.empty() && coarse.faces.size() < kManyDrawnFaces / 2);
    QVERIFY(borderOf(coarse.faces) == border);
  }

  void scrapsOfASurfaceBecomeFewerToo() {
    const Surface whole(*shapes::torus(kFine, kFine));
    Surface scraps = whole;
    scraps.positions.clear();
    scraps.normals.clear();
    for (Face& face : scraps.faces) {
      for (Index& v : face) {
        scraps.positions.push_back(whole.at(v));
        scraps.normals.push_back(whole.normals[static_cast<std::size_t>(v)]);
        v = static_cast<Index>(scraps.positions.size()) - 1;
      }
    }
    const CoarseFaces coarse = scraps.coarse(whole.grid());
    QVERIFY(!coarse.faces.empty() && coarse.faces.size() < kManyDrawnFaces / 2);
  }

  void aPaneShowsThemUntilItRests() {
    MeshPane pane(Side::Base);
    pane.resize(300, 300);
    pane.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pane));
    QVERIFY(panes::showMesh(pane, shapes::torus(kFine, kFine)));
    const QImage quick = pane.grabFramebuffer();
    QTRY_VERIFY(pane.grabFramebuffer() != quick);
    const QImage rested = pane.grabFramebuffer();
    QCOMPARE(pane.picture().convertToFormat(rested.format()), rested);
  }

  void aPictureHasAllFaces() {
    MeshPane shown(Side::Base);
    MeshPane asked(Side::Base);
    QImage pictures[2];
    for (MeshPane* pane : {&shown, &asked}) {
      pane->resize(300, 300);
      pane->show();
      QVERIFY(QTest::qWaitForWindowExposed(pane));
      QVERIFY(panes::showMesh(*pane, shapes::torus(kFine, kFine)));
    }
    (void)shown.grabFramebuffer();
    pictures[0] = shown.picture();  // after a quick frame
    pictures[1] = asked.picture();
    QCOMPARE(pictures[0], pictures[1]);
    QCOMPARE(shown.picture(), pictures[0]);
  }
};

QTEST_MAIN(CoarseFacesTest)
#include "coarse_faces_test.moc"
