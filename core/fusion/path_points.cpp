#include "core/fusion/path_points.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/fusion/path_obstacles.h"

namespace graftsman {
namespace {

bool hasCorner(const TriangleMesh& mesh, Index face, Index v) {
  const Face& corners = mesh.face(face);
  return corners[0] == v || corners[1] == v || corners[2] == v;
}

SharedPlace placeOfVertices(const TriangleMesh& mesh, Index a, Index b) {
  Index h = mesh.halfedgeBetween(a, b);
  if (h < 0) {
    h = mesh.halfedgeBetween(b, a);
  }
  return {h < 0 ? -1 : canonical(mesh, h), -1};
}

// p lies inside an edge.
SharedPlace placeOf(const TriangleMesh& mesh, const EdgePoint& p, const EdgePoint& other) {
  const Index h = p.halfedge;
  if (other.isVertex() ? mesh.from(h) == other.vertex || mesh.to(h) == other.vertex : other.halfedge == h) {
    return {h, -1};
  }
  for (const Index side : {h, mesh.twin(h)}) {
    if (side < 0) {
      continue;
    }
    const Index face = TriangleMesh::faceOf(side);
    if (other.isVertex()) {
      if (hasCorner(mesh, face, other.vertex)) {
        return {-1, face};
      }
      continue;
    }
    const Index otherTwin = mesh.twin(other.halfedge);
    if (TriangleMesh::faceOf(other.halfedge) == face ||
        (otherTwin >= 0 && TriangleMesh::faceOf(otherTwin) == face)) {
      return {-1, face};
    }
  }
  return {};
}

// p strictly inside the arc that leads counter-clockwise from a to b.
bool inArc(const PerimeterPosition& a, const PerimeterPosition& p, const PerimeterPosition& b) {
  return a < b ? a < p && p < b : a < p || p < b;
}

// The first point that occurs twice, as (first, last) occurrence; (0, 0) if none does.
std::pair<std::size_t, std::size_t> repeatedPoint(std::span<const EdgePoint> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::size_t i) {
    const EdgePoint& p = points[i];
    return p.isVertex() ? std::tuple(p.vertex, Index{-1}, 0.0, i) : std::tuple(Index{-1}, p.halfedge, p.t, i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (points[order[k]] == points[order[k - 1]]) {
      return {order[k - 1], order[k]};
    }
  }
  return {0, 0};
}

// Two segments i < j that cross inside a face, as (i, j + 1); (0, 0) if none do.
std::pair<std::size_t, std::size_t> crossedSegments(const TriangleMesh& mesh,
                                                    std::span<const EdgePoint> points) {
  std::vector<std::pair<Index, std::size_t>> inFace;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Index face = sharedPlace(mesh, points[i], points[i + 1]).face;
    if (face >= 0) {
      inFace.emplace_back(face, i);
    }
  }
  std::sort(inFace.begin(), inFace.end());
  for (std::size_t k = 0; k < inFace.size(); ++k) {
    const auto [face, i] = inFace[k];
    const auto at = [&, f = face](std::size_t p) { return perimeterPosition(mesh, f, points[p]); };
    for (std::size_t l = k + 1; l < inFace.size() && inFace[l].first == face; ++l) {
      const std::size_t j = inFace[l].second;
      if (chordsCross(at(i), at(i + 1), at(j), at(j + 1))) {
        return {i, j + 1};
      }
    }
  }
  return {0, 0};
}

}  // namespace

SharedPlace sharedPlace(const TriangleMesh& mesh, const EdgePoint& a, const EdgePoint& b) {
  if (a.isVertex() && b.isVertex()) {
    return placeOfVertices(mesh, a.vertex, b.vertex);
  }
  return a.isVertex() ? placeOf(mesh, b, a) : placeOf(mesh, a, b);
}

PerimeterPosition perimeterPosition(const TriangleMesh& mesh, Index face, const EdgePoint& p) {
  if (p.isVertex()) {
    const Face& corners = mesh.face(face);
    return {corners[0] == p.vertex ? 0 : corners[1] == p.vertex ? 1 : 2, -2};
  }
  if (TriangleMesh::faceOf(p.halfedge) == face) {
    return {p.halfedge % 3, p.t};
  }
  return {mesh.twin(p.halfedge) % 3, -p.t};
}

bool chordsCross(const PerimeterPosition& a, const PerimeterPosition& b, const PerimeterPosition& p,
                 const PerimeterPosition& q) {
  if (p == a || p == b || q == a || q == b) {
    return false;
  }
  return inArc(a, p, b) != inArc(a, q, b);
}

double polylineLength(const TriangleMesh& mesh, std::span<const EdgePoint> points) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    length += (position(mesh, points[i + 1]) - position(mesh, points[i])).norm();
  }
  return length;
}

std::vector<EdgePoint> withoutDetours(const PathObstacles& obstacles, std::span<const EdgePoint> points) {
  std::vector<EdgePoint> kept;
  kept.reserve(points.size());
  for (const EdgePoint& p : points) {
    while (kept.size() >= 2 &&
           (kept[kept.size() - 2] == p || kept.back() == p || obstacles.permits(kept[kept.size() - 2], p))) {
      kept.pop_back();
    }
    if (kept.empty() || kept.back() != p) {
      kept.push_back(p);
    }
  }
  return kept;
}

bool removeLoops(const TriangleMesh& mesh, std::vector<EdgePoint>& points) {
  bool removed = false;
  for (;;) {
    auto [first, last] = repeatedPoint(points);
    if (last == 0) {
      std::tie(first, last) = crossedSegments(mesh, points);
    } else {
      ++last;  // keep the first occurrence only
    }
    if (last == 0) {
      return removed;
    }
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                 points.begin() + static_cast<std::ptrdiff_t>(last));
    removed = true;
  }
}

}  // namespace graftsman
