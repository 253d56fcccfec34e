#pragma once

#include <vector>

#include "core/fusion/embedding.h"

namespace graftsman::overlay_detail {

/// The part's boundary parameters, with vertices that come very near to a base boundary vertex put at that
/// vertex's parameter, each only where the part's triangles there stay counter-clockwise. The order stays, no
/// corner moves, and no two vertices get one parameter.
[[nodiscard]] std::vector<BoundaryPosition> snapBoundary(const Embedding& part, const Embedding& base);

}  // namespace graftsman::overlay_detail
