#include "core/io/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/predicates.h"

namespace graftsman {
namespace {

// The second diagonal of a quadrilateral has to be better by this factor. Quadrilaterals of generated
// surfaces are often symmetric but for the last digits that their file kept; all of them are to be divided
// alike.
constexpr double kClearlyBetter = 1.001;

const Point& at(const std::vector<Point>& points, Index v) {
  return points[static_cast<std::size_t>(v)];
}

// The cotangent of a triangle's smallest angle: the smaller, the better. Infinite without area.
double cotangentOfSmallestAngle(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a;
  const Point bc = c - b;
  const Point ca = a - c;
  const double greatest = std::max({-ab.dot(ca), -bc.dot(ab), -ca.dot(bc)});
  const double area = ab.cross(bc).norm();
  return area > 0 ? greatest / area : std::numeric_limits<double>::infinity();
}

// The worse of two triangles; infinite if one has no area or is turned against `normal`.
double worse(const std::vector<Point>& points, const Face& s, const Face& t, const Point& normal) {
  double worst = -std::numeric_limits<double>::infinity();
  for (const Face& face : {s, t}) {
    const Point& a = at(points, face[0]);
    const Point& b = at(points, face[1]);
    const Point& c = at(points, face[2]);
    const bool upright = (b - a).cross(c - a).dot(normal) > 0;
    worst = std::max(worst,
                     upright ? cotangentOfSmallestAngle(a, b, c) : std::numeric_limits<double>::infinity());
  }
  return worst;
}

void triangulateQuad(std::span<const Index> q, const std::vector<Point>& points, std::vector<Face>& faces) {
  const Point normal = newellNormal(q, points);
  const Face s0 = {q[0], q[1], q[2]};
  const Face t0 = {q[0], q[2], q[3]};
  const Face s1 = {q[0], q[1], q[3]};
  const Face t1 = {q[1], q[2], q[3]};
  const double first = worse(points, s0, t0, normal);
  const double second = worse(points, s1, t1, normal);
  // Cotangents of smallest angles are positive (at most 60°).
  const bool takeSecond = kClearlyBetter * second < first;
  faces.push_back(takeSecond ? s1 : s0);
  faces.push_back(takeSecond ? t1 : t0);
}

// A polygon of which ears are cut. Corners are named by their place in it, so a vertex may occur twice.
class CornerCutter {
 public:
  CornerCutter(std::span<const Index> corners, const std::vector<Point>& points,
               const std::vector<Eigen::Vector2d>& plane)
      : corners_(corners),
        points_(points),
        plane_(plane),
        next_(corners.size()),
        prev_(corners.size()),
        badness_(corners.size()) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      prev_[i] = (i + n - 1) % n;
    }
    for (std::size_t i = 0; i < n; ++i) {
      badness_[i] = badnessOf(i);
    }
  }

  void cut(std::vector<Face>& faces) {
    std::size_t start = 0;
    for (std::size_t left = corners_.size(); left > 3; --left) {
      std::size_t best = start;
      for (std::size_t i = next_[start]; i != start; i = next_[i]) {
        best = badness_[i] < badness_[best] || (badness_[i] == badness_[best] && i < best) ? i : best;
      }
      if (badness_[best] == kNoEar) {
        break;
      }
      faces.push_back(triangle(prev_[best], best, next_[best]));
      const std::size_t before = prev_[best];
      const std::size_t after = next_[best];
      next_[before] = after;
      prev_[after] = before;
      badness_[before] = badnessOf(before);
      badness_[after] = badnessOf(after);
      start = before;
    }
    while (prev_[start] < start) {
      start = prev_[start];
    }
    for (std::size_t i = next_[start]; next_[i] != start; i = next_[i]) {
      faces.push_back(triangle(start, i, next_[i]));
    }
  }

 private:
  static constexpr double kNoEar = std::numeric_limits<double>::infinity();

  [[nodiscard]] Face triangle(std::size_t a, std::size_t b, std::size_t c) const {
    return {corners_[a], corners_[b], corners_[c]};
  }

  // How bad a triangle the corner's ear is; kNoEar if it is none: not convex, or another corner in it.
  [[nodiscard]] double badnessOf(std::size_t i) const {
    const std::size_t a = prev_[i];
    const std::size_t c = next_[i];
    if (orient2d(plane_[a], plane_[i], plane_[c]) <= 0) {
      return kNoEar;
    }
    for (std::size_t p = next_[c]; p != a; p = next_[p]) {
      const bool isCornerOfEar =
          corners_[p] == corners_[a] || corners_[p] == corners_[i] || corners_[p] == corners_[c];
      if (!isCornerOfEar && orient2d(plane_[a], plane_[i], plane_[p]) >= 0 &&
          orient2d(plane_[i], plane_[c], plane_[p]) >= 0 && orient2d(plane_[c], plane_[a], plane_[p]) >= 0) {
        return kNoEar;
      }
    }
    return cotangentOfSmallestAngle(at(points_, corners_[a]), at(points_, corners_[i]),
                                    at(points_, corners_[c]));
  }

  std::span<const Index> corners_;
  const std::vector<Point>& points_;
  const std::vector<Eigen::Vector2d>& plane_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> prev_;
  std::vector<double> badness_;
};

// The polygon seen along the axis that its normal is nearest to, counter-clockwise. Coordinates are left out,
// not computed, so that predicates on them are exact.
std::vector<Eigen::Vector2d> projected(std::span<const Index> corners, const std::vector<Point>& points) {
  const Point normal = newellNormal(corners, points);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Eigen::Index u = (axis + 1) % 3;
  Eigen::Index v = (axis + 2) % 3;
  if (normal[axis] < 0) {
    std::swap(u, v);
  }
  std::vector<Eigen::Vector2d> plane;
  plane.reserve(corners.size());
  for (const Index corner : corners) {
    plane.emplace_back(at(points, corner)[u], at(points, corner)[v]);
  }
  return plane;
}

}  // namespace

Point newellNormal(std::span<const Index> corners, const std::vector<Point>& points) {
  // About the first corner, so that a polygon far from the origin loses no digits.
  Point sum = Point::Zero();
  const Point& origin = at(points, corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (at(points, corners[i]) - origin).cross(at(points, corners[i + 1]) - origin);
  }
  return sum;
}

void triangulate(std::span<const Index> corners, const std::vector<Point>& points, std::vector<Face>& faces) {
  if (corners.size() < 3) {
    return;
  }
  if (corners.size() == 3) {
    faces.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  if (corners.size() == 4) {
    triangulateQuad(corners, points, faces);
    return;
  }
  const std::vector<Eigen::Vector2d> plane = projected(corners, points);
  if (corners.size() <= kMostEars) {
    CornerCutter(corners, points, plane).cut(faces);
    return;
  }
  const std::vector<Face> triangles = delaunayTriangles(plane);
  for (const Face& t : triangles) {
    faces.push_back({corners[static_cast<std::size_t>(t[0])], corners[static_cast<std::size_t>(t[1])],
                     corners[static_cast<std::size_t>(t[2])]});
  }
  for (std::size_t i = 1; triangles.empty() && i + 1 < corners.size(); ++i) {
    faces.push_back({corners[0], corners[i], corners[i + 1]});
  }
}

}  // namespace graftsman
