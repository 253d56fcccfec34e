#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/fusion/embedding.h"
#include "core/fusion/tile_locations.h"

namespace graftsman {

/// Where a vertex of the seam lies on a tile's boundary: at its vertex `edge` if t = 0, otherwise on the
/// boundary edge edge → edge + 1 (mod B), at the fraction t of it.
struct SeamPosition {
  Index edge = 0;
  double t = 0;
};

/// The common refinement of two embeddings (Kanai et al. 1999, §2.2): every triangle lies in exactly one
/// triangle of each.
struct CombinedTile {
  std::vector<Point> part;               // V×3; each vertex's position on the adjusted part
  std::vector<Point> base;               // V×3; each vertex's position on the base
  std::vector<Point2> uv;                // V×2
  std::vector<double> s;                 // V; distance from the seam, 0 on it, 1 at the centre
  std::vector<Face> faces;               // F×3, counter-clockwise
  std::vector<Index> partFaces;          // F; the part embedding's face that each lies in
  std::vector<Index> baseFaces;          // F
  TileLocations onPart;                  // V
  TileLocations onBase;                  // V
  Index seamSize = 0;                    // the first vertices are the seam, in loop order from CV 0
  std::vector<SeamPosition> seamOnPart;  // seamSize
  std::vector<SeamPosition> seamOnBase;  // seamSize
};

/// One tile as the overlay needs it.
struct EmbeddedTile {
  std::span<const Point> points;  // V×3; the tile's (without the embedding's added vertices)
  const Embedding& embedding;
};

/// Overlays the two embeddings. Exact predicates on the stored doubles and combinatorics only; zeros are
/// decided as if the base's interior vertices were shifted by (ε, ε²). Cost O(V + crossings). Part vertices
/// that come within 1e-3 of the shortest edge there to a base vertex are put at that vertex, where the part's
/// embedding stays valid (boundary to boundary, interior to interior): the embedding is free to that extent,
/// and needles are not wanted. Errors: CombinedTileTooFine, Cancelled.
[[nodiscard]] Result<CombinedTile> overlay(const EmbeddedTile& part, const EmbeddedTile& base,
                                           const Progress& progress);

/// s of a point of the n-gon: (distance to the nearest side) / cos(π/n), in [0, 1] (Kanai et al. 1999, §2.3).
/// Differs: the paper prints s = 1 − l/L, which its text and Fig. 3 contradict.
[[nodiscard]] double seamDistance(Index sides, const Point2& uv);

}  // namespace graftsman
