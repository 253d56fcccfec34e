#pragma once

#include <Eigen/Core>
#include <numbers>
#include <span>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Where a picture is taken from, in perspective. Model length.
struct PictureCamera {
  Point position = {0, -1, 0};
  Point pivot = Point::Zero();                    // in the middle of the picture
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  // in the picture, as far as it is not along the view
  double viewAngle = std::numbers::pi / 6;        // radians; between the picture's upper and lower edge
};

/// A way to look: from `towards` to the middle of what is shown. Neither needs length 1.
struct ViewDirection {
  Eigen::Vector3d towards = {0.45, -1, 0.3};  // from what is shown to the camera
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
};

/// Unit vectors of a view: to the right and to the top of the picture, and into it. Always at right angles,
/// whatever the camera.
struct ViewFrame {
  Eigen::Vector3d right;
  Eigen::Vector3d up;
  Eigen::Vector3d into;
};

[[nodiscard]] ViewFrame viewFrame(const PictureCamera& camera);
[[nodiscard]] ViewFrame viewFrame(const ViewDirection& direction);

/// The camera nearest to the points (N×3, N ≥ 1) that has all of them in view, with a margin of 6 % of the
/// picture. `aspect`: width / height. Exact, linear cost. The pivot is as deep as the middle of the points.
[[nodiscard]] PictureCamera frame(std::span<const Point> points, const ViewDirection& direction,
                                  double aspect);

/// The same for the corners of a box.
[[nodiscard]] PictureCamera frameBox(const Point& low, const Point& high, const ViewDirection& direction,
                                     double aspect);

/// `count` cameras evenly round the points, at one distance, that has them in view from everywhere: the first
/// looks as `direction` says, the others turn about its `up` through the middle of the points' box.
[[nodiscard]] std::vector<PictureCamera> turntable(std::span<const Point> points,
                                                   const ViewDirection& direction, double aspect, int count);

}  // namespace graftsman
