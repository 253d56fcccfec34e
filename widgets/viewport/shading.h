#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// What smooth shading with sharp creases needs: a vertex of the mesh becomes as many shaded vertices as
/// creases divide its faces into.
struct Shading {
  std::vector<Face> faces;               // F×3: the shaded vertices of each face's corners
  std::vector<Index> meshVertices;       // of each shaded vertex; the first V are the mesh's own, in order
  std::vector<Eigen::Vector3f> normals;  // of each shaded vertex: length 1; 0 where no face has an area
};

/// Edges that turn further than this are shown as creases, in radians: coarse models of round things stay
/// round, and boxes boxes.
inline constexpr double kCreaseAngle = 0.8;

/// Area-weighted normals, smooth but for the creases. Cost: linear, on one thread.
[[nodiscard]] Shading shade(const TriangleMesh& mesh, double creaseAngle = kCreaseAngle);

}  // namespace graftsman
