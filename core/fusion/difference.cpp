#include "core/fusion/difference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "core/mesh/nearest_surface.h"

namespace graftsman {
namespace {

constexpr std::size_t kVerticesPerRange = 512;  // vertices: some milliseconds of work
// × an edge's length: a nearest point of a face so near to an edge or a corner lies on it. Above what the
// rounding of the nearest point can be, and so small that the surface is flat there.
constexpr double kOnEdge = 1e-9;

/// The pseudonormals of a mesh: directions, of any length.
class PseudoNormals {
 public:
  explicit PseudoNormals(const TriangleMesh& mesh) : mesh_(mesh) {
    ofFaces_.reserve(static_cast<std::size_t>(mesh.faceCount()));
    ofVertices_.assign(static_cast<std::size_t>(mesh.vertexCount()), Eigen::Vector3d::Zero());
    for (const Face& face : mesh.faces()) {
      const std::array<Point, 3> corners = {mesh.point(face[0]), mesh.point(face[1]), mesh.point(face[2])};
      const Eigen::Vector3d normal =
          (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
      ofFaces_.push_back(normal);
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d u = corners[(k + 1) % 3] - corners[k];
        const Eigen::Vector3d v = corners[(k + 2) % 3] - corners[k];
        const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
        ofVertices_[static_cast<std::size_t>(face[k])] += angle * normal;
      }
    }
  }

  [[nodiscard]] const Eigen::Vector3d& ofFace(Index f) const { return ofFaces_[static_cast<std::size_t>(f)]; }
  [[nodiscard]] const Eigen::Vector3d& ofVertex(Index v) const {
    return ofVertices_[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] Eigen::Vector3d ofEdge(Index halfedge) const {
    const Index twin = mesh_.twin(halfedge);
    const Eigen::Vector3d& own = ofFace(TriangleMesh::faceOf(halfedge));
    return twin < 0 ? own : Eigen::Vector3d(own + ofFace(TriangleMesh::faceOf(twin)));
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<Eigen::Vector3d> ofFaces_;
  std::vector<Eigen::Vector3d> ofVertices_;
};

/// The nearest point on one edge of a face, from 0 at its first corner to 1.
struct OnEdge {
  double squaredDistance = std::numeric_limits<double>::infinity();
  int edge = 0;
  double t = 0;
};

// The way from the nearest point of the face to p, times the pseudonormal there: its sign is p's side.
double sideOf(const TriangleMesh& mesh, const PseudoNormals& normals, Index face, const Point& p) {
  std::array<Point, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = mesh.point(mesh.face(face)[k]);
  }
  const Eigen::Vector3d& normal = normals.ofFace(face);
  bool inside = normal.squaredNorm() > 0;
  OnEdge nearest;
  for (int k = 0; k < 3; ++k) {
    const Point& a = corners[static_cast<std::size_t>(k)];
    const Eigen::Vector3d ab = corners[static_cast<std::size_t>((k + 1) % 3)] - a;
    const double squared = ab.squaredNorm();
    // How far within the edge p lies, seen along the normal: in units of squared lengths.
    inside = inside && ab.cross(p - a).dot(normal) > kOnEdge * squared;
    const double t = squared > 0 ? std::clamp(ab.dot(p - a) / squared, 0.0, 1.0) : 0;
    const double distance = (p - a - t * ab).squaredNorm();
    if (distance < nearest.squaredDistance) {
      nearest = {distance, k, t};
    }
  }
  if (inside) {
    return (p - corners[0]).dot(normal);
  }
  const Index halfedge = 3 * face + nearest.edge;
  const Point& a = mesh.point(mesh.from(halfedge));
  const Point& b = mesh.point(mesh.to(halfedge));
  if (nearest.t <= kOnEdge) {
    return (p - a).dot(normals.ofVertex(mesh.from(halfedge)));
  }
  if (nearest.t >= 1 - kOnEdge) {
    return (p - b).dot(normals.ofVertex(mesh.to(halfedge)));
  }
  return (p - a - nearest.t * (b - a)).dot(normals.ofEdge(halfedge));
}

// A third of the area of the faces round each vertex; negative where no face uses it.
std::vector<double> areasRoundVertices(const TriangleMesh& mesh) {
  std::vector<double> areas(static_cast<std::size_t>(mesh.vertexCount()), -1);
  for (const Face& face : mesh.faces()) {
    const Point& a = mesh.point(face[0]);
    const double third = (mesh.point(face[1]) - a).cross(mesh.point(face[2]) - a).norm() / 6;
    for (const Index v : face) {
      double& area = areas[static_cast<std::size_t>(v)];
      area = std::max(area, 0.0) + third;
    }
  }
  return areas;
}

constexpr double kUsualShare = 0.95;
constexpr double kDiffers = 1e-6;  // × the greatest distance: less is rounding, or cannot be seen beside it

double usualDistance(const std::vector<double>& areas, const SurfaceDifference& difference) {
  const double farthest = std::max({0.0, difference.greatest, -difference.least});
  std::vector<std::pair<double, double>> differing;  // distance, area
  double area = 0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    const double distance = std::abs(difference.distances[v]);
    if (areas[v] > 0 && distance > kDiffers * farthest) {
      differing.emplace_back(distance, areas[v]);
      area += areas[v];
    }
  }
  std::sort(differing.begin(), differing.end());
  double below = 0;
  for (const auto& [distance, ofVertex] : differing) {
    below += ofVertex;
    if (below >= kUsualShare * area) {
      return distance;
    }
  }
  return farthest;
}

// In one order, whatever the threads were.
void summarise(const TriangleMesh& surface, SurfaceDifference& difference) {
  const std::vector<double> areas = areasRoundVertices(surface);
  bool first = true;
  double area = 0;
  double sum = 0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (areas[v] < 0) {
      continue;
    }
    const double distance = difference.distances[v];
    difference.greatest = first ? distance : std::max(difference.greatest, distance);
    difference.least = first ? distance : std::min(difference.least, distance);
    first = false;
    area += areas[v];
    sum += areas[v] * std::abs(distance);
  }
  difference.meanAbsolute = area > 0 ? sum / area : 0;
  difference.usual = usualDistance(areas, difference);
}

}  // namespace

Result<SurfaceDifference> differenceOf(const TriangleMesh& surface, std::shared_ptr<const TriangleMesh> from,
                                       const Progress& progress) {
  if (!progress.keepGoing(0)) {
    return fail(ErrorCode::Cancelled, "Cancelled.");
  }
  const NearestSurface nearest(std::move(from));
  const PseudoNormals normals(*nearest.mesh());
  SurfaceDifference difference;
  difference.distances.resize(surface.points().size());
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> stopped = false;
  parallelRanges(difference.distances.size(), kVerticesPerRange, [&](std::size_t begin, std::size_t end) {
    if (stopped) {
      return;
    }
    for (std::size_t v = begin; v < end; ++v) {
      const Point& p = surface.points()[v];
      const NearestSurface::Nearest found = nearest.nearest(p);
      const bool behind = found.distance > 0 && sideOf(*nearest.mesh(), normals, found.face, p) < 0;
      difference.distances[v] = behind ? -found.distance : found.distance;
    }
    const std::size_t soFar = done += end - begin;
    if (!progress.keepGoing(static_cast<double>(soFar) / static_cast<double>(surface.points().size()))) {
      stopped = true;
    }
  });
  if (stopped || progress.cancelled()) {
    return fail(ErrorCode::Cancelled, "Cancelled.");
  }
  summarise(surface, difference);
  return difference;
}

}  // namespace graftsman
