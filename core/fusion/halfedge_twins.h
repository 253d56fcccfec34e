#pragma once

#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// The opposite halfedge of each of the 3F halfedges, −1 on the border. Precondition: the faces form an
/// oriented manifold. Linear cost, no hashing.
[[nodiscard]] std::vector<Index> pairHalfedges(std::span<const Face> faces, Index vertexCount);

}  // namespace graftsman
