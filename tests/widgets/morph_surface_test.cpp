#include <QtTest>
#include <cmath>
#include <numbers>

#include "core/fusion/blend.h"
#include "core/fusion/verify.h"
#include "tests/support/samples.h"
#include "widgets/viewport/colouring_surface.h"
#include "widgets/viewport/morph_rays.h"
#include "widgets/viewport/morph_surface.h"
#include "widgets/viewport/ring_line.h"

using namespace graftsman;

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

FCF curve(const std::vector<FCFPoint>& points) {
  return FCF::through(points).value();
}

FCF constant(double f) {
  return curve({{0, f}, {0.3, f}, {0.7, f}, {1, f}});
}

FusionResults fuse(const FusionInputs& inputs) {
  FusionResults results = update(inputs, {}, {});
  if (results.error) {
    qFatal("%s", results.error->message.c_str());
  }
  return results;
}

const FusionResults& sample(const std::string& name) {
  static std::map<std::string, FusionResults> known;
  const auto [at, isNew] = known.try_emplace(name);
  if (isNew) {
    at->second = fuse(samples::load(name));
  }
  return at->second;
}

MorphSurface surfaceOf(const FusionResults& results) {
  return {results.join, results.combined, results.inputs.fcf};
}

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

class MorphSurfaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sheetsHoldTheResultsFaces_data();
  void sheetsHoldTheResultsFaces();
  void positionsAreThoseOfTheBlend_data();
  void positionsAreThoseOfTheBlend();
  void normalsAreAreaWeightedAfterASeriesOfCurves_data();
  void normalsAreAreaWeightedAfterASeriesOfCurves();
  void aSurfaceFarFromTheOriginKeepsItsShape();
  void theRestIsLeftAloneWhileTheSeamStays();
  void theBoxesHoldTheSheetsWhateverTheCurve();
  void everyPointOfARingHasItsS_data();
  void everyPointOfARingHasItsS();
  void aRingLiesOnTheSurfaceAndCloses();
  void theRingAtZeroIsTheSeam();
  void aRayMeetsTheNearestFace();
  void theFusionCurvesColoursGoFromTheBasesToTheParts();
  void originsAreCountedAndColoured();
  void seamAnglesAreThoseOfTheReport();
  void qualityIsTheSmallestAngleOfEachTriangle();
  void theScalesAreInOrderOfLightness();
};

void addSamples() {
  QTest::addColumn<QString>("name");
  for (const char* const name :
       {"fig4d_cone_sphere", "fig7_letters_bottle", "fig8b_cone_nose", "fig9a_cars", "fig9b_bird_plane"}) {
    QTest::newRow(name) << QString::fromLatin1(name);
  }
}

void MorphSurfaceTest::sheetsHoldTheResultsFaces_data() {
  addSamples();
}

