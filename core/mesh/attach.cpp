#include "core/mesh/attach.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace graftsman {
namespace {

Index nearestVertex(const TriangleMesh& mesh, const Point& place) {
  Index nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double distance = (mesh.point(v) - place).squaredNorm();
    if (distance < least && mesh.outgoing(v) >= 0) {
      least = distance;
      nearest = v;
    }
  }
  return nearest;
}

// Weights of the point of segment ab nearest to p: (1 − t, t).
double along(const Point& a, const Point& b, const Point& p) {
  const double length2 = (b - a).squaredNorm();
  return length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
}

// Barycentric coordinates of the triangle's point nearest to p: within, by Gram's matrix; else on an edge.
Eigen::Vector3d nearestIn(const std::array<Point, 3>& corners, const Point& p) {
  const Eigen::Vector3d u = corners[1] - corners[0];
  const Eigen::Vector3d v = corners[2] - corners[0];
  const Eigen::Vector3d w = p - corners[0];
  const double area2 = u.cross(v).squaredNorm();
  if (area2 > 0) {
    const double b = (w.dot(u) * v.squaredNorm() - w.dot(v) * u.dot(v)) / area2;
    const double c = (w.dot(v) * u.squaredNorm() - w.dot(u) * u.dot(v)) / area2;
    if (b >= 0 && c >= 0 && b + c <= 1) {
      return {1 - b - c, b, c};
    }
  }
  Eigen::Vector3d nearest = Eigen::Vector3d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double t = along(corners[k], corners[next], p);
    const double distance = (corners[k] + t * (corners[next] - corners[k]) - p).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest.setZero();
      nearest[static_cast<Eigen::Index>(k)] = 1 - t;
      nearest[static_cast<Eigen::Index>(next)] = t;
    }
  }
  return nearest;
}

}  // namespace

SurfacePoint attach(const TriangleMesh& mesh, const SurfacePoint& point) {
  const Point& place = *point.place;
  if (point.vertex >= 0) {
    SurfacePoint vertex = SurfacePoint::atVertex(nearestVertex(mesh, place));
    vertex.place = place;
    return vertex;
  }
  SurfacePoint nearest;
  nearest.place = place;
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Face& face = mesh.face(f);
    const std::array<Point, 3> corners = {mesh.point(face[0]), mesh.point(face[1]), mesh.point(face[2])};
    const Eigen::Vector3d bary = nearestIn(corners, place);
    const double distance =
        (bary[0] * corners[0] + bary[1] * corners[1] + bary[2] * corners[2] - place).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest.face = f;
      nearest.bary = bary;
    }
  }
  return nearest;
}

}  // namespace graftsman
