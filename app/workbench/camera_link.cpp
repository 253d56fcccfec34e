#include "app/workbench/camera_link.h"

#include <Eigen/Geometry>

namespace graftsman {
namespace {

// The camera's axis, its way without elevation, and across; as columns.
Eigen::Matrix3d uprightFrame(const Camera& camera) {
  const Eigen::Vector3d up = camera.axis;
  Eigen::Vector3d way = camera.pivot - camera.position;
  way -= up * up.dot(way);
  // Along the axis there is no way without elevation: any one does.
  way = way.norm() > 1e-9 * (camera.pivot - camera.position).norm() ? Eigen::Vector3d(way.normalized())
                                                                    : Eigen::Vector3d(up.unitOrthogonal());
  Eigen::Matrix3d frame;
  frame << up, way, up.cross(way);
  return frame;
}

}  // namespace

CameraLink linkCameras(const Camera& leader, const Camera& follower) {
  return {uprightFrame(follower) * uprightFrame(leader).transpose(),
          (follower.position - follower.pivot).norm() / (leader.position - leader.pivot).norm(), leader.pivot,
          follower.pivot};
}

Camera follow(const CameraLink& link, const Camera& leader) {
  const auto carried = [&](const Point& point) -> Point {
    return link.to + link.scale * (link.turn * (point - link.from));
  };
  return {carried(leader.position), carried(leader.pivot), link.turn * leader.up, link.turn * leader.axis};
}

}  // namespace graftsman