void MorphSurfaceTest::sheetsHoldTheResultsFaces() {
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

void MorphSurfaceTest::positionsAreThoseOfTheBlend_data() {
  addSamples();
}

void MorphSurfaceTest::positionsAreThoseOfTheBlend() {
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

void MorphSurfaceTest::normalsAreAreaWeightedAfterASeriesOfCurves_data() {
  addSamples();
}

void MorphSurfaceTest::normalsAreAreaWeightedAfterASeriesOfCurves() {
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

void MorphSurfaceTest::aSurfaceFarFromTheOriginKeepsItsShape() {
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

void MorphSurfaceTest::theRestIsLeftAloneWhileTheSeamStays() {
  const FusionResults& results = sample("fig8b_cone_nose");
  MorphSurface surface = surfaceOf(results);
  const MorphSheet rest = surface.rest();
  const std::vector<float> normals(rest.normals, rest.normals + std::ptrdiff_t{3} * rest.vertexCount);
  QVERIFY(!surface.setCurve(curve({{0, 0}, {0.2, 0.9}, {0.7, 1}, {1, 1}})));
  QVERIFY(std::equal(normals.begin(), normals.end(), surface.rest().normals));
}

void MorphSurfaceTest::theBoxesHoldTheSheetsWhateverTheCurve() {
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

void MorphSurfaceTest::everyPointOfARingHasItsS_data() {
  addSamples();
}

void MorphSurfaceTest::everyPointOfARingHasItsS() {
  QFETCH(QString, name);
  const CombinedTile& combined = *sample(name.toStdString()).combined;
  RingLine ring;
  for (const double s : {0.001, 0.1, 0.35, 0.5, 0.9, 0.99}) {
    ring.find(combined, s);
    // Nothing of the tile lies farther from the seam than its farthest vertex.
    QCOMPARE(ring.crossings().size() >= 3, s < *std::max_element(combined.s.begin(), combined.s.end()));
    for (const RingCrossing& at : ring.crossings()) {
      QVERIFY(at.t >= 0 && at.t <= 1);
      const double from = combined.s[static_cast<std::size_t>(at.from)];
      const double to = combined.s[static_cast<std::size_t>(at.to)];
      QVERIFY(std::abs((1 - at.t) * from + at.t * to - s) < 1e-12);
    }
  }
}

void MorphSurfaceTest::aRingLiesOnTheSurfaceAndCloses() {
  const MorphSurface surface = surfaceOf(sample("fig9b_bird_plane"));
  const MorphSheet tile = surface.tile();
  RingLine ring;
  ring.find(surface.combined(), 0.4);
  ring.place(tile.positions);
  QCOMPARE(ring.positions().size(), 3 * ring.crossings().size());
  std::map<std::pair<Index, Index>, int> ends;
  for (std::size_t i = 0; i < ring.crossings().size(); ++i) {
    const RingCrossing& at = ring.crossings()[i];
    ++ends[std::minmax(at.from, at.to)];
    const Eigen::Vector3f a = tile.position(at.from);
    const Eigen::Vector3f b = tile.position(at.to);
    const Eigen::Vector3f p = Eigen::Vector3f::Map(&ring.positions()[3 * i]);
    QVERIFY((a + static_cast<float>(at.t) * (b - a) - p).norm() <=
            1e-6F * static_cast<float>(tile.box.diagonal().norm()));
  }
  for (const auto& [edge, count] : ends) {
    QCOMPARE(count, 2);  // each end is the next segment's start
  }
}

void MorphSurfaceTest::theRingAtZeroIsTheSeam() {
  const CombinedTile& combined = *sample("fig8b_cone_nose").combined;
  RingLine ring;
  ring.find(combined, 0);
  QCOMPARE(ring.crossings().size(), 2 * static_cast<std::size_t>(combined.seamSize));
  ring.find(combined, 1.5);
  QVERIFY(ring.crossings().empty());
}

void MorphSurfaceTest::aRayMeetsTheNearestFace() {
  MorphSurface surface = surfaceOf(sample("fig9b_bird_plane"));
  surface.setCurve(FCF::preset(FCF::Preset::Paste));
  const MorphSheet tile = surface.tile();
  SheetRays rays(tile);
  rays.measure();
  const auto reach = static_cast<float>(tile.box.diagonal().norm());
  const Eigen::Vector3f direction = Eigen::Vector3f(1, 2, -3).normalized();
  int hits = 0;
  for (std::size_t f = 0; f < tile.faces.size(); f += 97) {
    const auto& [a, b, c] = tile.faces[f];
    const Eigen::Vector3f middle = (tile.position(a) + tile.position(b) + tile.position(c)) / 3;
    const auto hit = rays.nearest(middle - 2 * reach * direction, direction, 10 * reach);
    if (hit) {
      ++hits;
      const auto& [i, j, k] = tile.faces[static_cast<std::size_t>(hit->face)];
      const Eigen::Vector3f there = hit->weights[0] * tile.position(i) + hit->weights[1] * tile.position(j) +
                                    hit->weights[2] * tile.position(k);
      const Eigen::Vector3f onRay = middle + (hit->distance - 2 * reach) * direction;
      QVERIFY((there - onRay).norm() < 1e-4F * reach);
      QVERIFY(hit->distance < 2 * reach * 1.0001F);  // never behind the face that was aimed at
    }
  }
  QVERIFY(hits > 10);
  QVERIFY(!rays.nearest(Eigen::Vector3f(0, 0, 5 * reach), Eigen::Vector3f::UnitZ(), 100 * reach));
}

void MorphSurfaceTest::theFusionCurvesColoursGoFromTheBasesToTheParts() {
  MorphSurface surface = surfaceOf(sample("fig8b_cone_nose"));
  const Theme theme = themeFor(QPalette(Qt::white));
  surface.setCurve(constant(0));
  SurfaceColours colours(surface, Colouring::FusionCurve, theme);
  QVERIFY(colours.rest().uniform == rgba(theme.base));
  QVERIFY(colours.rim().uniform == rgba(theme.base));
  const auto all = [&](const Rgba& colour) {
    return std::all_of(colours.tile().each.begin(), colours.tile().each.end(),
                       [&](const Rgba& one) { return one == colour; });
  };
  QCOMPARE(static_cast<Index>(colours.tile().each.size()), surface.tile().vertexCount);
  QVERIFY(all(rgba(theme.base)));
  colours.follow(surface.setCurve(constant(1)));
  QVERIFY(all(rgba(theme.part)));
  colours.follow(surface.setCurve(constant(0.5)));
  QVERIFY(all(mixed(rgba(theme.base), rgba(theme.part), 0.5F)));
}

void MorphSurfaceTest::originsAreCountedAndColoured() {
  const FusionResults& results = sample("fig9b_bird_plane");
  const MorphSurface surface = surfaceOf(results);
  const Theme theme = themeFor(QPalette(Qt::white));
  const SurfaceColours colours(surface, Colouring::Origin, theme);
  const ColouringNumbers& numbers = colours.numbers();
  QCOMPARE(numbers.baseVertices + numbers.partVertices + numbers.commonVertices, surface.tile().vertexCount);
  QVERIFY(numbers.baseVertices > 0 && numbers.partVertices > 0 && numbers.commonVertices > 0);
  QVERIFY(colours.rest().uniform == rgba(theme.mesh));
  using Origin = SurfaceColours::Origin;
  for (Index v = 0; v < surface.tile().vertexCount; ++v) {
    const bool ofPart =
        results.combined->onPart[static_cast<std::size_t>(v)].kind == TileLocation::Kind::OnVertex;
    const bool ofBase =
        results.combined->onBase[static_cast<std::size_t>(v)].kind == TileLocation::Kind::OnVertex;
    const Origin origin = SurfaceColours::originOf(*results.combined, v);
    QCOMPARE(origin == Origin::Part, ofPart && !ofBase);
    QCOMPARE(origin == Origin::Base, ofBase && !ofPart);
  }
}

void MorphSurfaceTest::seamAnglesAreThoseOfTheReport() {
  for (const char* const name : {"fig8b_cone_nose", "fig7_letters_bottle", "fig9b_bird_plane"}) {
    const FusionResults& results = sample(name);
    const MorphSurface surface = surfaceOf(results);
    const Verification verification = verify(results);
    const SurfaceColours colours(surface, Colouring::SeamAngle, themeFor(QPalette(Qt::white)));
    QVERIFY(std::abs(colours.numbers().meanSeamAngle - verification.meanSeamAngle) < 1e-6);
    QVERIFY(std::abs(colours.numbers().greatestSeamAngle - verification.greatestSeamAngle) < 1e-6);
    QCOMPARE(colours.seam().size(), static_cast<std::size_t>(results.combined->seamSize));
  }
}

void MorphSurfaceTest::qualityIsTheSmallestAngleOfEachTriangle() {
  const MorphSurface surface = surfaceOf(sample("fig8b_cone_nose"));
  const SurfaceColours colours(surface, Colouring::Quality, themeFor(QPalette(Qt::white)));
  double smallest = 180;
  const auto check = [&](const MorphSheet& sheet, const SheetColours& shown) {
    QCOMPARE(shown.each.size(), sheet.faces.size());
    for (std::size_t f = 0; f < sheet.faces.size(); ++f) {
      double angle = 180;
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d p = sheet.position(sheet.faces[f][k]).cast<double>();
        const Eigen::Vector3d u = sheet.position(sheet.faces[f][(k + 1) % 3]).cast<double>() - p;
        const Eigen::Vector3d v = sheet.position(sheet.faces[f][(k + 2) % 3]).cast<double>() - p;
        angle = std::min(angle, std::atan2(u.cross(v).norm(), u.dot(v)) * kDegrees);
      }
      smallest = std::min(smallest, angle);
      const Rgba expected = SurfaceColours::ofSmallestAngle(angle);
      const Rgba& given = shown.each[f];
      QVERIFY(std::abs(expected.r - given.r) < 8 && std::abs(expected.g - given.g) < 8 &&
              std::abs(expected.b - given.b) < 8);
    }
  };
  check(surface.rest(), colours.rest());
  check(surface.rim(), colours.rim());
  check(surface.tile(), colours.tile());
  QVERIFY(std::abs(colours.numbers().smallestAngle - smallest) < 0.01);
}

void MorphSurfaceTest::theScalesAreInOrderOfLightness() {
  const auto lightness = [](const Rgba& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  for (int i = 1; i <= 90; ++i) {
    QVERIFY(lightness(SurfaceColours::ofSeamAngle(i)) <= lightness(SurfaceColours::ofSeamAngle(i - 1)));
  }
  for (int i = 1; i <= 60; ++i) {
    QVERIFY(lightness(SurfaceColours::ofSmallestAngle(i)) >=
            lightness(SurfaceColours::ofSmallestAngle(i - 1)));
  }
}

}  // namespace

QTEST_GUILESS_MAIN(MorphSurfaceTest)
#include "morph_surface_test.moc"
