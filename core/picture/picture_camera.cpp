#include "core/picture/picture_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graftsman {
namespace {

constexpr double kMargin = 0.06;           // of the picture, at each edge
constexpr double kAlongView = 1e-6;        // sine below which `up` counts as along the view
constexpr double kSmallestExtent = 1e-12;  // of a lone point's surroundings, as a fraction of its coordinates

ViewFrame frameAlong(const Eigen::Vector3d& into, const Eigen::Vector3d& up) {
  ViewFrame frame;
  frame.into = into.stableNormalized();
  if (!(frame.into.norm() > 0.5)) {
    frame.into = Eigen::Vector3d::UnitY();
  }
  frame.right = frame.into.cross(up.stableNormalized());
  if (!(frame.right.norm() > kAlongView)) {
    frame.right = frame.into.unitOrthogonal();
  }
  frame.right.normalize();
  frame.up = frame.right.cross(frame.into);
  return frame;
}

// Tangents of half the view angles less the margin, to the right and upwards.
Eigen::Vector2d tangents(double aspect) {
  const double vertical = std::tan(PictureCamera().viewAngle / 2) * (1 - 2 * kMargin);
  return {vertical * aspect, vertical};
}

Eigen::AlignedBox3d boxOf(std::span<const Point> points) {
  Eigen::AlignedBox3d box;
  for (const Point& p : points) {
    box.extend(p);
  }
  return box;
}

// How far from `pivot` a camera must be that looks at it and has the points in view.
double distanceToFrame(std::span<const Point> points, const Point& pivot, const ViewFrame& frame,
                       const Eigen::Vector2d& tangent) {
  double distance = 0;
  for (const Point& p : points) {
    const Eigen::Vector3d d = p - pivot;
    const double nearer = -frame.into.dot(d);
    distance = std::max({distance, nearer + std::abs(frame.right.dot(d)) / tangent.x(),
                         nearer + std::abs(frame.up.dot(d)) / tangent.y()});
  }
  return distance;
}

}  // namespace

ViewFrame viewFrame(const PictureCamera& camera) {
  return frameAlong(camera.pivot - camera.position, camera.up);
}

ViewFrame viewFrame(const ViewDirection& direction) {
  return frameAlong(-direction.towards, direction.up);
}

PictureCamera frame(std::span<const Point> points, const ViewDirection& direction, double aspect) {
  const ViewFrame axes = viewFrame(direction);
  const Eigen::Vector2d tangent = tangents(aspect);
  const Eigen::AlignedBox3d box = boxOf(points);
  const Point centre = box.center();
  // Of x ± z tan, and y ± z tan: the planes through the picture's edges that touch the points.
  Eigen::Array2d plus = Eigen::Array2d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Array2d minus = plus;
  for (const Point& p : points) {
    const Eigen::Vector3d d = p - centre;
    const double nearer = -axes.into.dot(d);
    const Eigen::Array2d aside(axes.right.dot(d), axes.up.dot(d));
    plus = plus.max(aside + nearer * tangent.array());
    minus = minus.max(-aside + nearer * tangent.array());
  }
  const Eigen::Array2d middle = (plus - minus) / 2;
  double distance = ((plus + minus) / (2 * tangent.array())).maxCoeff();
  distance = std::max(distance, kSmallestExtent * (1 + centre.norm()));
  PictureCamera camera;
  camera.pivot = centre + middle.x() * axes.right + middle.y() * axes.up;
  camera.position = camera.pivot - distance * axes.into;
  camera.up = axes.up;
  return camera;
}

PictureCamera frameBox(const Point& low, const Point& high, const ViewDirection& direction, double aspect) {
  std::array<Point, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                  (i & 4) != 0 ? high.z() : low.z()};
  }
  return frame(corners, direction, aspect);
}

std::vector<PictureCamera> turntable(std::span<const Point> points, const ViewDirection& direction,
                                     double aspect, int count) {
  const Point centre = boxOf(points).center();
  const Eigen::Vector3d axis = direction.up.stableNormalized();
  std::vector<PictureCamera> cameras;
  std::vector<ViewFrame> views;
  double distance = kSmallestExtent * (1 + centre.norm());
  for (int i = 0; i < count; ++i) {
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * i / count, axis);
    views.push_back(viewFrame(ViewDirection{turn * direction.towards, axis}));
    distance = std::max(distance, distanceToFrame(points, centre, views.back(), tangents(aspect)));
  }
  for (const ViewFrame& view : views) {
    PictureCamera camera;
    camera.pivot = centre;
    camera.position = centre - distance * view.into;
    camera.up = axis;
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace graftsman
