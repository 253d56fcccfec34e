#pragma once

#include <optional>
#include <vector>

#include "widgets/viewport/morph_surface.h"

namespace graftsman {

/// Where a ray meets a sheet.
struct SheetHit {
  Index face = -1;  // of the sheet
  float distance = 0;
  Eigen::Vector3f weights = Eigen::Vector3f::Zero();  // of the face's corners
};

/// Casts rays on a sheet. Faces are looked at in blocks of consecutive ones, whose boxes are cheap to bring
/// up to date when the sheet moves.
class SheetRays {
 public:
  /// Does not measure yet. Precondition: the sheet's buffers outlive this.
  explicit SheetRays(const MorphSheet& sheet) : sheet_(sheet) {}

  /// Computes the blocks' boxes anew: before the first ray, and whenever the sheet has moved.
  void measure();

  /// The nearest face, seen from either side, that the ray meets at a distance in (0, before). Origin
  /// relative to the surface's centre; direction of length 1.
  [[nodiscard]] std::optional<SheetHit> nearest(const Eigen::Vector3f& origin,
                                                const Eigen::Vector3f& direction, float before) const;

 private:
  MorphSheet sheet_;
  std::vector<Eigen::AlignedBox3f> boxes_;  // of each block
};

}  // namespace graftsman
