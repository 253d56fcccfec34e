#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/fusion/cut.h"
#include "core/fusion/tile.h"
#include "core/mesh/barycentric.h"

/// What the contracts of cutMesh() and gatherTile() promise, checked from their outputs. Each returns what is
/// wrong, or an empty string.
namespace graftsman::checks {

inline std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

inline double area(const Point& a, const Point& b, const Point& c) {
  return (b - a).cross(c - a).norm() / 2;
}

inline Point cutPoint(const TriangleMesh& mesh, const Cut& cut, Index v) {
  return v < mesh.vertexCount() ? mesh.point(v) : cut.points[at(v - mesh.vertexCount())];
}

/// The undivided faces and the pieces as one mesh: `rest` tells which to take.
template <class TakeFace, class TakePiece>
TriangleMesh assembled(const TriangleMesh& mesh, const Cut& cut, const TakeFace& takeFace,
                       const TakePiece& takePiece) {
  std::vector<Point> points = mesh.points();
  points.insert(points.end(), cut.points.begin(), cut.points.end());
  std::vector<Face> faces;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    if (!std::binary_search(cut.parents.begin(), cut.parents.end(), f) && takeFace(f)) {
      faces.push_back(mesh.face(f));
    }
  }
  for (std::size_t p = 0; p < cut.faces.size(); ++p) {
    if (takePiece(static_cast<Index>(p))) {
      faces.push_back(cut.faces[p]);
    }
  }
  return {std::move(points), std::move(faces)};
}

inline TriangleMesh dividedMesh(const TriangleMesh& mesh, const Cut& cut) {
  const auto all = [](Index) { return true; };
  return assembled(mesh, cut, all, all);
}

inline long eulerCharacteristic(const TriangleMesh& mesh) {
  long used = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    used += mesh.outgoing(v) >= 0 ? 1 : 0;
  }
  long halfEdges = 0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    halfEdges += mesh.twin(h) < 0 ? 2 : 1;
  }
  return used - halfEdges / 2 + mesh.faceCount();
}

inline long borderEdges(const TriangleMesh& mesh) {
  long count = 0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    count += mesh.twin(h) < 0 ? 1 : 0;
  }
  return count;
}

inline double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces()) {
    sum += area(mesh.point(a), mesh.point(b), mesh.point(c));
  }
  return sum;
}

/// The weights that a vertex of a piece has in the piece's parent; negative where it is no point of it.
inline Eigen::Vector3d weightsIn(const TriangleMesh& mesh, const Cut& cut, Index parent, Index v) {
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const Index h = 3 * parent + k;
    if (v < mesh.vertexCount()) {
      if (mesh.from(h) == v) {
        weights[k] = 1;
      }
      continue;
    }
    const EdgePoint& p = cut.where[at(v - mesh.vertexCount())];
    if (p.halfedge == h || p.halfedge == mesh.twin(h)) {
      const double t = p.halfedge == h ? p.t : 1 - p.t;
      weights[k] = 1 - t;
      weights[(k + 1) % 3] = t;
    }
  }
  return weights.sum() > 0 ? weights : Eigen::Vector3d(-1, -1, -1);
}

