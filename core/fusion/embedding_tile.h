#pragma once

#include <span>
#include <vector>

#include "core/fusion/embedding.h"

namespace graftsman {

/// A tile made ready for embedding: no interior edge joins two boundary vertices, lengths are about 1.
struct EmbeddingTile {
  std::vector<Point> points;       // V'×3; scaled by a power of two to an extent in [0.5, 1)
  std::vector<Face> faces;         // F'×3
  std::vector<Index> parents;      // F'; the face each came from
  std::vector<AddedVertex> added;  // V' − V
  Index boundarySize = 0;          // B; vertices 0 … B − 1 are the boundary, the others are interior
  std::vector<double> areas;       // F'; share of each face in the tile's area, 1/F' each if that is 0

  [[nodiscard]] Index interiorCount() const { return static_cast<Index>(points.size()) - boundarySize; }
};

/// Divides every interior edge between two boundary vertices at its midpoint, and a tile that is one triangle
/// at its centre. Faces without such an edge keep their order and stand first among their pieces' places.
/// Precondition: finite points; faces form a disk with boundary 0 … B − 1 counter-clockwise.
[[nodiscard]] EmbeddingTile prepareTile(std::span<const Point> points, std::span<const Face> faces,
                                        Index boundarySize);

/// The neighbours of the interior vertices, in order. Interior vertex i of the tile is row i − B.
struct Stars {
  std::vector<Index> offsets;    // I + 1; slots of row r: offsets[r] … offsets[r + 1] − 1
  std::vector<Index> ring;       // the neighbours of a row, counter-clockwise
  std::vector<Index> halfedges;  // 3f + k: vertex k of face f is the row's, its next vertex is ring[slot]
};

/// The stars of all interior vertices. Linear cost.
[[nodiscard]] Stars gatherStars(const EmbeddingTile& tile);

}  // namespace graftsman
