#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/fusion/paths.h"

namespace graftsman {

/// A mesh divided along its loop. Vertices are numbered as in the mesh; vertex V + i is points[i].
/// Faces that no path crosses are not repeated here.
struct Cut {
  std::vector<Point> points;     // C×3; the new vertices, one for each path point inside an edge
  std::vector<EdgePoint> where;  // C; where on the mesh points[i] lies
  std::vector<Face> faces;       // the pieces of the divided faces, oriented as their parent
  std::vector<Index> parents;    // of each piece, the mesh's face; ascending
  std::vector<Index>
      boundary;  // B ≥ 3; the loop's vertices in order from CV 0; boundary edge i: i → (i + 1) mod B
  std::vector<Index> corners;  // n; boundary[corners[i]] is CV i; corners[0] = 0
};

/// Divides the faces that the paths cross (Kanai et al. 1999, §2.1). Combinatorial: decided by which vertex,
/// edge and side of a face a point lies on, and by the order of t along one edge; never by positions (those
/// choose only between valid triangulations). No piece has three vertices on one edge of its parent. Each
/// boundary edge is an edge of a piece or of an undivided face, on its left, its right, or both.
/// Precondition: `paths` is a simple closed curve.
[[nodiscard]] Cut cutMesh(const TriangleMesh& mesh, const LoopPaths& paths);

}  // namespace graftsman
