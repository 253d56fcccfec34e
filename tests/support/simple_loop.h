#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/fusion/paths.h"

/// An independent check of a loop's paths: shares no code with the search for them.
namespace graftsman::simple_loop {

/// Where a point lies round a face: corner k is (k, 0, 0), a point of the edge after it (k, 1, rising).
using Place = std::tuple<int, int, double>;

inline std::optional<Place> placeIn(const TriangleMesh& mesh, Index face, const EdgePoint& p) {
  for (int k = 0; k < 3; ++k) {
    const Index h = 3 * face + k;
    if (p.isVertex()) {
      if (mesh.from(h) == p.vertex) {
        return Place{k, 0, 0};
      }
    } else if (p.halfedge == h) {
      return Place{k, 1, p.t};
    } else if (p.halfedge == mesh.twin(h)) {
      return Place{k, 1, -p.t};
    }
  }
  return std::nullopt;
}

/// The two vertices of the edge that both points lie on, if there is one.
inline std::optional<std::pair<Index, Index>> commonEdge(const TriangleMesh& mesh, const EdgePoint& a,
                                                         const EdgePoint& b) {
  if (a.isVertex() && b.isVertex()) {
    const bool joined =
        mesh.halfedgeBetween(a.vertex, b.vertex) >= 0 || mesh.halfedgeBetween(b.vertex, a.vertex) >= 0;
    return joined ? std::optional(std::pair(std::min(a.vertex, b.vertex), std::max(a.vertex, b.vertex)))
                  : std::nullopt;
  }
  const EdgePoint& inside = a.isVertex() ? b : a;
  const EdgePoint& other = a.isVertex() ? a : b;
  const Index low = std::min(mesh.from(inside.halfedge), mesh.to(inside.halfedge));
  const Index high = std::max(mesh.from(inside.halfedge), mesh.to(inside.halfedge));
  const bool same =
      other.isVertex() ? other.vertex == low || other.vertex == high : other.halfedge == inside.halfedge;
  return same ? std::optional(std::pair(low, high)) : std::nullopt;
}

/// The face whose inside the straight line from a to b crosses. Precondition: they share no edge.
inline std::optional<Index> commonFace(const TriangleMesh& mesh, const EdgePoint& a, const EdgePoint& b) {
  const EdgePoint& inside = a.isVertex() ? b : a;
  for (const Index h : {inside.halfedge, mesh.twin(inside.halfedge)}) {
    const Index face = TriangleMesh::faceOf(h);
    if (h >= 0 && placeIn(mesh, face, a) && placeIn(mesh, face, b)) {
      return face;
    }
  }
  return std::nullopt;
}

inline std::string faultOfPoint(const TriangleMesh& mesh, const EdgePoint& p) {
  if (p.isVertex()) {
    return p.vertex >= mesh.vertexCount() || mesh.singular(p.vertex) ? "a vertex is singular" : "";
  }
  if (p.halfedge < 0 || p.halfedge >= mesh.halfedgeCount() || mesh.twin(p.halfedge) < p.halfedge) {
    return "a point's halfedge is not its edge's smaller one, or the edge has no twin";
  }
  return p.t > 0 && p.t < 1 ? "" : "t is not inside (0, 1)";
}

/// What is wrong with one path from `from` to `to` by itself, or nothing.
inline std::string faultOf(const TriangleMesh& mesh, const Path& path, Index from, Index to) {
  const auto& points = path.points;
  if (points.size() < 2 || points.front() != EdgePoint{from, -1, 0} ||
      points.back() != EdgePoint{to, -1, 0}) {
    return "the ends are not the CVs";
  }
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const auto fault = faultOfPoint(mesh, points[i]); !fault.empty()) {
      return fault;
    }
    if (i == 0) {
      continue;
    }
    length += (position(mesh, points[i]) - position(mesh, points[i - 1])).norm();
    const auto edge = commonEdge(mesh, points[i - 1], points[i]);
    if (!edge && !commonFace(mesh, points[i - 1], points[i])) {
      return "two consecutive points share neither a face nor an edge";
    }
    if (i > 1 && edge && commonEdge(mesh, points[i - 2], points[i - 1]) == edge) {
      return "three consecutive points lie on one edge";
    }
  }
  return std::abs(length - path.length) <= 1e-12 * length ? "" : "the length is not that of the points";
}

/// What keeps the paths from being a simple closed curve through the CVs, or nothing.
inline std::string fault(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                         const std::vector<std::shared_ptr<const Path>>& paths) {
  if (paths.size() != cvs.size()) {
    return "not one path a CV";
  }
  std::vector<EdgePoint> loop;
  for (std::size_t i = 0; i < cvs.size(); ++i) {
    if (auto f = faultOf(mesh, *paths[i], cvs[i], cvs[(i + 1) % cvs.size()]); !f.empty()) {
      return "path " + std::to_string(i) + ": " + f;
    }
    loop.insert(loop.end(), paths[i]->points.begin(), paths[i]->points.end() - 1);
  }
  std::set<std::tuple<Index, Index, double>> seen;
  for (const EdgePoint& p : loop) {
    if (!seen.insert(p.isVertex() ? std::tuple(p.vertex, Index{-1}, 0.0)
                                  : std::tuple(Index{-1}, p.halfedge, p.t))
             .second) {
      return "a point occurs twice";
    }
  }
  std::set<std::pair<Index, Index>> alongEdges;
  std::map<Index, std::vector<std::pair<Place, Place>>> chords;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const EdgePoint& a = loop[i];
    const EdgePoint& b = loop[(i + 1) % loop.size()];
    if (const auto edge = commonEdge(mesh, a, b)) {
      if (!alongEdges.insert(*edge).second) {
        return "two segments run along one edge";
      }
      continue;
    }
    const Index face = *commonFace(mesh, a, b);
    chords[face].push_back(std::minmax(*placeIn(mesh, face, a), *placeIn(mesh, face, b)));
  }
  for (const EdgePoint& p : loop) {
    if (!p.isVertex() && alongEdges.contains(std::minmax(mesh.from(p.halfedge), mesh.to(p.halfedge)))) {
      return "a path crosses an edge that another runs along";
    }
  }
  for (const auto& [face, inFace] : chords) {
    for (const auto& [a, b] : inFace) {
      for (const auto& [c, d] : inFace) {
        if (a < c && c < b && b < d) {
          return "two segments cross in face " + std::to_string(face);
        }
      }
    }
  }
  return "";
}

inline std::string fault(const TriangleMesh& mesh, const std::vector<Index>& cvs, const LoopPaths& paths) {
  return fault(mesh, cvs, paths.paths);
}

}  // namespace graftsman::simple_loop
