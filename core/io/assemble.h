#pragma once

#include "core/io/mesh_file.h"
#include "core/io/raw_mesh.h"

namespace graftsman {

/// The points and triangles of a file, before it is known who is beside whom.
struct TriangleSoup {
  std::vector<Point> points;
  std::vector<Face> faces;
  std::vector<Index> vertexOfFileVertex;  // as MeshFile has it
  ReadReport report;                      // but for duplicate faces and isolated vertices
};

/// Welds the vertices if no face shares any, divides the polygons, drops triangles with a repeated vertex.
[[nodiscard]] TriangleSoup triangulated(RawMesh raw);

/// Builds the mesh; drops triangles that repeat an earlier one. `name` is the file's, for the message.
/// Errors: MeshEmpty; FileMalformed if there are more triangles than an Index can count halfedges of.
[[nodiscard]] Result<MeshFile> assembled(TriangleSoup soup, const std::string& name);

}  // namespace graftsman
