#include "widgets/viewport/morph_still.h"

#include <algorithm>
#include <limits>

namespace graftsman {

StillSheet::StillSheet(std::span<const Point> points, std::span<const Face> faces)
    : positions_(3 * points.size() + 1), normals_(positions_.size()), faces_(faces.begin(), faces.end()) {
  for (const Point& point : points) {
    box_.extend(point);
  }
  if (box_.isEmpty()) {
    return;
  }
  centre_ = box_.center();
  box_.translate(-centre_);
  for (std::size_t v = 0; v < points.size(); ++v) {
    Eigen::Vector3f::Map(&positions_[3 * v]) = (points[v] - centre_).cast<float>();
  }
  const float length =
      std::max(static_cast<float>(box_.diagonal().norm()), std::numeric_limits<float>::min());
  std::vector<AreaVector> sums(points.size(), AreaVector::Zero());
  addAreas(positions_.data(), faces_, 1 / length, sums);
  for (std::size_t v = 0; v < points.size(); ++v) {
    writeNormal(sums[v], &normals_[3 * v]);
  }
}

MorphSheet StillSheet::sheet() const {
  return {positions_.data(), normals_.data(), static_cast<Index>(positions_.size() / 3), faces_, box_};
}

}  // namespace graftsman
