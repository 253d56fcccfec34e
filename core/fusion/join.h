#pragma once

#include <vector>

#include "core/fusion/combined_tile.h"
#include "core/fusion/cut.h"
#include "core/fusion/tile.h"

namespace graftsman {

/// The combined tile joined to the remainder of the base (Kanai et al. 1999, §2.2): everything of the result
/// but the positions that the fusion curve decides.
///
/// The result's vertices: the base's that do not lie inside the tile, in their order; then the seam's that
/// the base does not have; then the combined tile's interior. Its faces: the base's undivided ones outside
/// the tile, in their order; then pieces of the divided ones; then the combined tile's.
struct Join {
  std::vector<Point> points;        // R×3; at the combined tile's vertices its base positions
  std::vector<Face> faces;          // the whole result's
  std::vector<Index> tileVertices;  // of each vertex of the combined tile, the result's vertex
  std::vector<Index> baseVertices;  // K; of each of the first K vertices, the base's vertex
  Index restFaces = 0;              // the first faces: the remainder's
  Index wholeFaces = 0;             // of these, the first are undivided faces of the base …
  std::vector<Index> baseFaces;     // restFaces; … and this is each one's face, or parent, in the base
};

/// Joins. No T-junctions: remainder faces beside the seam are divided for the seam's vertices that the part
/// brought, in triangles of which none has three vertices on one edge of its parent.
[[nodiscard]] Join join(const TriangleMesh& base, const Cut& cut, const Tile& tile,
                        const CombinedTile& combined);

}  // namespace graftsman
