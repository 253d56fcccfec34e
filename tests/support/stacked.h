#pragma once

#include <Eigen/Geometry>

#include "core/mesh/attach.h"
#include "core/project/document_edits.h"
#include "core/project/edits.h"
#include "core/project/evaluate.h"
#include "tests/support/documents.h"

/// A document in which fusions are made of fusions.
namespace graftsman::samples {

/// The sphere that the base of a fusion is.
struct Sphere {
  Point centre = Point::Zero();
  Eigen::Vector3d tile = Eigen::Vector3d::Zero();  // of length 1: where the loop is, from the centre
};

inline Sphere sphereOf(const Fusion& fusion) {
  Sphere sphere;
  for (const Point& point : fusion.inputs.base->points()) {
    sphere.centre += point;
  }
  sphere.centre /= fusion.inputs.base->vertexCount();
  for (const CVP& pair : fusion.inputs.loop) {
    sphere.tile += fusion.inputs.base->point(pair.base.vertex) - sphere.centre;
  }
  sphere.tile.normalize();
  return sphere;
}

/// The loop of `fusion` on the sphere that its base is, drawn together to `width` of its own about its middle
/// and turned about the sphere's, each point found again on `mesh`.
inline std::vector<SurfacePoint> turnedLoop(const Fusion& fusion, const Eigen::Matrix3d& turn, double width,
                                            const TriangleMesh& mesh) {
  const Sphere sphere = sphereOf(fusion);
  std::vector<SurfacePoint> points;
  for (const CVP& pair : fusion.inputs.loop) {
    const Eigen::Vector3d from = fusion.inputs.base->point(pair.base.vertex) - sphere.centre;
    const Eigen::Vector3d drawn = width * from + (1 - width) * from.norm() * sphere.tile;
    SurfacePoint point = SurfacePoint::atVertex(0);
    point.place = sphere.centre + turn * (width < 1 ? from.norm() * drawn.normalized() : from);
    points.push_back(attach(mesh, point));
  }
  return points;
}

/// With another fusion: the cone of `first` on the result of fusion `base`, where the turn takes its tile,
/// `width` times as wide.
inline Document withConeOn(Document document, const Fusion& first, FusionId base, const Eigen::Matrix3d& turn,
                           double width = 1) {
  document = edits::addFusion(std::move(document), first.part, nullptr);
  const FusionId id = document.fusions.back()->id;
  document = *edits::takeResult(std::move(document), id, Side::Base, base);
  Evaluated known;
  Fusion fusion = evaluate(document.fusions, id, known, {}).fusion;
  const std::vector<SurfacePoint> points = turnedLoop(first, turn, width, *fusion.inputs.base);
  for (std::size_t i = 0; i < points.size(); ++i) {
    fusion = *edits::insertPair(fusion, i, {first.inputs.loop[i].part, points[i]});
  }
  fusion.inputs.fcf = first.inputs.fcf;
  return edits::withFusion(std::move(document), *edits::closeLoop(fusion));
}

/// Fusion 1: a cone on a sphere (Fig. 4c). Fusion 2: the same cone on its result, on the opposite side.
inline Document twoConesOnASphere() {
  const Fusion first = fusion("fig4c_cone_sphere");
  const Eigen::Vector3d axis = sphereOf(first).tile.unitOrthogonal();
  return withConeOn(documentOf(first), first, 1, Eigen::AngleAxisd(EIGEN_PI, axis).toRotationMatrix());
}

/// Fusions 1, 2, 3: a cone each, one on the result of the other, half and quarter turns apart. Fusion 4: a
/// cone on the sphere. Fusion 5: the part of fusion 4's result that is round its cone, on the result of
/// fusion 3.
inline Document fiveStackedFusions() {
  const Fusion first = fusion("fig4c_cone_sphere");
  const Eigen::Vector3d axis = sphereOf(first).tile.unitOrthogonal();
  const auto turn = [](double angle, const Eigen::Vector3d& about) {
    return Eigen::AngleAxisd(angle, about).toRotationMatrix();
  };
  Document document = withConeOn(documentOf(first), first, 1, turn(EIGEN_PI, axis));
  document = withConeOn(std::move(document), first, 2, turn(EIGEN_PI / 2, axis), 0.5);
  document = edits::addFusion(std::move(document), first.part, first.base);
  Fusion fourth = first;
  fourth.id = 4;
  document = edits::withFusion(std::move(document), fourth);
  document = edits::addFusion(std::move(document), nullptr, nullptr);
  document = *edits::takeResult(std::move(document), 5, Side::Part, 4);
  document = *edits::takeResult(std::move(document), 5, Side::Base, 3);
  Evaluated known;
  Fusion fifth = evaluate(document.fusions, 5, known, {}).fusion;
  const auto part = turnedLoop(first, Eigen::Matrix3d::Identity(), 1, *fifth.inputs.part);
  const auto base = turnedLoop(first, turn(-EIGEN_PI / 2, axis), 0.5, *fifth.inputs.base);
  for (std::size_t i = 0; i < part.size(); ++i) {
    fifth = *edits::insertPair(fifth, i, {part[i], base[i]});
  }
  return edits::withFusion(std::move(document), *edits::closeLoop(fifth));
}

}  // namespace graftsman::samples
