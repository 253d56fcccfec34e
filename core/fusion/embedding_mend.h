#pragma once

#include <vector>

#include "core/fusion/embedding_tile.h"

namespace graftsman {

/// Turns the few bad faces of a layout over by moving interior vertices nearby: each into the kernel of its
/// star where there is one, otherwise to the mean of its neighbours. Returns true, with uv changed, if every
/// face is good then; false, with uv as it was, if not. badFaces: those of checkLayout(). Cost: in proportion
/// to their number. Precondition: all other faces are good.
[[nodiscard]] bool mendLayout(const EmbeddingTile& tile, const Stars& stars,
                              const std::vector<Index>& badFaces, std::vector<Point2>& uv);

}  // namespace graftsman