inline std::string cutFault(const TriangleMesh& mesh, const LoopPaths& paths, const Cut& cut) {
  std::vector<Index> boundary;
  std::vector<Index> corners;
  std::size_t made = 0;
  for (const auto& path : paths.paths) {
    corners.push_back(static_cast<Index>(boundary.size()));
    for (std::size_t i = 0; i + 1 < path->points.size(); ++i) {
      const EdgePoint& p = path->points[i];
      boundary.push_back(p.isVertex() ? p.vertex : mesh.vertexCount() + static_cast<Index>(made));
      if (p.isVertex()) {
        continue;
      }
      if (made >= cut.where.size() || !(cut.where[made] == p) || cut.points[made] != position(mesh, p)) {
        return "a new point is not where the path has it";
      }
      ++made;
    }
  }
  if (boundary != cut.boundary || corners != cut.corners || made != cut.points.size()) {
    return "the boundary is not the paths, one after the other";
  }
  if (cut.parents.size() != cut.faces.size() || !std::is_sorted(cut.parents.begin(), cut.parents.end())) {
    return "parents are not ascending";
  }
  for (std::size_t i = 0; i < cut.faces.size();) {
    const Index parent = cut.parents[i];
    double sum = 0;
    double weightSum = 0;
    for (; i < cut.faces.size() && cut.parents[i] == parent; ++i) {
      Eigen::Matrix3d w;
      for (int k = 0; k < 3; ++k) {
        w.row(k) = weightsIn(mesh, cut, parent, cut.faces[i][at(k)]);
      }
      if (w.minCoeff() < 0) {
        return "a piece leaves its parent";
      }
      if (((w.colwise().sum().array() == 0).any())) {
        return "a piece has three vertices on one edge of its parent";
      }
      if (orientBarycentric(w.row(0), w.row(1), w.row(2)) <= 0) {
        return "a piece is turned over";
      }
      weightSum += w.determinant();
      const auto& [a, b, c] = cut.faces[i];
      sum += area(cutPoint(mesh, cut, a), cutPoint(mesh, cut, b), cutPoint(mesh, cut, c));
    }
    const auto& [a, b, c] = mesh.face(parent);
    const double whole = area(mesh.point(a), mesh.point(b), mesh.point(c));
    const double longest =
        std::max({(mesh.point(a) - mesh.point(b)).norm(), (mesh.point(b) - mesh.point(c)).norm(),
                  (mesh.point(c) - mesh.point(a)).norm()});
    const double rounding = 1e-14 * (mesh.point(a).norm() + longest) * longest;
    if (std::abs(weightSum - 1) > 1e-12 || std::abs(sum - whole) > 1e-12 * whole + rounding) {
      return "the pieces do not fill their parent";
    }
  }
  const TriangleMesh divided = dividedMesh(mesh, cut);
  if (eulerCharacteristic(divided) != eulerCharacteristic(mesh)) {
    return "the Euler characteristic changed";
  }
  for (Index v = 0; v < divided.vertexCount(); ++v) {
    if (divided.singular(v) != (v < mesh.vertexCount() && mesh.singular(v))) {
      return "a vertex became or ceased to be singular";
    }
  }
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Index a = boundary[i];
    const Index b = boundary[(i + 1) % boundary.size()];
    if (divided.halfedgeBetween(a, b) < 0 && divided.halfedgeBetween(b, a) < 0) {
      return "a boundary edge is no edge of the divided mesh";
    }
  }
  return {};
}

inline std::string tileFault(const TriangleMesh& mesh, const Cut& cut, const Tile& tile) {
  const auto size = static_cast<Index>(cut.boundary.size());
  if (tile.boundarySize != size || tile.corners != cut.corners) {
    return "the boundary is not the cut's";
  }
  if (tile.vertices.size() != tile.points.size() ||
      !std::equal(cut.boundary.begin(), cut.boundary.end(), tile.vertices.begin())) {
    return "the first vertices are not the boundary";
  }
  if (std::adjacent_find(tile.vertices.begin() + size, tile.vertices.end(), std::greater_equal<>()) !=
      tile.vertices.end()) {
    return "the interior vertices are not ascending";
  }
  for (std::size_t v = 0; v < tile.vertices.size(); ++v) {
    if (tile.points[v] != cutPoint(mesh, cut, tile.vertices[v])) {
      return "a position is not the mesh's, bit for bit";
    }
  }
  if (tile.faces.size() != tile.wholeFaces.size() + tile.pieces.size() ||
      !std::is_sorted(tile.wholeFaces.begin(), tile.wholeFaces.end()) ||
      !std::is_sorted(tile.pieces.begin(), tile.pieces.end())) {
    return "the faces are not in order";
  }
  for (std::size_t f = 0; f < tile.faces.size(); ++f) {
    const bool whole = f < tile.wholeFaces.size();
    const Face& source =
        whole ? mesh.face(tile.wholeFaces[f]) : cut.faces[at(tile.pieces[f - tile.wholeFaces.size()])];
    for (std::size_t k = 0; k < 3; ++k) {
      if (tile.vertices[at(tile.faces[f][k])] != source[k]) {
        return "a face is not that of the mesh or the cut";
      }
    }
    if (whole && std::binary_search(cut.parents.begin(), cut.parents.end(), tile.wholeFaces[f])) {
      return "a divided face is in the tile as a whole";
    }
  }
  const TriangleMesh disk(tile.points, tile.faces);
  if (eulerCharacteristic(disk) != 1 || borderEdges(disk) != size) {
    return "the tile is no disk";
  }
  for (Index v = 0; v < disk.vertexCount(); ++v) {
    if (disk.singular(v)) {
      return "the tile is not manifold";
    }
  }
  for (Index i = 0; i < size; ++i) {
    const Index h = disk.halfedgeBetween(i, (i + 1) % size);
    if (h < 0 || disk.twin(h) >= 0) {
      return "the loop is not the tile's border, with the tile on its left";
    }
  }
  return {};
}

}  // namespace graftsman::checks
