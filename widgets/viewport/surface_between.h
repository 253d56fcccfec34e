#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "widgets/viewport/morph_normals.h"
#include "widgets/viewport/shading.h"

namespace graftsman {

/// How what lies between two surfaces of the same faces is drawn: a vertex of the mesh becomes as many drawn
/// ones as the creases of both divide its faces into.
struct BetweenLayout {
  std::vector<Face> faces;          // F×3: the drawn vertices of each face's corners
  std::vector<Index> meshVertices;  // of each drawn vertex; the first V are the mesh's own, in order
  std::vector<Index> firstExtra;    // V + 1; mesh vertex v is drawn as v, and V + firstExtra[v] to before
                                    // V + firstExtra[v + 1]
  std::vector<std::array<Index, 2>> shaded;  // of each drawn vertex: that of the first surface, of the second
  VertexFans fans;                           // of the drawn vertices
};

/// Precondition: `a` and `b` are shadings of meshes that have the faces of `mesh`, and as many vertices.
/// Cost: linear, on one thread.
[[nodiscard]] BetweenLayout layOutBetween(const TriangleMesh& mesh, const Shading& a, const Shading& b);

/// Writes the places (1 − t) a + t b of the drawn vertices and their normals, length 1; 0 where no face has
/// an area. A crease of one surface alone fades: a normal is mixed of that with the first's creases and that
/// with the second's, so that at t = 0 and 1 it is that surface's own. `points`, `normals`: 3 numbers for
/// each drawn vertex; `areas`: F, of no meaning before or after. Cost: linear, on threadCount() threads.
void writeBetween(const BetweenLayout& layout, const TriangleMesh& a, const TriangleMesh& b, double t,
                  std::span<double> points, std::span<float> normals, std::span<Eigen::Vector3f> areas);

}  // namespace graftsman
