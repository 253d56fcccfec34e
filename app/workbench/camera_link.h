#pragma once

#include <Eigen/Core>

#include "widgets/viewport/viewport.h"

namespace graftsman {

/// How a camera follows another one: by a similarity, so that two shapes of any size, place and upright axis
/// turn, move and grow on the screen together.
struct CameraLink {
  Eigen::Matrix3d turn =
      Eigen::Matrix3d::Identity();  // of directions round `from`'s pivot to those round `to`'s
  double scale = 1;
  Point from = Point::Zero();  // pivots at the time of linking
  Point to = Point::Zero();
};

/// The link by which `follower` sees its shape from the same side as `leader` does: their axes and the ways
/// they face are matched as they are now; only the follower's elevation gives way.
[[nodiscard]] CameraLink linkCameras(const Camera& leader, const Camera& follower);
/// The follower's camera for a leader's.
[[nodiscard]] Camera follow(const CameraLink& link, const Camera& leader);

}  // namespace graftsman
