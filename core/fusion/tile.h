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
/// the mesh (apart from a few bits per face and vertex).
/// Errors, each with side and remedy (that is to reverse the loop where the reversed one would have a tile):
/// - TileEmpty: the loop runs along the mesh's border with nothing on its left;
/// - TileNotSeparated: the right side of the loop is reached from the left;
/// - TileNotManifold: a singular vertex on the loop or inside, with its number;
/// - TileHasHole: a border of the mesh inside, with a vertex of it;
/// - TileHasHandle;
/// - TileClockwise (side Base, unless allowLargeTile): the tile has more than half of the area of its
///   component, and what is right of the loop is a disk, too, so that the component is a closed one without
///   handles;
/// - Cancelled.
[[nodiscard]] Result<Tile> gatherTile(const TriangleMesh& mesh, const Cut& cut, Side side,
                                      const TileOptions& options, const Progress& progress);

}  // namespace graftsman
