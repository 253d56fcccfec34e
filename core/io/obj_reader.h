#pragma once

#include "core/io/raw_mesh.h"

namespace graftsman {

/// The vertices and faces of a Wavefront OBJ file. Keywords other than v and f, texture and normal numbers,
/// colours and weights are passed over. A face may name vertices that come later in the file. Errors:
/// FileMalformed with the line, Cancelled.
[[nodiscard]] Result<RawMesh> readObj(const ReadInput& input);

}  // namespace graftsman
