#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A point on a mesh's surface: a vertex (`vertex` ≥ 0, the rest is unused) or a point of a face.
struct SurfacePoint {
  Index vertex = -1;
  Index face = -1;
  Eigen::Vector3d bary = Eigen::Vector3d::Zero();  // weights of the face's corners: each ≥ 0, sum 1
  /// On a mesh that is computed: where the point was picked. It is found again there when the mesh changes
  /// (see attach.h), so that the numbers above count for one state of the mesh only.
  std::optional<Point> place = {};

  [[nodiscard]] static SurfacePoint atVertex(Index v) { return {v, -1, Eigen::Vector3d::Zero(), {}}; }

  /// Picked at the same place, where both have one; otherwise the same point of one mesh.
  friend bool operator==(const SurfacePoint& a, const SurfacePoint& b) {
    if (a.place && b.place) {
      return *a.place == *b.place && (a.vertex >= 0) == (b.vertex >= 0);
    }
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
