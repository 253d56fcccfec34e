#include "core/fusion/path_position.h"

#include <algorithm>
#include <limits>

namespace graftsman {
namespace {

// The nearer end of the edge that an edge point lies on.
Index nearerVertex(const TriangleMesh& mesh, const EdgePoint& p) {
  return p.isVertex() ? p.vertex : p.t < 0.5 ? mesh.from(p.halfedge) : mesh.to(p.halfedge);
}

// The point of the segment from one edge point to the next that is the fraction t along it. Both lie on one
// face.
SurfacePoint within(const TriangleMesh& mesh, const EdgePoint& a, const EdgePoint& b, double t) {
  const auto facesAt = [&](const EdgePoint& p) {
    std::vector<Index> faces;
    if (!p.isVertex()) {
      faces.push_back(TriangleMesh::faceOf(p.halfedge));
      if (mesh.twin(p.halfedge) >= 0) {
        faces.push_back(TriangleMesh::faceOf(mesh.twin(p.halfedge)));
      }
      return faces;
    }
    const Index first = mesh.outgoing(p.vertex);
    Index h = first;
    do {
      faces.push_back(TriangleMesh::faceOf(h));
      h = mesh.twin(TriangleMesh::prev(h));
    } while (h >= 0 && h != first);
    return faces;
  };
  const auto weightsIn = [&](Index face, const EdgePoint& p) -> Eigen::Vector3d {
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    const Face& corners = mesh.face(face);
    for (int k = 0; k < 3; ++k) {
      const Index corner = corners[static_cast<std::size_t>(k)];
      if (p.isVertex()) {
        weights[k] = corner == p.vertex ? 1 : 0;
      } else if (corner == mesh.from(p.halfedge)) {
        weights[k] = 1 - p.t;
      } else if (corner == mesh.to(p.halfedge)) {
        weights[k] = p.t;
      }
    }
    return weights;
  };
  const std::vector<Index> ofB = facesAt(b);
  for (const Index face : facesAt(a)) {
    if (std::find(ofB.begin(), ofB.end(), face) != ofB.end()) {
      const Eigen::Vector3d weights = (1 - t) * weightsIn(face, a) + t * weightsIn(face, b);
      return {-1, face, weights / weights.sum()};
    }
  }
  return SurfacePoint::atVertex(nearerVertex(mesh, a));
}

}  // namespace

Point positionOf(const TriangleMesh& mesh, const SurfacePoint& point) {
  if (point.vertex >= 0) {
    return mesh.point(point.vertex);
  }
  const Face& face = mesh.face(point.face);
  return point.bary[0] * mesh.point(face[0]) + point.bary[1] * mesh.point(face[1]) +
         point.bary[2] * mesh.point(face[2]);
}

double fractionNearest(const Path& path, const TriangleMesh& mesh, const Point& point) {
  double nearest = std::numeric_limits<double>::infinity();
  double along = 0;
  double best = 0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Point a = position(mesh, path.points[i]);
    const Point edge = position(mesh, path.points[i + 1]) - a;
    const double length = edge.norm();
    const double t = length > 0 ? std::clamp((point - a).dot(edge) / (length * length), 0.0, 1.0) : 0;
    const double distance = (a + t * edge - point).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      best = along + t * length;
    }
    along += length;
  }
  return along > 0 ? std::clamp(best / along, 0.0, 1.0) : 0.5;
}

std::optional<SurfacePoint> pointAlong(const Path& path, const AnchoredLoop& anchored, Index vertices,
                                       double fraction) {
  const TriangleMesh& mesh = *anchored.mesh;
  // The ends belong to other pairs.
  double left = std::clamp(fraction, 0.05, 0.95) * path.length;
  std::size_t i = 0;
  double length = 0;
  for (; i + 1 < path.points.size(); ++i) {
    length = (position(mesh, path.points[i + 1]) - position(mesh, path.points[i])).norm();
    if (left <= length || i + 2 == path.points.size()) {
      break;
    }
    left -= length;
  }
  const double t = length > 0 ? std::clamp(left / length, 0.05, 0.95) : 0.5;
  const EdgePoint& a = path.points[i];
  const EdgePoint& b = path.points[i + 1];
  const Index vertex = nearerVertex(mesh, t < 0.5 ? a : b);
  const auto& cvs = anchored.cvs;
  if (vertex < vertices && std::find(cvs.begin(), cvs.end(), vertex) == cvs.end()) {
    return SurfacePoint::atVertex(vertex);
  }
  const SurfacePoint point = within(mesh, a, b, t);
  const bool original =
      point.vertex < 0 &&
      std::all_of(mesh.face(point.face).begin(), mesh.face(point.face).end(),
                  [&](Index corner) { return corner < vertices; }) &&
      (anchored.parents.empty() || anchored.parents[static_cast<std::size_t>(point.face)] == point.face);
  return original ? std::optional(point) : std::nullopt;
}

}  // namespace graftsman
