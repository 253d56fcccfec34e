#pragma once

#include <vector>

#include "core/fusion/adjustment.h"
#include "core/fusion/embedding.h"
#include "core/fusion/tile.h"

namespace graftsman {

/// The part's adjusted tile as it is embedded: a mesh of its own, its boundary laid out on the n-gon.
struct FittedTile {
  std::vector<Point> points;               // V×3; first the boundary's B vertices in loop order from CV 0
  std::vector<Face> faces;                 // F×3
  std::vector<Index> parents;              // F; the tile's face of each
  std::vector<Index> corners;              // n; vertex corners[i] < B is CV i
  std::vector<BoundaryPosition> boundary;  // B; where the boundary lies on the n-gon
  double meanDistance =
      0;  // of the two boundary curves before the fit, over this boundary's vertices; model length
  double greatestDistance = 0;
};

/// The adjusted tile as it is, its boundary laid out in proportion to length.
[[nodiscard]] FittedTile keepBoundary(const Tile& tile, const Adjustment& adjustment);

/// The adjusted tile with its boundary carried exactly onto the base's boundary curve; the correction is
/// spread over the tile harmonically. Beyond the paper (DESIGN.md §4, "exact fit"): the paper's steps bring
/// the CVs together, and leave the boundaries between them apart, which shows as a ragged seam. The part's
/// boundary gets the base's boundary vertices (the faces there are divided), so that nothing is left between
/// the two curves; part vertices within 1e-3 of the shorter boundary edge of one take its place.
/// A tile that then differs from the base's by rounding alone becomes the base's.
/// baseBoundary: the base embedding's. Errors: those of extendHarmonically.
[[nodiscard]] Result<FittedTile> fitBoundary(const Tile& tile, const Adjustment& adjustment, const Tile& base,
                                             const std::vector<BoundaryPosition>& baseBoundary,
                                             const Progress& progress);

}  // namespace graftsman
