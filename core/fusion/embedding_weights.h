#pragma once

#include <vector>

#include "core/fusion/embedding_tile.h"

namespace graftsman {

/// One weight per slot of the stars: row i of the embedding says Σ w (ring − i) = 0.
using SlotWeights = std::vector<double>;

/// Cotangent weights (Pinkall & Polthier 1993), the discrete harmonic map. Symmetric, can be negative, the
/// matrix is positive definite. A triangle flatter than kFlat counts as one of that flatness, one without
/// extent as equilateral, so every weight is finite.
[[nodiscard]] SlotWeights cotangentWeights(const EmbeddingTile& tile, const Stars& stars);

/// Mean value weights (Floater 2003). Positive, not symmetric; their map into a convex polygon cannot flip.
[[nodiscard]] SlotWeights meanValueWeights(const EmbeddingTile& tile, const Stars& stars);

/// All 1 (Tutte 1963).
[[nodiscard]] SlotWeights uniformWeights(const Stars& stars);

}  // namespace graftsman
