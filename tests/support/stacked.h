#pragma once

#include <Eigen/Geometry>

#include "core/mesh/attach.h"
#include "core/project/document_edits.h"
#include "core/project/edits.h"
#include "core/project/evaluate.h"
#include "tests/support/documents.h"

/// A document in which fusions are made of fusions.
namespace graftsman::samples {

/// Fusion 1: a cone on a sphere (Fig. 4c). Fusion 2: the same cone on its result, on the opposite side.
inline Document twoConesOnASphere() {
  const Fusion first = fusion("fig4c_cone_sphere");
  Document document = documentOf(first);
  document = edits::addFusion(std::move(document), first.part, nullptr);
  document = *edits::takeResult(std::move(document), 2, Side::Base, 1);
  Evaluated known;
  const Evaluation evaluation = evaluate(document.fusions, 2, known, {});
  Fusion second = evaluation.fusion;
  Point middle = Point::Zero();
  for (const CVP& pair : first.inputs.loop) {
    middle += first.inputs.base->point(pair.base.vertex);
  }
  middle /= static_cast<double>(first.inputs.loop.size());
  // Half a turn about an axis through the sphere's middle, square to the direction of the tile.
  Point centre = Point::Zero();
  for (const Point& point : first.inputs.base->points()) {
    centre += point;
  }
  centre /= first.inputs.base->vertexCount();
  const Eigen::Vector3d axis = (middle - centre).unitOrthogonal();
  const Eigen::AngleAxisd half(EIGEN_PI, axis);
  for (const CVP& pair : first.inputs.loop) {
    SurfacePoint base = SurfacePoint::atVertex(0);
    base.place = centre + half * (first.inputs.base->point(pair.base.vertex) - centre);
    second =
        *edits::insertPair(second, second.inputs.loop.size(), {pair.part, attach(*second.inputs.base, base)});
  }
  second.inputs.fcf = first.inputs.fcf;
  return edits::withFusion(std::move(document), *edits::closeLoop(second));
}

}  // namespace graftsman::samples
