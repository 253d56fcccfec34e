#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "core/mesh/triangle_mesh.h"

/// Generated meshes for tests and benchmarks, all oriented outwards (the grid: towards +z).
namespace graftsman::shapes {

using MeshPtr = std::shared_ptr<const TriangleMesh>;

/// A square [0, 1]² in the plane z = 0 of n×n cells, two triangles each; vertex (i, j) is j (n + 1) + i.
inline MeshPtr grid(Index n) {
  std::vector<Point> points;
  std::vector<Face> faces;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) {
      points.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n, 0);
    }
  }
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      const Index c = a + n + 2;
      faces.push_back({a, a + 1, c});
      faces.push_back({a, c, a + n + 1});
    }
  }
  return std::make_shared<TriangleMesh>(std::move(points), std::move(faces));
}

/// Each triangle in four, new vertices on edge midpoints; old vertices keep their numbers.
inline std::pair<std::vector<Point>, std::vector<Face>> subdivided(std::vector<Point> points,
                                                                   const std::vector<Face>& faces) {
  std::map<std::pair<Index, Index>, Index> middle;
  const auto mid = [&](Index a, Index b) {
    const auto [it, isNew] = middle.try_emplace(std::minmax(a, b), static_cast<Index>(points.size()));
    if (isNew) {
      points.push_back((points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]) / 2);
    }
    return it->second;
  };
  std::vector<Face> finer;
  finer.reserve(4 * faces.size());
  for (const auto& [a, b, c] : faces) {
    const Index ab = mid(a, b);
    const Index bc = mid(b, c);
    const Index ca = mid(c, a);
    finer.insert(finer.end(), {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}});
  }
  return {std::move(points), std::move(finer)};
}

/// The unit sphere from an icosahedron subdivided `level` times: 20 · 4^level faces.
inline MeshPtr icosphere(int level) {
  const double g = std::numbers::phi;
  std::vector<Point> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                               {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Face> faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                             {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                             {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                             {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int i = 0; i < level; ++i) {
    std::tie(points, faces) = subdivided(std::move(points), faces);
  }
  for (Point& p : points) {
    p.normalize();
  }
  return std::make_shared<TriangleMesh>(std::move(points), std::move(faces));
}

/// A torus round the z axis with radii 1 and `tube`; vertex (i, j) is i · n + j, i round the axis, j round
/// the tube.
inline MeshPtr torus(Index m, Index n, double tube = 0.4) {
  std::vector<Point> points;
  std::vector<Face> faces;
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double a = 2 * std::numbers::pi * i / m;
      const double b = 2 * std::numbers::pi * j / n;
      const double r = 1 + tube * std::cos(b);
      points.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
      const Index i1 = (i + 1) % m;
      const Index j1 = (j + 1) % n;
      faces.push_back({i * n + j, i1 * n + j, i1 * n + j1});
      faces.push_back({i * n + j, i1 * n + j1, i * n + j1});
    }
  }
  return std::make_shared<TriangleMesh>(std::move(points), std::move(faces));
}

}  // namespace graftsman::shapes
