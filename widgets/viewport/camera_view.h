#pragma once

#include <Eigen/Geometry>
#include <QPointF>
#include <QSizeF>
#include <optional>

#include "widgets/viewport/viewport.h"

namespace graftsman {

/// A half-line of the scene. `direction` has length 1.
struct Ray {
  Point origin;
  Eigen::Vector3d direction;
};

/// A camera with the pane it fills: turns places on the pane into rays of the scene and back. Places are
/// those of mouse events: device-independent, a whole device pixel meaning that pixel's centre.
struct CameraView {
  Camera camera;
  QSizeF size = {1, 1};  // of the pane, device-independent
  double ratio = 1;      // device pixels per device-independent one

  /// The vertical angle of view, in radians.
  static constexpr double kAngle = 0.5;

  [[nodiscard]] Eigen::Vector3d forward() const { return (camera.pivot - camera.position).normalized(); }
  [[nodiscard]] Eigen::Vector3d right() const;
  [[nodiscard]] Eigen::Vector3d up() const { return right().cross(forward()); }

  /// The distance of a point before the camera, along its direction; negative behind it.
  [[nodiscard]] double depth(const Point& point) const { return (point - camera.position).dot(forward()); }
  /// The length of one device-independent pixel at this depth.
  [[nodiscard]] double pixelLength(double depth) const;
  [[nodiscard]] Ray rayThrough(const QPointF& position) const;
  /// Precondition: depth(point) > 0; a point behind the camera has no place.
  [[nodiscard]] QPointF project(const Point& point) const;
  /// Where the ray through `position` meets the plane through `anchor` that faces the camera.
  [[nodiscard]] Point onPlane(const QPointF& position, const Point& anchor) const;

  /// The camera, moved along its direction, that sees all of the box, tightly, and orbits about its middle.
  [[nodiscard]] Camera framing(const Eigen::AlignedBox3d& box) const;
};

/// The camera turned about its pivot like a turntable: the axis stays up, and it stops above and below the
/// pivot instead of turning over. Radians: positive azimuth turns the scene to the right, positive elevation
/// raises the camera.
[[nodiscard]] Camera orbited(const Camera& camera, double azimuth, double elevation);
[[nodiscard]] Camera moved(const Camera& camera, const Eigen::Vector3d& by);
/// Scaled about `anchor`, which therefore stays where it is seen; factor < 1 goes nearer.
[[nodiscard]] Camera zoomed(const Camera& camera, const Point& anchor, double factor);
[[nodiscard]] Camera lookingFrom(const Camera& camera, AxisView view);

}  // namespace graftsman
