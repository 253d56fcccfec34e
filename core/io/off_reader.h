#pragma once

#include "core/io/raw_mesh.h"

namespace graftsman {

/// The vertices and faces of an OFF file in text, also COFF, NOFF, STOFF and their combinations. A vertex and
/// a face each begin a line; normals, colours and texture coordinates at its end are passed over. The keyword
/// may be missing if the file begins with the counts. Errors: FileMalformed with the line (4OFF, nOFF and
/// binary files are refused), Cancelled.
[[nodiscard]] Result<RawMesh> readOff(const ReadInput& input);

}  // namespace graftsman
