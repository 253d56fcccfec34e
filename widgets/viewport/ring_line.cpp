#include "widgets/viewport/ring_line.h"

#include <Eigen/Core>

namespace graftsman {

void RingLine::find(const CombinedTile& combined, double s) {
  crossings_.clear();
  if (s <= 0) {
    for (Index k = 0; k < combined.seamSize; ++k) {
      crossings_.push_back({k, k, 0});
      crossings_.push_back({k, k + 1 == combined.seamSize ? 0 : k + 1, 1});
    }
    return;
  }
  const double* const values = combined.s.data();
  for (const Face& face : combined.faces) {
    const std::array<bool, 3> inside = {values[face[0]] >= s, values[face[1]] >= s, values[face[2]] >= s};
    if (inside[0] == inside[1] && inside[1] == inside[2]) {
      continue;
    }
    // Two of the three sides lead from one side of the ring to the other.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (inside[k] != inside[next]) {
        const double from = values[face[k]];
        crossings_.push_back({face[k], face[next], (s - from) / (values[face[next]] - from)});
      }
    }
  }
}

void RingLine::place(const float* tilePositions) {
  positions_.resize(3 * crossings_.size());
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    const RingCrossing& at = crossings_[i];
    const auto t = static_cast<float>(at.t);
    const auto from = Eigen::Vector3f::Map(tilePositions + std::ptrdiff_t{3} * at.from);
    const auto to = Eigen::Vector3f::Map(tilePositions + std::ptrdiff_t{3} * at.to);
    Eigen::Vector3f::Map(&positions_[3 * i]) = (1 - t) * from + t * to;
  }
}

void RingLine::clear() {
  crossings_.clear();
  positions_.clear();
}

}  // namespace graftsman
