#pragma once

#include "core/io/raw_mesh.h"

namespace graftsman {

/// The facets of an STL file, ASCII or binary, their corners welded and numbered by first appearance. The
/// normals are passed over. A file is binary if its size is the one that its facet count asks for, whatever
/// it begins with. Errors: FileMalformed with the line, or the byte in a binary file; Cancelled.
[[nodiscard]] Result<RawMesh> readStl(const ReadInput& input);

}  // namespace graftsman
