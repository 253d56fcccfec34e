#include "widgets/viewport/camera_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace graftsman {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kFrameFill = 0.92;  // a margin round what is framed

/// Turns the turntable's axis to z; the front stays the front (the way of −y for an axis z, of +z for y).
Eigen::Matrix3d toAxisZ(const Camera& camera) {
  return Eigen::Quaterniond::FromTwoVectors(camera.axis, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// The camera with its directions turned by `turn` about the pivot, its axis along with them.
Camera turned(const Camera& camera, const Eigen::Matrix3d& turn) {
  return {camera.pivot + turn * (camera.position - camera.pivot), camera.pivot, turn * camera.up,
          turn * camera.axis};
}

/// The camera at these angles about the pivot and the axis z: azimuth 0 is on the x axis, elevation 90°
/// above.
Camera atAngles(const Point& pivot, double distance, double azimuth, double elevation) {
  const double ca = std::cos(azimuth);
  const double sa = std::sin(azimuth);
  const double ce = std::cos(elevation);
  const double se = std::sin(elevation);
  return {pivot + distance * Eigen::Vector3d(ce * ca, ce * sa, se),
          pivot,
          {-se * ca, -se * sa, ce},
          Eigen::Vector3d::UnitZ()};
}

}  // namespace

Eigen::Vector3d CameraView::right() const {
  const Eigen::Vector3d across = forward().cross(camera.up);
  // Looking straight along `up` (a default `up` with a view from above): the view in which y is up.
  return across.norm() > 1e-12 * camera.up.norm() ? across.normalized() : Eigen::Vector3d::UnitX();
}

double CameraView::pixelLength(double depth) const {
  return 2 * depth * std::tan(kAngle / 2) / size.height();
}

Ray CameraView::rayThrough(const QPointF& position) const {
  const double half = 0.5 / ratio;  // to the pixel's centre
  const double scale = pixelLength(1);
  const double x = (position.x() + half - size.width() / 2) * scale;
  const double y = (size.height() / 2 - position.y() - half) * scale;
  return {camera.position, (forward() + x * right() + y * up()).normalized()};
}

QPointF CameraView::project(const Point& point) const {
  const double half = 0.5 / ratio;
  const Eigen::Vector3d offset = point - camera.position;
  const double scale = pixelLength(offset.dot(forward()));
  return {size.width() / 2 + offset.dot(right()) / scale - half,
          size.height() / 2 - offset.dot(up()) / scale - half};
}

Point CameraView::onPlane(const QPointF& position, const Point& anchor) const {
  const Ray ray = rayThrough(position);
  return ray.origin + ray.direction * (depth(anchor) / ray.direction.dot(forward()));
}

Camera CameraView::framing(const Eigen::AlignedBox3d& box) const {
  const double tangentY = std::tan(kAngle / 2) * kFrameFill;
  const double tangentX = tangentY * size.width() / size.height();
  double distance = 0;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - box.center();
    const double nearer = -corner.dot(forward());
    distance = std::max({distance, nearer + std::abs(corner.dot(right())) / tangentX,
                         nearer + std::abs(corner.dot(up())) / tangentY});
  }
  if (distance <= 0) {  // a single point: any distance shows it
    distance = 1;
  }
  Camera framed = camera;
  framed.pivot = box.center();
  framed.position = framed.pivot - distance * forward();
  return framed;
}

Camera orbited(const Camera& camera, double azimuth, double elevation) {
  const Eigen::Matrix3d turn = toAxisZ(camera);
  const Camera upright = turned(camera, turn);
  const Eigen::Vector3d arm = upright.position - upright.pivot;
  const double distance = arm.norm();
  // Read from the right-hand direction, which has an azimuth also straight above the pivot.
  const Eigen::Vector3d right = CameraView{upright}.right();
  const double raised = std::asin(std::clamp(arm.z() / distance, -1.0, 1.0)) + elevation;
  Camera result = turned(atAngles(camera.pivot, distance, std::atan2(-right.x(), right.y()) - azimuth,
                                  std::clamp(raised, -kRightAngle, kRightAngle)),
                         turn.transpose());
  result.axis = camera.axis;  // to the last bit, however often it is turned
  return result;
}

Camera moved(const Camera& camera, const Eigen::Vector3d& by) {
  Camera result = camera;
  result.position += by;
  result.pivot += by;
  return result;
}

Camera zoomed(const Camera& camera, const Point& anchor, double factor) {
  Camera result = camera;
  result.position = anchor + factor * (camera.position - anchor);
  result.pivot = anchor + factor * (camera.pivot - anchor);
  return result;
}

Camera lookingFrom(const Camera& camera, AxisView view) {
  Eigen::Vector3d side = -Eigen::Vector3d::UnitY();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  switch (view) {
    case AxisView::Front:
      break;
    case AxisView::Back:
      side = Eigen::Vector3d::UnitY();
      break;
    case AxisView::Left:
      side = -Eigen::Vector3d::UnitX();
      break;
    case AxisView::Right:
      side = Eigen::Vector3d::UnitX();
      break;
    case AxisView::Top:
      side = Eigen::Vector3d::UnitZ();
      up = Eigen::Vector3d::UnitY();
      break;
    case AxisView::Bottom:
      side = -Eigen::Vector3d::UnitZ();
      up = -Eigen::Vector3d::UnitY();
      break;
  }
  const Eigen::Matrix3d back = toAxisZ(camera).transpose();
  const double distance = (camera.position - camera.pivot).norm();
  return {camera.pivot + distance * (back * side), camera.pivot, back * up, camera.axis};
}

}  // namespace graftsman
