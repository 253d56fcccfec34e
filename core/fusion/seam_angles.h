#pragma once

#include <span>

#include "core/fusion/join.h"

namespace graftsman {

/// How sharply a result turns at its seam: angles, in radians, between the normals of the two faces beside
/// each of its edges. 0 where the seam has no face on its other side.
struct SeamAngles {
  double mean = 0;  // weighted by the edges' length
  double greatest = 0;
};

/// points: the result's positions (R×3); seamSize: CombinedTile's. Linear cost. Triangles without area have
/// no normal and are passed over.
[[nodiscard]] SeamAngles seamAngles(std::span<const Point> points, const Join& join, Index seamSize);

}  // namespace graftsman
