#pragma once

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// The distance of p from the triangle a, b, c, too great by some ulps of the greatest difference of the four
/// points' coordinates at most, however thin the triangle: a needle has no normal to speak of.
[[nodiscard]] double distanceToTriangle(const Point& p, const Point& a, const Point& b, const Point& c);

}  // namespace graftsman
