#pragma once

#include <vector>

#include "core/fusion/join.h"

namespace graftsman {

/// How the vertices and faces of a result are ordered for the display. A drag of the fusion curve moves the
/// tile's vertices alone; so that nothing else is sent to the graphics card again, the result is shown as
/// three sheets, each with a consecutive run of the vertices:
///
///   vertices:  far | ring | copies of the seam's | the tile's
///   rest:     └──────────┘                         base faces that no seam vertex touches
///   rim:             └──────────────────────┘      the other faces of the remainder
///   tile:                                  └────┘  the combined tile's faces
///
/// The copies let the colours change at the seam without running into each other. Ring: the vertices beside
/// the seam; their normals change where the seam moves.
struct MorphLayout {
  Index farCount = 0;
  Index ringCount = 0;
  Index seamSize = 0;
  Index tileSize = 0;
  std::vector<Index> restVertices;  // farCount + ringCount; of each vertex, the join's; far ones ascend
  std::vector<Face> restFaces;      // numbers from the first vertex
  std::vector<Face> rimFaces;       // numbers from the first of the ring

  [[nodiscard]] Index ringBegin() const { return farCount; }
  [[nodiscard]] Index seamCopiesBegin() const { return farCount + ringCount; }
  [[nodiscard]] Index tileBegin() const { return seamCopiesBegin() + seamSize; }
  [[nodiscard]] Index vertexCount() const { return tileBegin() + tileSize; }
};

/// The layout of a join. Vertices that no face uses are left out.
[[nodiscard]] MorphLayout layOut(const Join& join, const CombinedTile& combined);

/// The faces beside one edge of the seam, i → (i + 1) mod S.
struct SeamEdge {
  Index tileFace = -1;  // of the combined tile
  Index rimFace = -1;   // of the layout's; −1: the base has its own border here
};

/// The faces beside each edge of the seam.
[[nodiscard]] std::vector<SeamEdge> findSeamEdges(const MorphLayout& layout, const CombinedTile& combined);

}  // namespace graftsman
