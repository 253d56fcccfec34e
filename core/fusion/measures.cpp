#include "core/fusion/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/fusion/seam_angles.h"

namespace graftsman {
namespace {

constexpr std::size_t kGrain = 512;          // vertices of one thread's turn
constexpr std::size_t kBlock = 64 * kGrain;  // vertices from one look at the progress to the next

bool isClosed(const TriangleMesh& mesh) {
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.twin(h) < 0) {
      return false;
    }
  }
  return true;
}

// A triangle's corners.
struct Corners {
  const Point& a;
  const Point& b;
  const Point& c;

  Corners(const std::vector<Point>& points, const Face& face)
      : a(points[static_cast<std::size_t>(face[0])]),
        b(points[static_cast<std::size_t>(face[1])]),
        c(points[static_cast<std::size_t>(face[2])]) {}

  // Twice the area long.
  [[nodiscard]] Eigen::Vector3d normal() const { return (b - a).cross(c - a); }
};

double quality(const Corners& t) {
  const double sides = (t.b - t.a).squaredNorm() + (t.c - t.b).squaredNorm() + (t.a - t.c).squaredNorm();
  return sides > 0 ? 2 * std::numbers::sqrt3 * t.normal().norm() / sides : 0;
}

void measureSize(const FusedMesh& fused, bool closed, Measures& measures) {
  const Point origin = fused.points.empty() ? Point(Point::Zero()) : fused.points[0];
  double volume = 0;
  for (const Face& face : fused.faces()) {
    const Corners corners(fused.points, face);
    const Eigen::Vector3d normal = corners.normal();
    measures.area += normal.norm() / 2;
    volume += normal.dot(corners.a - origin) / 6;
  }
  if (closed) {
    measures.volume = volume;
  }
}

// The areas of the combined tile's faces that belong to each of its vertices, a third of each corner's.
std::vector<double> shares(const FusionResults& results) {
  std::vector<double> result(results.combined->base.size(), 0);
  const Join& join = *results.join;
  const auto first = static_cast<std::size_t>(join.restFaces);
  for (std::size_t f = 0; f < results.combined->faces.size(); ++f) {
    const double area = Corners(results.fused->points, join.faces[first + f]).normal().norm() / 2;
    for (const Index v : results.combined->faces[f]) {
      result[static_cast<std::size_t>(v)] += area / 3;
    }
  }
  return result;
}

// False: it was stopped.
bool measureDistance(const FusionResults& results, const NearestSurface& base, const Progress& progress,
                     Measures& measures) {
  const CombinedTile& combined = *results.combined;
  std::vector<double> distances(combined.base.size());
  const auto find = [&](std::size_t i) {
    const auto v = static_cast<std::size_t>(results.join->tileVertices[i]);
    const Point& p = results.fused->points[v];
    // The vertex's place on the base is a point of its surface.
    distances[i] = base.distance(p, (p - combined.base[i]).norm());
  };
  for (std::size_t from = 0; from < distances.size(); from += kBlock) {
    if (!progress.keepGoing(static_cast<double>(from) / static_cast<double>(distances.size()))) {
      return false;
    }
    const std::size_t size = std::min(kBlock, distances.size() - from);
    parallelRanges(size, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = from + begin; i < from + end; ++i) {
        find(i);
      }
    });
  }
  const std::vector<double> weights = shares(results);
  double sum = 0;
  double weight = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    measures.greatestDistance = std::max(measures.greatestDistance, distances[i]);
    sum += weights[i] * distances[i];
    weight += weights[i];
  }
  measures.meanDistance = weight > 0 ? sum / weight : 0;
  return true;
}

void measureQuality(const FusionResults& results, Measures& measures) {
  const std::vector<Face>& faces = results.join->faces;
  std::vector<double> qualities;
  qualities.reserve(results.combined->faces.size());
  double sum = 0;
  for (auto f = static_cast<std::size_t>(results.join->restFaces); f < faces.size(); ++f) {
    qualities.push_back(quality(Corners(results.fused->points, faces[f])));
    sum += qualities.back();
  }
  measures.meanQuality = sum / static_cast<double>(qualities.size());
  measures.worstQuality = *std::min_element(qualities.begin(), qualities.end());
  const auto low = qualities.begin() + static_cast<std::ptrdiff_t>(qualities.size() / 20);
  std::nth_element(qualities.begin(), low, qualities.end());
  measures.lowQuality = *low;
}

}  // namespace

Result<Measures> measure(const FusionResults& results, const NearestSurface& base, const Progress& progress) {
  assert(results.fused && base.mesh() == results.inputs.base);
  const SeamAngles angles = seamAngles(results.fused->points, *results.join, results.combined->seamSize);
  Measures measures;
  measures.meanSeamAngle = angles.mean;
  measures.greatestSeamAngle = angles.greatest;
  // As closed as the base: DESIGN.md §4, 3.
  measureSize(*results.fused, isClosed(*results.inputs.base), measures);
  if (!measureDistance(results, base, progress, measures)) {
    return fail(ErrorCode::Cancelled, "Measuring was cancelled.");
  }
  measureQuality(results, measures);
  measures.vertices = static_cast<Index>(results.fused->points.size());
  measures.faces = static_cast<Index>(results.fused->faces().size());
  return measures;
}

Measures measure(const FusionResults& results) {
  return measure(results, NearestSurface(results.inputs.base), {}).value();
}

}  // namespace graftsman
