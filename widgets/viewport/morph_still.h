#pragma once

#include <span>
#include <vector>

#include "widgets/viewport/morph_surface.h"

namespace graftsman {

/// A mesh that is shown as it is: the part's tile in place.
class StillSheet {
 public:
  /// points: V×3; faces: F×3.
  StillSheet(std::span<const Point> points, std::span<const Face> faces);

  /// Its buffers belong to this; relative to centre().
  [[nodiscard]] MorphSheet sheet() const;
  [[nodiscard]] const Point& centre() const { return centre_; }

 private:
  Point centre_ = Point::Zero();
  Eigen::AlignedBox3d box_;
  std::vector<float> positions_;  // 3 × V, and one float that is read but not used
  std::vector<float> normals_;
  std::vector<Face> faces_;
};

}  // namespace graftsman
