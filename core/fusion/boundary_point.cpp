#include <cmath>
#include <numbers>

#include "core/fusion/embedding.h"

namespace graftsman {
namespace {

Point2 corner(Index sides, Index i) {
  const double angle = 2 * std::numbers::pi * (i % sides) / sides;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Point2 boundaryPoint(Index sides, const BoundaryPosition& position) {
  Point2 a = corner(sides, position.side);
  if (position.t == 0) {
    return a;
  }
  return a + position.t * (corner(sides, position.side + 1) - a);
}

}  // namespace graftsman
