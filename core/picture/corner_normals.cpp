#include "core/picture/corner_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace graftsman::picture_detail {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

using Vector = Eigen::Vector3f;

// Comparing every two faces at a vertex costs the square of their number: at a vertex with more, each is
// flat.
constexpr std::ptrdiff_t kMostCompared = 256;

// Normals as long as the faces' areas, in units that floats hold.
std::vector<Vector> faceNormals(std::span<const Point> points, std::span<const Face> faces) {
  Point low = points[0];
  Point high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).maxCoeff();
  // The fourth power of the greatest, and of the least that matters, is a float.
  const double unit = size > 0 ? 1e4 / size : 1;
  std::vector<Vector> normals(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Point& a = points[at(faces[f][0])];
    const Vector u = ((points[at(faces[f][1])] - a) * unit).cast<float>();
    const Vector v = ((points[at(faces[f][2])] - a) * unit).cast<float>();
    normals[f] = u.cross(v);
  }
  return normals;
}

// The corners at some vertices, grouped by vertex.
struct CornersAt {
  std::vector<Index> start;    // V + 1
  std::vector<Index> corners;  // 3 · face + corner
};

CornersAt cornersAt(std::span<const Face> faces, const std::vector<char>& wanted) {
  CornersAt result;
  result.start.assign(wanted.size() + 1, 0);
  for (const Face& face : faces) {
    for (const Index v : face) {
      result.start[at(v) + 1] += wanted[at(v)];
    }
  }
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    result.start[v + 1] += result.start[v];
  }
  result.corners.resize(at(result.start.back()));
  std::vector<Index> next(result.start.begin(), result.start.end() - 1);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = at(faces[f][k]);
      if (wanted[v] != 0) {
        result.corners[at(next[v]++)] = static_cast<Index>(3 * f + k);
      }
    }
  }
  return result;
}

// Gives the corners at creased vertices normals of their own.
void divideAtCreases(const CornersAt& creased, const std::vector<Vector>& ofFaces, float cosine,
                     CornerNormals& result) {
  for (std::size_t v = 0; v + 1 < creased.start.size(); ++v) {
    const auto begin = creased.corners.begin() + creased.start[v];
    const auto end = creased.corners.begin() + creased.start[v + 1];
    for (auto corner = begin; corner != end; ++corner) {
      const Vector& own = ofFaces[at(*corner / 3)];
      Vector sum = own;
      for (auto other = end - begin <= kMostCompared ? begin : end; other != end; ++other) {
        const Vector& theirs = ofFaces[at(*other / 3)];
        if (other != corner &&
            own.dot(theirs) > cosine * std::sqrt(own.squaredNorm() * theirs.squaredNorm())) {
          sum += theirs;
        }
      }
      result.corners[at(*corner / 3)][at(*corner % 3)] = static_cast<Index>(result.normals.size());
      result.normals.push_back(sum);
    }
  }
}

}  // namespace

CornerNormals cornerNormals(std::span<const Point> points, std::span<const Face> faces, double creaseAngle) {
  CornerNormals result;
  result.corners.assign(faces.begin(), faces.end());
  result.normals.assign(points.size(), Vector::Zero());
  if (points.empty()) {
    return result;
  }
  const std::vector<Vector> ofFaces = faceNormals(points, faces);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const Index v : faces[f]) {
      result.normals[at(v)] += ofFaces[f];
    }
  }
  std::vector<char> creased(points.size(), 0);
  bool any = false;
  const auto half = static_cast<float>(std::cos(creaseAngle / 2));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const float squared = ofFaces[f].squaredNorm();
    for (const Index v : faces[f]) {
      const Vector& mean = result.normals[at(v)];
      if (ofFaces[f].dot(mean) < half * std::sqrt(squared * mean.squaredNorm())) {
        creased[at(v)] = 1;
        any = true;
      }
    }
  }
  if (any) {
    divideAtCreases(cornersAt(faces, creased), ofFaces, static_cast<float>(std::cos(creaseAngle)), result);
  }
  for (Vector& normal : result.normals) {
    normal.normalize();  // leaves 0 as it is
  }
  return result;
}

}  // namespace graftsman::picture_detail
