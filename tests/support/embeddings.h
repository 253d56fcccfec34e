#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>

#include <Eigen/Geometry>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/predicates.h"
#include "core/fusion/combined_tile.h"
#include "core/fusion/tile.h"

/// Embedded tiles for tests and benchmarks, made without the embedding stage: Tutte's (uniform weights), or
/// with given positions. All keep the promises of Embedding.
namespace graftsman::shapes {

/// A tile and its embedding.
struct TestTile {
  std::vector<Point> points;
  Embedding embedding;

  [[nodiscard]] EmbeddedTile view() const { return {points, embedding}; }
};

inline bool isValid(const Embedding& e) {
  return std::all_of(e.faces.begin(), e.faces.end(), [&](const Face& f) {
    return orient2d(e.uv[static_cast<std::size_t>(f[0])], e.uv[static_cast<std::size_t>(f[1])],
                    e.uv[static_cast<std::size_t>(f[2])]) > 0;
  });
}

/// Divides every interior edge between two boundary vertices (the first `boundary` ones) in the middle; new
/// vertices get the numbers from `vertices` on. Returns the divided edges.
inline std::vector<std::pair<Index, Index>> divideChords(std::vector<Face>& faces, Index boundary,
                                                         Index vertices) {
  std::map<std::pair<Index, Index>, Index> middle;
  std::vector<std::pair<Index, Index>> chords;
  std::map<std::pair<Index, Index>, int> uses;
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[std::minmax(f[k], f[(k + 1) % 3])];
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Face f = faces[i];
      const Index a = f[k];
      const Index b = f[(k + 1) % 3];
      if (a >= boundary || b >= boundary || uses[std::minmax(a, b)] < 2) {
        continue;
      }
      const auto [it, isNew] =
          middle.try_emplace(std::minmax(a, b), vertices + static_cast<Index>(chords.size()));
      if (isNew) {
        chords.emplace_back(std::minmax(a, b));
      }
      const Index m = it->second;
      faces[i] = {a, m, f[(k + 2) % 3]};
      faces.push_back({m, b, f[(k + 2) % 3]});
      --i;  // look at the first piece again; the second comes at the end
      break;
    }
  }
  return chords;
}

/// Tutte's embedding of a disk whose first vertices are its boundary; chords are divided first. Throws where
/// doubles do not suffice.
inline Embedding tutte(std::vector<Face> faces, Index vertices, std::vector<BoundaryPosition> boundary,
                       Index sides) {
  Embedding e;
  const auto b = static_cast<Index>(boundary.size());
  for (const auto& [v, w] : divideChords(faces, b, vertices)) {
    e.added.push_back({{v, w, v}, {0.5, 0.5, 0}});
    ++vertices;
  }
  const Index interior = vertices - b;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(interior, 2);
  e.uv.resize(static_cast<std::size_t>(vertices));
  for (Index i = 0; i < b; ++i) {
    e.uv[static_cast<std::size_t>(i)] = boundaryPoint(sides, boundary[static_cast<std::size_t>(i)]);
  }
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = f[k];
      const Index to = f[(k + 1) % 3];
      if (from < b) {
        continue;  // each edge at an interior vertex leaves it once as a halfedge
      }
      entries.emplace_back(from - b, from - b, 1);
      if (to < b) {
        right.row(from - b) += e.uv[static_cast<std::size_t>(to)].transpose();
      } else {
        entries.emplace_back(from - b, to - b, -1);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(interior, interior);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixX2d solution = solver.solve(right);
  for (Index i = 0; i < interior; ++i) {
    e.uv[static_cast<std::size_t>(b + i)] = solution.row(i).transpose();
  }
  e.faces = std::move(faces);
  e.parents.resize(e.faces.size(), 0);
  e.boundary = std::move(boundary);
  e.sides = sides;
  if (!isValid(e)) {
    throw std::runtime_error("Tutte's embedding ran out of double precision");
  }
  return e;
}

/// A bumpy surface over the embedding, with as much relief as `height` says.
inline TestTile lifted(Embedding e, double height) {
  TestTile tile;
  e.added.clear();  // every vertex is one of the tile
  for (const Point2& p : e.uv) {
    tile.points.emplace_back(p.x(), p.y(),
                             height * (1 - p.squaredNorm() + 0.2 * std::sin(9 * p.x() + 4 * p.y())));
  }
  tile.embedding = std::move(e);
  return tile;
}

/// Random points in a circle, `perSide` boundary vertices beyond the corner on each side (the last few sides
/// may have one less), Delaunay triangulated, then embedded after Tutte. Vertices near each other have near
/// numbers, as in most models.
inline TestTile randomTile(unsigned seed, Index sides, Index perSide, Index interior, double height = 0.5) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<BoundaryPosition> boundary;
  for (Index side = 0; side < sides; ++side) {
    boundary.push_back({side, 0});
    std::vector<double> ts;
    for (Index k = 0; k < perSide; ++k) {
      ts.push_back((k + 0.1 + 0.8 * uniform()) / perSide);
    }
    for (const double t : ts) {
      boundary.push_back({side, t});
    }
  }
  std::vector<Kernel::Point_2> inside;
  const auto b = static_cast<Index>(boundary.size());
  for (Index i = 0; i < interior; ++i) {
    const double r = 0.98 * std::cos(std::numbers::pi / b) * std::sqrt(uniform());
    const double angle = 2 * std::numbers::pi * uniform();
    inside.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  CGAL::hilbert_sort(inside.begin(), inside.end());
  std::vector<std::pair<Kernel::Point_2, Index>> points;
  for (Index i = 0; i < b; ++i) {
    const double angle = 2 * std::numbers::pi * i / b;
    points.emplace_back(Kernel::Point_2(std::cos(angle), std::sin(angle)), i);
  }
  for (Index i = 0; i < interior; ++i) {
    points.emplace_back(inside[static_cast<std::size_t>(i)], b + i);
  }
  const Delaunay delaunay(points.begin(), points.end());
  std::vector<Face> faces;
  for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f) {
    faces.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }
  if (faces.size() == 1) {  // a lone triangle has no interior vertex to hang an edge on
    const auto [p, q, r] = faces[0];
    faces = {{p, q, b}, {q, r, b}, {r, p, b}};
    interior = 1;
  }
  std::sort(faces.begin(), faces.end());
  return lifted(tutte(std::move(faces), b + interior, std::move(boundary), sides), height);
}

