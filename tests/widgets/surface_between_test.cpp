#include "widgets/viewport/surface_between.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace graftsman;

namespace {

/// A strip of two squares that meet at an edge along y and turn there by `angle`.
TriangleMesh foldedStrip(double angle) {
  const double x = std::cos(angle);
  const double z = std::sin(angle);
  return {{{-1, 0, 0}, {-1, 1, 0}, {0, 0, 0}, {0, 1, 0}, {x, 0, z}, {x, 1, z}},
          {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}}};
}

/// What lies between two meshes at t.
struct Between {
  BetweenLayout layout;
  std::vector<double> points;
  std::vector<float> normals;

  Between(const TriangleMesh& a, const TriangleMesh& b, double t)
      : layout(layOutBetween(a, shade(a), shade(b))),
        points(3 * layout.meshVertices.size()),
        normals(points.size()) {
    std::vector<Eigen::Vector3f> areas(layout.faces.size());
    writeBetween(layout, a, b, t, points, normals, areas);
  }
  [[nodiscard]] Point place(Index drawn) const {
    return Eigen::Map<const Point>(points.data() + std::ptrdiff_t{3} * drawn);
  }
  /// At a face's corner.
  [[nodiscard]] Eigen::Vector3f normal(std::size_t face, std::size_t corner) const {
    return Eigen::Map<const Eigen::Vector3f>(normals.data() + std::ptrdiff_t{3} * layout.faces[face][corner]);
  }
};

/// The normal of a shading at a face's corner.
Eigen::Vector3f normalOf(const Shading& shading, std::size_t face, std::size_t corner) {
  return shading.normals[static_cast<std::size_t>(shading.faces[face][corner])];
}

constexpr double kSmooth = 0.4;  // radians: no crease
constexpr double kSharp = std::numbers::pi / 2;

}  // namespace

class SurfaceBetweenTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void verticesGoStraight() {
    const TriangleMesh a = foldedStrip(kSmooth);
    const TriangleMesh b = foldedStrip(kSharp);
    const Between between(a, b, 0.3);
    QCOMPARE(between.layout.meshVertices.size(), std::size_t{8});  // both at the edge twice
    for (std::size_t i = 0; i < between.layout.meshVertices.size(); ++i) {
      const Index v = between.layout.meshVertices[i];
      QVERIFY(i >= 6 || v == static_cast<Index>(i));
      const Point wanted = 0.7 * a.point(v) + 0.3 * b.point(v);
      QVERIFY((between.place(static_cast<Index>(i)) - wanted).norm() < 1e-15);
    }
    for (std::size_t f = 0; f < between.layout.faces.size(); ++f) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto drawn = static_cast<std::size_t>(between.layout.faces[f][corner]);
        QCOMPARE(between.layout.meshVertices[drawn], a.faces()[f][corner]);
      }
    }
  }

  // Whichever of the two has the crease, and wherever both have one.
  void theEndsHaveTheNormalsOfTheTwo() {
    const std::pair<double, double> turns[] = {
        {kSmooth, kSharp}, {kSharp, kSmooth}, {kSharp, -kSharp}, {kSmooth, -kSmooth}};
    for (const auto& [ofA, ofB] : turns) {
      const TriangleMesh a = foldedStrip(ofA);
      const TriangleMesh b = foldedStrip(ofB);
      const Between first(a, b, 0);
      const Between second(a, b, 1);
      const Shading shadedA = shade(a);
      const Shading shadedB = shade(b);
      for (std::size_t f = 0; f < a.faces().size(); ++f) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
          QVERIFY((first.normal(f, corner) - normalOf(shadedA, f, corner)).norm() < 1e-6F);
          QVERIFY((second.normal(f, corner) - normalOf(shadedB, f, corner)).norm() < 1e-6F);
        }
      }
    }
  }

  void aCreaseOfOneGrowsSteadily() {
    const TriangleMesh a = foldedStrip(kSmooth);
    const TriangleMesh b = foldedStrip(kSharp);
    float turned = 0;
    for (const double t : {0.01, 0.25, 0.5, 0.75, 0.99, 1.0}) {
      const Between between(a, b, t);
      // At the corners of two faces that lie on either side of the edge at its end (0, 0, 0).
      const Eigen::Vector3f left = between.normal(0, 1);
      const Eigen::Vector3f right = between.normal(2, 0);
      QVERIFY(std::abs(left.norm() - 1) < 1e-6F && std::abs(right.norm() - 1) < 1e-6F);
      const float angle = std::acos(std::clamp(left.dot(right), -1.0F, 1.0F));
      QVERIFY(angle > turned);
      turned = angle;
    }
    QVERIFY(std::abs(turned - static_cast<float>(kSharp)) < 1e-3F);
  }

  void aFaceWithoutAreaHasNoNormal() {
    const TriangleMesh a({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const TriangleMesh b({{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}});
    const Between between(a, b, 0.5);  // flat on a line
    for (std::size_t corner = 0; corner < 3; ++corner) {
      QCOMPARE(between.normal(0, corner).norm(), 0.0F);
    }
  }
};

QTEST_MAIN(SurfaceBetweenTest)
#include "surface_between_test.moc"
