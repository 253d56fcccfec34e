#include <QtTest>
#include <cmath>
#include <numbers>

#include "core/fusion/blend.h"
#include "core/fusion/verify.h"
#include "tests/support/morph_samples.h"
#include "tests/support/samples.h"
#include "widgets/viewport/colouring_surface.h"
#include "widgets/viewport/morph_rays.h"
#include "widgets/viewport/morph_surface.h"
#include "widgets/viewport/ring_line.h"

using namespace graftsman;

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

FCF constant(double f) {
  return curve({{0, f}, {0.3, f}, {0.7, f}, {1, f}});
}

}  // namespace

class MorphQueriesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPointOfARingHasItsS_data() { addSamples(); }

  void everyPointOfARingHasItsS() {
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

  void aRingLiesOnTheSurfaceAndCloses() {
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

  void theRingAtZeroIsTheSeam() {
    const CombinedTile& combined = *sample("fig8b_cone_nose").combined;
    RingLine ring;
    ring.find(combined, 0);
    QCOMPARE(ring.crossings().size(), 2 * static_cast<std::size_t>(combined.seamSize));
    ring.find(combined, 1.5);
    QVERIFY(ring.crossings().empty());
  }

  void aRayMeetsTheNearestFace() {
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
        const Eigen::Vector3f there = hit->weights[0] * tile.position(i) +
                                      hit->weights[1] * tile.position(j) + hit->weights[2] * tile.position(k);
        const Eigen::Vector3f onRay = middle + (hit->distance - 2 * reach) * direction;
        QVERIFY((there - onRay).norm() < 1e-4F * reach);
        QVERIFY(hit->distance < 2 * reach * 1.0001F);  // never behind the face that was aimed at
      }
    }
    QVERIFY(hits > 10);
    QVERIFY(!rays.nearest(Eigen::Vector3f(0, 0, 5 * reach), Eigen::Vector3f::UnitZ(), 100 * reach));
  }

  void theFusionCurvesColoursGoFromTheBasesToTheParts() {
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

  void originsAreCountedAndColoured() {
    const FusionResults& results = sample("fig9b_bird_plane");
    const MorphSurface surface = surfaceOf(results);
    const Theme theme = themeFor(QPalette(Qt::white));
    const SurfaceColours colours(surface, Colouring::Origin, theme);
    const ColouringNumbers& numbers = colours.numbers();
    QCOMPARE(numbers.baseVertices + numbers.partVertices + numbers.commonVertices,
             surface.tile().vertexCount);
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

  void seamAnglesAreThoseOfTheReport() {
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

  void qualityIsTheSmallestAngleOfEachTriangle() {
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

  void theScalesAreInOrderOfLightness() {
    const auto lightness = [](const Rgba& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
    for (int i = 1; i <= 90; ++i) {
      QVERIFY(lightness(SurfaceColours::ofSeamAngle(i)) <= lightness(SurfaceColours::ofSeamAngle(i - 1)));
    }
    for (int i = 1; i <= 60; ++i) {
      QVERIFY(lightness(SurfaceColours::ofSmallestAngle(i)) >=
              lightness(SurfaceColours::ofSmallestAngle(i - 1)));
    }
  }
};

QTEST_GUILESS_MAIN(MorphQueriesTest)
#include "morph_queries_test.moc"