/// The same tile with its interior vertices numbered the other way round and solved anew: positions differ in
/// the last bits.
inline TestTile renumbered(const TestTile& tile) {
  const auto b = static_cast<Index>(tile.embedding.boundary.size());
  const auto v = static_cast<Index>(tile.points.size());
  std::vector<Face> faces = tile.embedding.faces;
  for (Face& face : faces) {
    for (Index& corner : face) {
      corner = corner < b ? corner : v - 1 - (corner - b);
    }
  }
  TestTile other = lifted(tutte(std::move(faces), v, tile.embedding.boundary, tile.embedding.sides), 1);
  return other;
}

/// A gathered tile embedded after Tutte, boundary vertices evenly on the sides.
inline Embedding embedded(const Tile& tile) {
  std::vector<BoundaryPosition> boundary;
  const auto sides = static_cast<Index>(tile.corners.size());
  for (Index side = 0; side < sides; ++side) {
    const auto i = static_cast<std::size_t>(side);
    const Index from = tile.corners[i];
    const Index to = i + 1 < tile.corners.size() ? tile.corners[i + 1] : tile.boundarySize;
    for (Index v = from; v < to; ++v) {
      boundary.push_back({side, static_cast<double>(v - from) / (to - from)});
    }
  }
  return tutte(tile.faces, static_cast<Index>(tile.points.size()), std::move(boundary), sides);
}

/// Rings of `perSide · sides` vertices nested `rings` deep round one vertex: Tutte squeezes them
/// exponentially.
inline TestTile nestedRings(Index sides, Index perSide, Index rings, double height = 3, double phase = 0) {
  const Index m = sides * perSide;
  std::vector<BoundaryPosition> boundary;
  for (Index i = 0; i < m; ++i) {
    const double t = static_cast<double>(i % perSide) / perSide;
    boundary.push_back({i / perSide, t == 0 ? 0 : std::min(0.999, t + phase / perSide)});
  }
  std::vector<Face> faces;
  for (Index r = 0; r + 1 < rings; ++r) {
    for (Index i = 0; i < m; ++i) {
      const Index a = r * m + i;
      const Index b = r * m + (i + 1) % m;
      faces.push_back({a, b, b + m});
      faces.push_back({a, b + m, a + m});
    }
  }
  for (Index i = 0; i < m; ++i) {
    faces.push_back({(rings - 1) * m + i, (rings - 1) * m + (i + 1) % m, rings * m});
  }
  return lifted(tutte(std::move(faces), rings * m + 1, std::move(boundary), sides), height);
}

/// The square (n = 4) as a grid of m×m cells, exact where m is a power of two: grids of different m share
/// vertices and lines. `flipped`: the cells' other diagonals.
inline TestTile gridTile(Index m, bool flipped = false, double height = 0.5) {
  // Vertex (i, j) lies at (1 − (i + j) / m, (i − j) / m).
  std::vector<BoundaryPosition> boundary;
  std::map<std::pair<Index, Index>, Index> number;
  const auto add = [&](Index i, Index j) {
    const auto next = static_cast<Index>(number.size());
    return number.try_emplace({i, j}, next).first->second;
  };
  for (Index side = 0; side < 4; ++side) {
    for (Index k = 0; k < m; ++k) {
      const std::array<std::pair<Index, Index>, 4> at = {{{k, 0}, {m, k}, {m - k, m}, {0, m - k}}};
      add(at[static_cast<std::size_t>(side)].first, at[static_cast<std::size_t>(side)].second);
      boundary.push_back({side, static_cast<double>(k) / m});
    }
  }
  Embedding e;
  for (Index j = 0; j < m; ++j) {
    for (Index i = 0; i < m; ++i) {
      const Index a = add(i, j);
      const Index b = add(i + 1, j);
      const Index c = add(i + 1, j + 1);
      const Index d = add(i, j + 1);
      if (flipped) {
        e.faces.push_back({a, b, d});
        e.faces.push_back({b, c, d});
      } else {
        e.faces.push_back({a, b, c});
        e.faces.push_back({a, c, d});
      }
    }
  }
  e.uv.resize(number.size());
  for (const auto& [at, v] : number) {
    e.uv[static_cast<std::size_t>(v)] = {1 - static_cast<double>(at.first + at.second) / m,
                                         static_cast<double>(at.first - at.second) / m};
  }
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    e.uv[i] = boundaryPoint(4, boundary[i]);
  }
  const auto chords =
      divideChords(e.faces, static_cast<Index>(boundary.size()), static_cast<Index>(e.uv.size()));
  for (const auto& [a, b] : chords) {
    e.uv.emplace_back((e.uv[static_cast<std::size_t>(a)] + e.uv[static_cast<std::size_t>(b)]) / 2);
  }
  e.parents.resize(e.faces.size(), 0);
  e.boundary = std::move(boundary);
  e.sides = 4;
  if (!isValid(e)) {
    throw std::runtime_error("the grid is not valid");
  }
  return lifted(std::move(e), height);
}

}  // namespace graftsman::shapes
