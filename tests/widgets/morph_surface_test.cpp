#include "widgets/viewport/morph_surface.h"

#include <QtTest>
#include <cmath>

#include "core/fusion/blend.h"
#include "core/fusion/verify.h"
#include "tests/support/morph_samples.h"
#include "tests/support/samples.h"
#include "widgets/viewport/colouring_surface.h"
#include "widgets/viewport/morph_rays.h"
#include "widgets/viewport/ring_line.h"

using namespace graftsman;

namespace {

// The curves of a drag, the seam's own f among what they change.
std::vector<FCF> drag() {
  std::vector<FCF> curves;
  for (const auto preset :
       {FCF::Preset::Linear, FCF::Preset::Paste, FCF::Preset::KeepBaseSlope, FCF::Preset::Half}) {
    curves.push_back(FCF::preset(preset));
  }
  for (int i = 0; i <= 5; ++i) {
    curves.push_back(curve({{0, 0}, {0.2, 0.2 * i}, {0.7, 1 - 0.2 * i}, {1, 0.6}}));
    curves.push_back(curve({{0, 0.1 * i}, {0.2, 0.2 * i}, {0.7, 0.5}, {1, 1}}));
  }
  return curves;
}

// Of each vertex of the surface, the result's.
std::vector<Index> resultVertices(const MorphSurface& surface) {
  std::vector<Index> vertices = surface.layout().restVertices;
  const std::vector<Index>& tile = surface.join().tileVertices;
  vertices.insert(vertices.end(), tile.begin(), tile.begin() + surface.layout().seamSize);
  vertices.insert(vertices.end(), tile.begin(), tile.end());
  return vertices;
}

/// The whole surface in the numbers of the result.
struct Whole {
  std::vector<Point> points;
  std::vector<Eigen::Vector3d> normals;
};

Whole wholeOf(const MorphSurface& surface) {
  const std::vector<Index> vertices = resultVertices(surface);
  Whole whole;
  whole.points.resize(surface.join().points.size(), Point::Zero());
  whole.normals.resize(surface.join().points.size(), Point::Zero());
  const float* const positions = surface.rest().positions;  // the buffers of all sheets are one
  const float* const normals = surface.rest().normals;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const auto to = static_cast<std::size_t>(vertices[v]);
    whole.points[to] = Eigen::Vector3f::Map(positions + 3 * v).cast<double>() + surface.centre();
    whole.normals[to] = Eigen::Vector3f::Map(normals + 3 * v).cast<double>();
  }
  return whole;
}

// Area-weighted normals from the positions in double precision, of length 1; zero where the faces round a
// vertex are too small for single precision to know their direction.
std::vector<Eigen::Vector3d> bruteNormals(const std::vector<Point>& points, const std::vector<Face>& faces,
                                          double diagonal) {
  std::vector<Eigen::Vector3d> sums(points.size(), Eigen::Vector3d::Zero());
  std::vector<double> longest(points.size(), 0);
  for (const auto& [a, b, c] : faces) {
    const Point& p = points[static_cast<std::size_t>(a)];
    const Eigen::Vector3d u = points[static_cast<std::size_t>(b)] - p;
    const Eigen::Vector3d v = points[static_cast<std::size_t>(c)] - p;
    for (const Index i : {a, b, c}) {
      sums[static_cast<std::size_t>(i)] += u.cross(v);
      double& length = longest[static_cast<std::size_t>(i)];
      length = std::max({length, u.norm(), v.norm()});
    }
  }
  constexpr double kFloat = 1e-7;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double area = sums[v].norm();
    const bool known = area > 300 * kFloat * diagonal * longest[v];
    sums[v] = known ? Eigen::Vector3d(sums[v] / area) : Eigen::Vector3d::Zero();
  }
  return sums;
}

}  // namespace

class MorphSurfaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sheetsHoldTheResultsFaces_data() { addSamples(); }

  void sheetsHoldTheResultsFaces() {
    QFETCH(QString, name);
    const FusionResults& results = sample(name.toStdString());
    const MorphSurface surface = surfaceOf(results);
    const std::vector<Index> vertices = resultVertices(surface);
    std::vector<Face> faces;
    const std::array<std::pair<MorphSheet, Index>, 3> sheets = {
        {{surface.rest(), 0},
         {surface.rim(), surface.layout().ringBegin()},
         {surface.tile(), surface.layout().tileBegin()}}};
    for (const auto& [sheet, first] : sheets) {
      for (Face face : sheet.faces) {
        for (Index& v : face) {
          QVERIFY(v >= 0 && v < sheet.vertexCount);
          v = vertices[static_cast<std::size_t>(first + v)];
        }
        faces.push_back(face);
      }
    }
    std::vector<Face> expected = results.join->faces;
    std::sort(expected.begin(), expected.end());
    std::sort(faces.begin(), faces.end());
    QVERIFY(faces == expected);
  }

  void positionsAreThoseOfTheBlend_data() { addSamples(); }

  void positionsAreThoseOfTheBlend() {
    QFETCH(QString, name);
    const FusionResults& results = sample(name.toStdString());
    MorphSurface surface = surfaceOf(results);
    const double size = surface.rest().box.merged(surface.tile().box).diagonal().norm();
    for (const FCF& fcf : drag()) {
      surface.setCurve(fcf);
      std::vector<Point> exact = results.join->points;
      blend(*results.combined, fcf, results.join->tileVertices, exact);
      const std::vector<Point> shown = wholeOf(surface).points;
      for (const Index v : resultVertices(surface)) {
        const auto i = static_cast<std::size_t>(v);
        QVERIFY((shown[i] - exact[i]).norm() <= 3e-7 * size);
      }
    }
  }

  void normalsAreAreaWeightedAfterASeriesOfCurves_data() { addSamples(); }

  void normalsAreAreaWeightedAfterASeriesOfCurves() {
    QFETCH(QString, name);
    FusionInputs inputs = samples::load(name.toStdString());
    inputs.adjustment.exactFit = false;  // so that the seam moves with f(0)
    const FusionResults results = fuse(inputs);
    MorphSurface surface = surfaceOf(results);
    const double size = surface.rest().box.merged(surface.tile().box).diagonal().norm();
    for (const FCF& fcf : drag()) {
      surface.setCurve(fcf);
      const Whole whole = wholeOf(surface);
      const std::vector<Eigen::Vector3d> expected = bruteNormals(whole.points, results.join->faces, size);
      std::size_t known = 0;
      for (const Index v : resultVertices(surface)) {
        const auto i = static_cast<std::size_t>(v);
        QVERIFY(std::abs(whole.normals[i].norm() - 1) < 1e-5);
        if (!expected[i].isZero()) {
          ++known;
          QVERIFY2((whole.normals[i] - expected[i]).norm() < 0.02, qPrintable(QString::number(v)));
        }
      }
      QVERIFY(known > results.join->points.size() / 2);
    }
    // The copies of the seam go with it.
    const std::size_t seam = 3 * static_cast<std::size_t>(surface.layout().seamSize);
    const MorphSheet rim = surface.rim();
    const std::size_t copies = 3 * static_cast<std::size_t>(surface.layout().ringCount);
    QVERIFY(std::equal(rim.positions + copies, rim.positions + copies + seam, surface.tile().positions));
    QVERIFY(std::equal(rim.normals + copies, rim.normals + copies + seam, surface.tile().normals));
  }

  void aSurfaceFarFromTheOriginKeepsItsShape() {
    const FusionInputs inputs = samples::load("fig8b_cone_nose");
    const double size = inputs.base->diagonal();
    const Point far = Point(3, -2, 5) * 1e7 * size;
    std::vector<Point> moved = inputs.base->points();
    for (Point& p : moved) {
      p += far;
    }
    FusionInputs farInputs = inputs;
    farInputs.base = std::make_shared<TriangleMesh>(std::move(moved), inputs.base->faces());
    const FusionResults results = fuse(farInputs);
    const MorphSurface surface = surfaceOf(results);
    const std::vector<Point> shown = wholeOf(surface).points;
    for (const Index v : resultVertices(surface)) {
      const auto i = static_cast<std::size_t>(v);
      QVERIFY((shown[i] - results.fused->points[i]).norm() < 1e-6 * size);
    }
  }

  void theRestIsLeftAloneWhileTheSeamStays() {
    const FusionResults& results = sample("fig8b_cone_nose");
    MorphSurface surface = surfaceOf(results);
    const MorphSheet rest = surface.rest();
    const std::vector<float> normals(rest.normals, rest.normals + std::ptrdiff_t{3} * rest.vertexCount);
    QVERIFY(!surface.setCurve(curve({{0, 0}, {0.2, 0.9}, {0.7, 1}, {1, 1}})));
    QVERIFY(std::equal(normals.begin(), normals.end(), surface.rest().normals));
  }

  void theBoxesHoldTheSheetsWhateverTheCurve() {
    const FusionResults& results = sample("fig9b_bird_plane");
    MorphSurface surface = surfaceOf(results);
    for (const FCF& fcf : drag()) {
      surface.setCurve(fcf);
      for (const MorphSheet& sheet : {surface.rest(), surface.rim(), surface.tile()}) {
        const double slack = 1e-6 * sheet.box.diagonal().norm();
        for (Index v = 0; v < sheet.vertexCount; ++v) {
          QVERIFY(sheet.box.exteriorDistance(sheet.position(v).cast<double>()) <= slack);
        }
      }
    }
  }
};

QTEST_GUILESS_MAIN(MorphSurfaceTest)
#include "morph_surface_test.moc"
