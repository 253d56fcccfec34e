#pragma once

#include <span>
#include <string>

#include "core/io/mesh_file.h"

namespace graftsman {

/// The bytes of a mesh file. points: V×3; faces: F×3, every corner in [0, V). Text has the fewest digits that
/// read back as the same double, −0 included; binary PLY is little-endian and holds doubles, binary STL
/// floats. The file's name is for messages only. Errors: FileUnwritable (a coordinate that is not finite, or
/// too large for STL's floats; more vertices or faces than the format can count), Cancelled.
[[nodiscard]] Result<std::string> formatMesh(MeshFormat format, const std::filesystem::path& path,
                                             std::span<const Point> points, std::span<const Face> faces,
                                             const WriteOptions& options, const Progress& progress);

}  // namespace graftsman
