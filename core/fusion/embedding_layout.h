#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/fusion/embedding_check.h"
#include "core/fusion/laplace_system.h"

namespace graftsman {

/// What every layout of one tile starts from.
struct LayoutProblem {
  const EmbeddingTile& tile;
  const Stars& stars;
  std::span<const Point2> boundary;  // B×2; the boundary's positions
  Index sides = 0;
};

/// Positions of all vertices and what is wrong with them.
struct Layout {
  std::vector<Point2> uv;  // V'×2
  LayoutCheck check;
};

/// How much to spend on a layout that is not valid at first.
enum class Effort {
  Decide,  // no more once it is known to squeeze a protrusion
  Full
};

/// The layout of the weights. Iterates only as far as the exact signs of the faces need it, and mends a few
/// that stay wrong. start: V'×2 or empty. No value: cancelled.
[[nodiscard]] std::optional<Layout> layOut(const LayoutProblem& problem, const SlotWeights& weights,
                                           MatrixKind kind, std::span<const Point2> start, Effort effort,
                                           const Progress& progress);

}  // namespace graftsman
