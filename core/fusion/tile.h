#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/fusion/cut.h"

namespace graftsman {

/// The disk enclosed by a loop (Kanai et al. 1999, §2.1), as a mesh of its own.
struct Tile {
  std::vector<Point>
      points;  // V×3; first the boundary's B vertices in loop order from CV 0, then the interior
  std::vector<Face> faces;  // F×3; first the undivided faces of the mesh, ascending, then pieces of the cut
  Index boundarySize = 0;   // B
  std::vector<Index> corners;  // n; vertex corners[i] < B is CV i; corners[0] = 0
  std::vector<Index>
      vertices;  // V; each vertex's number in the cut (mesh vertex, or mesh V + index of new point)
  std::vector<Index> wholeFaces;  // mesh faces of the first faces, ascending
  std::vector<Index> pieces;      // indices into Cut::faces of the remaining faces, ascending
};

struct TileOptions {
  bool allowLargeTile = false;  // accept a base tile that is most of a closed mesh
};

/// Gathers the faces left of the oriented boundary edges by flood fill. Cost: in proportion to the tile, not
/// the mesh (apart from one mark per face). Errors, each with side and remedy: TileNotSeparated,
/// TileHasHandle, TileHasHole (a border loop of the mesh inside), TileNotManifold (a singular vertex inside,
/// with its number), TileEmpty, TileClockwise (side Base only: the mesh's component is closed and the tile
/// has more than half of its area, unless allowLargeTile), Cancelled.
[[nodiscard]] Result<Tile> gatherTile(const TriangleMesh& mesh, const Cut& cut, Side side,
                                      const TileOptions& options, const Progress& progress);

}  // namespace graftsman
