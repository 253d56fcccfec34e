#pragma once

#include <Eigen/Core>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A point on a mesh's surface: a vertex (`vertex` ≥ 0, the rest is unused) or a point of a face.
struct SurfacePoint {
  Index vertex = -1;
  Index face = -1;
  Eigen::Vector3d bary = Eigen::Vector3d::Zero();  // weights of the face's corners: each ≥ 0, sum 1

  [[nodiscard]] static SurfacePoint atVertex(Index v) { return {v, -1, Eigen::Vector3d::Zero()}; }

  friend bool operator==(const SurfacePoint& a, const SurfacePoint& b) {
    return a.vertex == b.vertex && (a.vertex >= 0 || (a.face == b.face && a.bary == b.bary));
  }
};

/// A point of a polyline on a mesh: a vertex (`vertex` ≥ 0) or a point in the interior of an edge.
struct EdgePoint {
  Index vertex = -1;
  Index halfedge = -1;  // the smaller of the edge's two halfedges; unused at a vertex
  double t = 0;         // in (0, 1), from the halfedge's start to its end; unused at a vertex

  [[nodiscard]] bool isVertex() const { return vertex >= 0; }
  friend bool operator==(const EdgePoint&, const EdgePoint&) = default;
};

/// The position of an EdgePoint: exactly the vertex's, or start + t (end − start).
[[nodiscard]] inline Point position(const TriangleMesh& mesh, const EdgePoint& p) {
  if (p.isVertex()) {
    return mesh.point(p.vertex);
  }
  const Point& a = mesh.point(mesh.from(p.halfedge));
  return a + p.t * (mesh.point(mesh.to(p.halfedge)) - a);
}

}  // namespace graftsman
