#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace graftsman {

enum class MeshFormat { Obj, Ply, Stl, Off };

/// What reading a mesh file did to its content, for a person.
struct ReadReport {
  MeshFormat format = MeshFormat::Obj;
  bool binary = false;
  std::size_t fileVertices = 0;  // as the file has them; for STL three a facet
  std::size_t fileFaces = 0;     // polygons
  std::size_t triangulated = 0;  // polygons with more than three corners that were divided
  std::size_t welded = 0;  // vertices merged into an equal one (STL, and files whose faces share no vertex)
  std::size_t droppedDegenerate = 0;  // triangles with a repeated vertex
  std::size_t droppedDuplicate =
      0;                     // triangles that repeat an earlier one, same vertices in the same cyclic order
  std::size_t isolated = 0;  // vertices that no face uses (kept)
};

/// A mesh as read.
struct MeshFile {
  std::shared_ptr<const TriangleMesh> mesh;
  /// The mesh's vertex of each vertex of the file; empty where they are the same. STL: the file's vertices
  /// are numbered by first appearance of equal coordinates, which is the mesh's own order, so empty.
  std::vector<Index> vertexOfFileVertex;
  ReadReport report;
};

/// The format that the file name's ending names, in any case. Error: FormatUnknown (lists those known).
[[nodiscard]] Result<MeshFormat> formatOf(const std::filesystem::path& path);

/// Reads OBJ, PLY (ASCII, both binary orders), STL (ASCII, binary) or OFF (also COFF, NOFF, STOFF and their
/// combinations). Errors: FileUnreadable, FormatUnknown, FileMalformed (names line, or byte in a binary
/// file), MeshEmpty, OutOfMemory, Cancelled. Memory: a small multiple of the file's size, whatever its header
/// says.
[[nodiscard]] Result<MeshFile> readMesh(const std::filesystem::path& path, const Progress& progress);

/// The same from bytes in memory; `path` stands in messages only.
[[nodiscard]] Result<MeshFile> parseMesh(std::span<const char> bytes, MeshFormat format,
                                         const std::filesystem::path& path, const Progress& progress);

struct WriteOptions {
  bool binary = true;  // PLY and STL; OBJ and OFF are always text
};

/// Writes a mesh in the format that the name's ending says. Positions in text files and in binary PLY (type
/// double) read back bit for bit; binary STL holds floats. Atomic: writes beside, flushes, renames. Error:
/// FileUnwritable, FormatUnknown, Cancelled.
[[nodiscard]] Result<void> writeMesh(const std::filesystem::path& path, std::span<const Point> points,
                                     std::span<const Face> faces, const WriteOptions& options,
                                     const Progress& progress);

}  // namespace graftsman
