#pragma once

#include "core/io/raw_mesh.h"

namespace graftsman {

/// The vertices and faces of a PLY file, ASCII or binary of either order. Takes x, y, z of the element
/// "vertex" in any scalar type, and the list "vertex_indices" or "vertex_index" of the element "face"; passes
/// over all other elements and properties. Errors: FileMalformed with the line, or the byte in a binary file
/// (triangle strips are refused); Cancelled.
[[nodiscard]] Result<RawMesh> readPly(const ReadInput& input);

}  // namespace graftsman
