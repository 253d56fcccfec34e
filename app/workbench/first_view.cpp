#include "app/workbench/first_view.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/fusion/path_position.h"

namespace graftsman {
namespace {

// How far the first view is turned from the loop's normal, as parts of it: shapes show their depth.
constexpr double kBeside = 0.45;
constexpr double kAbove = 0.3;
// A normal within about 35° of the axis: seen from there, the axis could not be up.
constexpr double kAlong = 0.8;

// The normal of the polygon through the CVs (Newell's), outward for a loop that is counter-clockwise. Zero:
// none.
Eigen::Vector3d loopNormal(const Fusion& fusion, Side side) {
  const auto& mesh = fusion.of(side)->mesh;
  const Loop& loop = fusion.inputs.loop;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  if (loop.size() < 3 || (!mesh && fusion.upstream(side) == 0)) {
    return normal;
  }
  const auto at = [&](std::size_t i) {
    const CVP& pair = loop[i % loop.size()];
    const SurfacePoint& point = side == Side::Part ? pair.part : pair.base;
    return mesh ? positionOf(*mesh, point) : point.place.value_or(Point::Zero());
  };
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    normal += (at(i) - at(0)).cross(at(i + 1) - at(0));
  }
  return normal.stableNormalized();
}

}  // namespace

Camera firstView(const Fusion& fusion, Side side) {
  const std::shared_ptr<const MeshAsset>& asset = fusion.of(side);
  const bool yUp = asset->report.format == MeshFormat::Obj;
  Eigen::Vector3d up = yUp ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  Eigen::Vector3d front = yUp ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(-Eigen::Vector3d::UnitY());
  const Eigen::Vector3d normal = loopNormal(fusion, side);
  if (std::abs(normal.dot(up)) <= kAlong) {
    front = normal.norm() > 0.5 ? normal : front;
  } else if (yUp) {
    // Rather an OBJ file in which z is up than a region on top: the front is a loop's usual place.
    up = Eigen::Vector3d::UnitZ();
    front = normal;
  } else {
    front = (front + 1.5 * normal).normalized();
  }
  const Eigen::Vector3d beside = up.cross(front);
  const Eigen::Vector3d direction = (front + kBeside * beside + kAbove * up).normalized();
  const double distance = asset->mesh ? asset->mesh->diagonal() : 1;
  return {direction * distance, Point::Zero(), up, up};
}

Camera withOtherUp(const Camera& camera) {
  const bool zUp = std::abs(camera.axis.z()) > std::abs(camera.axis.y());
  const Eigen::Vector3d axis = zUp ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(camera.axis, axis);
  return {camera.pivot + turn * (camera.position - camera.pivot), camera.pivot, axis, axis};
}

}  // namespace graftsman
