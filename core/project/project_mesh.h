#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"
#include "core/project/zip_reader.h"

namespace graftsman {

/// A mesh as an entry of a project: "grafmesh", the number of vertices and of faces (int32), the positions
/// (V×3 doubles), the faces (F×3 int32), all little-endian, nothing between. Bits are preserved.
class MeshEntry {
 public:
  /// `mesh` must outlive the blocks.
  explicit MeshEntry(const TriangleMesh& mesh);
  MeshEntry(const MeshEntry&) = delete;
  MeshEntry& operator=(const MeshEntry&) = delete;

  /// The entry's bytes: header, positions, faces.
  [[nodiscard]] const std::array<std::string_view, 3>& blocks() const { return blocks_; }
  /// Of all of them.
  [[nodiscard]] std::uint32_t crc32() const;

 private:
  std::array<char, 16> header_ = {};
  std::array<std::string_view, 3> blocks_;
};

/// The mesh of an entry. Errors: FileMalformed, one clause about the entry (also: no mesh, a face that names
/// no vertex or the same one twice, a coordinate that is no finite number, no face); Cancelled.
[[nodiscard]] Result<std::shared_ptr<const TriangleMesh>> readMeshEntry(ZipReader& zip, const ZipEntry& entry,
                                                                        const Progress& progress);

}  // namespace graftsman
