#pragma once

#include "core/io/assemble.h"

namespace graftsman {

/// parseMesh() without the last step: points and triangles, nothing about neighbours. Same errors; a file
/// without a face is none here.
[[nodiscard]] Result<TriangleSoup> parseTriangles(std::span<const char> bytes, MeshFormat format,
                                                  const std::filesystem::path& path,
                                                  const Progress& progress);

}  // namespace graftsman
