#pragma once

#include <string>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// What a mesh is like, exactly.
struct MeshCheck {
  Index vertices = 0;
  Index faces = 0;
  Index edges = 0;        // distinct pairs of vertices that are neighbours
  Index components = 0;   // connected by shared vertices of faces
  Index borderLoops = 0;  // closed chains of border edges; see checkMesh()
  Index borderEdges = 0;
  long eulerCharacteristic = 0;  // used vertices − edges + faces
  bool manifold = false;         // no singular vertex
  bool oriented = false;         // no two faces run through an edge in the same direction
  bool orientable = false;       // could be oriented by turning faces over; never with an edge of three faces
  bool closed = false;           // no border edge
  std::vector<std::array<Index, 2>> edgesOfManyFaces;  // edges with three or more faces (the first 100)
  std::size_t edgesOfManyFacesCount = 0;
  std::vector<std::array<Index, 2>> misorientedEdges;  // edges whose two faces disagree (the first 100)
  std::size_t misorientedEdgesCount = 0;
  /// Vertices whose faces do not make one fan, closed or open, whichever way each face runs; those of edges
  /// with three or more faces among them, isolated ones not (the first 100).
  std::vector<Index> singularVertices;
  std::size_t singularVerticesCount = 0;
  std::size_t isolatedVertices = 0;
  std::size_t degenerateFaces = 0;  // of zero area, exactly
  double smallestAngle = 0;         // degrees
  double medianSmallestAngle = 0;   // degrees; of the faces' smallest angles
  double area = 0;                  // model unit squared
  double volume = 0;                // model unit cubed, signed; meaningful if closed
  Point boxMin = Point::Zero();     // of the vertices that faces use
  Point boxMax = Point::Zero();
};

/// Examines a mesh. Linear cost, apart from a sort of what is irregular.
///
/// Border loops are counted as if the mesh were cut apart at every singular vertex, so that each fan has a
/// vertex of its own, and along every edge of three or more faces; a loop counts if it has a border edge. So
/// two triangles that touch in one vertex have two loops, and so have two discs that touch along their
/// borders.
[[nodiscard]] MeshCheck checkMesh(const TriangleMesh& mesh);

/// The check as lines of text for a person.
[[nodiscard]] std::string describe(const MeshCheck& check);

}  // namespace graftsman
