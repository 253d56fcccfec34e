#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/io/mesh_file.h"
#include "core/io/mesh_writer.h"
#include "core/mesh/mesh_check.h"

/// What must hold for whatever bytes a reader gets. Stops the program where it does not.
namespace graftsman::fuzz {

inline void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "violated: %s\n", what);
    std::abort();
  }
}

inline bool sameBits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0);
}

/// An error says one line, without a control character.
inline void requireGoodError(const Error& error) {
  require(error.code == ErrorCode::FileMalformed || error.code == ErrorCode::MeshEmpty, "the error's code");
  require(error.message.starts_with("fuzzed"), "the message names the file");
  for (const char c : error.message) {
    require(c >= ' ' && c <= '~', "the message is printable");
  }
}

inline void requireValidMesh(const MeshFile& file) {
  const TriangleMesh& mesh = *file.mesh;
  require(mesh.faceCount() > 0, "a mesh has a face");
  for (const Point& p : mesh.points()) {
    require(p.allFinite(), "coordinates are finite");
  }
  for (const Face& f : mesh.faces()) {
    for (const Index v : f) {
      require(v >= 0 && v < mesh.vertexCount(), "corners are in range");
    }
    require(f[0] != f[1] && f[1] != f[2] && f[2] != f[0], "no face repeats a vertex");
  }
  const ReadReport& r = file.report;
  require(static_cast<std::size_t>(mesh.vertexCount()) == r.fileVertices - r.welded, "no vertex is lost");
  require(file.vertexOfFileVertex.empty() || file.vertexOfFileVertex.size() == r.fileVertices,
          "every vertex of the file has one of the mesh");
  for (const Index v : file.vertexOfFileVertex) {
    require(v >= 0 && v < mesh.vertexCount(), "vertices of the file are in range");
  }
}

/// What was read is written and reads back as the same, bit for bit.
inline void requireRoundTrip(const TriangleMesh& mesh, MeshFormat format, bool binary) {
  const auto text = formatMesh(format, "written", mesh.points(), mesh.faces(), {binary}, {});
  require(text.has_value(), "a mesh can be written");
  const auto back = parseMesh(*text, format, "written", {});
  // Once faces were dropped, the rest may share no vertex any more and be welded, even away.
  if (!back) {
    require(back.error().code == ErrorCode::MeshEmpty, "what was written can be read");
    return;
  }
  if (back->report.welded > 0) {
    return;
  }
  require(sameBits(back->mesh->points(), mesh.points()), "points survive");
  require(back->mesh->faces() == mesh.faces(), "faces survive");
}

inline int run(const std::uint8_t* data, std::size_t size, MeshFormat format) {
  const auto file = parseMesh({reinterpret_cast<const char*>(data), size}, format, "fuzzed", {});
  if (!file) {
    requireGoodError(file.error());
    return 0;
  }
  requireValidMesh(*file);
  for (const MeshFormat other : {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
    requireRoundTrip(*file->mesh, other, true);
  }
  requireRoundTrip(*file->mesh, MeshFormat::Ply, false);
  const MeshCheck check = checkMesh(*file->mesh);
  require(check.closed == (check.borderLoops == 0), "a mesh with a border has a border loop");
  require(check.components > 0 && check.isolatedVertices == file->report.isolated,
          "the check counts vertices");
  require(check.orientable || !check.oriented, "an oriented mesh can be oriented");
  require(!describe(check).empty(), "the check has a text");
  return 0;
}

}  // namespace graftsman::fuzz
