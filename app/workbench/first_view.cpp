#include "app/workbench/first_view.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/fusion/path_position.h"
#include "core/picture/fusion_view.h"

namespace graftsman {
namespace {

// Where the loop's points on one mesh are, as far as that is known.
std::vector<Point> loopOn(const Fusion& fusion, Side side) {
  const auto& mesh = fusion.of(side)->mesh;
  std::vector<Point> points;
  for (const CVP& pair : fusion.inputs.loop) {
    const SurfacePoint& point = side == Side::Part ? pair.part : pair.base;
    if (mesh) {
      points.push_back(positionOf(*mesh, point));
    } else if (point.place) {
      points.push_back(*point.place);
    }
  }
  return points;
}

}  // namespace

Camera firstView(const Fusion& fusion, Side side) {
  const std::shared_ptr<const MeshAsset>& asset = fusion.of(side);
  const std::vector<Point> loop = loopOn(fusion, side);
  const ViewDirection view = firstDirection(loop, guessYUp(loop, asset->report.format == MeshFormat::Obj));
  const double distance = asset->mesh ? asset->mesh->diagonal() : 1;
  return {view.towards * distance, Point::Zero(), view.up, view.up};
}

Camera withOtherUp(const Camera& camera) {
  const bool zUp = std::abs(camera.axis.z()) > std::abs(camera.axis.y());
  const Eigen::Vector3d axis = zUp ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(camera.axis, axis);
  return {camera.pivot + turn * (camera.position - camera.pivot), camera.pivot, axis, axis};
}

}  // namespace graftsman
