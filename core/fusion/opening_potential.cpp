#include "core/fusion/opening_potential.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/fusion/embedding_weights.h"
#include "core/fusion/laplace_solver.h"
#include "core/mesh/at.h"

namespace graftsman {
namespace {

/// A face belongs to a squeezed region from this ratio of uv-area to even share on: a tenth in length.
constexpr double kRegion = 1e-2;

/// φ is a logarithm: so small an error changes weights by a thousandth.
constexpr double kPotentialTolerance = 1e-3;

/// Depth of each row in the squeezed regions: 0 outside, 1 beside the outside, …
struct Depths {
  std::vector<Index> depth;  // N
  std::vector<Index> order;  // rows with depth > 0, by depth, then by discovery
};

std::vector<char> squeezedRows(const EmbeddingTile& tile, const Stars& stars, const std::vector<Point2>& uv,
                               Index sides) {
  const double total = sides * std::sin(2 * std::numbers::pi / sides);
  std::vector<char> squeezed(tile.faces.size());
  for (std::size_t f = 0; f < squeezed.size(); ++f) {
    const auto [i, j, k] = tile.faces[f];
    const Point2 ab = uv[at(j)] - uv[at(i)];
    const Point2 ac = uv[at(k)] - uv[at(i)];
    squeezed[f] = std::abs(ab.x() * ac.y() - ab.y() * ac.x()) < kRegion * total * tile.areas[f];
  }
  std::vector<char> rows(stars.offsets.size() - 1, 1);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (Index slot = stars.offsets[r]; slot < stars.offsets[r + 1]; ++slot) {
      rows[r] = rows[r] && squeezed[at(stars.halfedges[at(slot)] / 3)];
    }
  }
  return rows;
}

Depths measureDepths(const Stars& stars, const std::vector<char>& squeezed, Index boundarySize) {
  const Index rows = static_cast<Index>(squeezed.size());
  Depths depths{std::vector<Index>(squeezed.size(), 0), {}};
  for (Index r = 0; r < rows; ++r) {
    bool beside = false;
    for (Index slot = stars.offsets[at(r)]; slot < stars.offsets[at(r) + 1]; ++slot) {
      const Index other = stars.ring[at(slot)] - boundarySize;
      beside = beside || other < 0 || !squeezed[at(other)];
    }
    if (squeezed[at(r)] && beside) {
      depths.depth[at(r)] = 1;
      depths.order.push_back(r);
    }
  }
  for (std::size_t i = 0; i < depths.order.size(); ++i) {
    const Index r = depths.order[i];
    for (Index slot = stars.offsets[at(r)]; slot < stars.offsets[at(r) + 1]; ++slot) {
      const Index other = stars.ring[at(slot)] - boundarySize;
      if (other >= 0 && squeezed[at(other)] && depths.depth[at(other)] == 0) {
        depths.depth[at(other)] = depths.depth[at(r)] + 1;
        depths.order.push_back(other);
      }
    }
  }
  return depths;
}

/// Disjoint sets with path halving.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  Index find(Index i) {
    while (parent_[at(i)] != i) {
      parent_[at(i)] = parent_[at(parent_[at(i)])];
      i = parent_[at(i)];
    }
    return i;
  }

  void unite(Index i, Index j) { parent_[at(find(i))] = find(j); }

 private:
  std::vector<Index> parent_;
};

/// Adds, for each face round row r that leads to a lesser depth, its part of the curve between the depths:
/// half its edge that does not cross, shared by the face's deeper vertices.
double curvePart(const EmbeddingTile& tile, const Stars& stars, const std::vector<Index>& depth, Index r) {
  const Index own = depth[at(r)];
  const auto isShallow = [&](Index v) {
    return v < tile.boundarySize || depth[at(v - tile.boundarySize)] < own;
  };
  double sum = 0;
  const Index centre = r + tile.boundarySize;
  const Index begin = stars.offsets[at(r)];
  const Index end = stars.offsets[at(r) + 1];
  for (Index slot = begin; slot < end; ++slot) {
    const Index a = stars.ring[at(slot)];
    const Index b = stars.ring[at(slot + 1 == end ? begin : slot + 1)];
    const auto length = [&](Index i, Index j) { return (tile.points[at(i)] - tile.points[at(j)]).norm(); };
    if (isShallow(a) && isShallow(b)) {
      sum += length(a, b) / 2;
    } else if (isShallow(a)) {
      sum += length(centre, b) / 4;
    } else if (isShallow(b)) {
      sum += length(centre, a) / 4;
    }
  }
  return sum;
}

}  // namespace

std::vector<double> inverseSquareGirths(const LayoutProblem& problem, const std::vector<Point2>& uv) {
  const auto& [tile, stars, boundary, sides] = problem;
  const Depths depths = measureDepths(stars, squeezedRows(tile, stars, uv, sides), tile.boundarySize);
  std::vector<double> out(depths.depth.size(), 0);
  std::vector<double> girth(depths.depth.size(), 0);
  Sets sets(depths.depth.size());
  // From the innermost depth outwards: the sets are the parts of the tile that lie at least so deep.
  std::size_t end = depths.order.size();
  while (end > 0) {
    const Index depth = depths.depth[at(depths.order[end - 1])];
    std::size_t begin = end;
    while (begin > 0 && depths.depth[at(depths.order[begin - 1])] == depth) {
      --begin;
    }
    for (std::size_t i = begin; i < end; ++i) {
      const Index r = depths.order[i];
      for (Index slot = stars.offsets[at(r)]; slot < stars.offsets[at(r) + 1]; ++slot) {
        const Index other = stars.ring[at(slot)] - tile.boundarySize;
        if (other >= 0 && depths.depth[at(other)] >= depth) {
          sets.unite(r, other);
        }
      }
    }
    for (std::size_t i = begin; i < end; ++i) {
      girth[at(sets.find(depths.order[i]))] = 0;
    }
    for (std::size_t i = begin; i < end; ++i) {
      girth[at(sets.find(depths.order[i]))] += curvePart(tile, stars, depths.depth, depths.order[i]);
    }
    for (std::size_t i = begin; i < end; ++i) {
      const double radius = girth[at(sets.find(depths.order[i]))] / (2 * std::numbers::pi);
      out[at(depths.order[i])] = radius > 0 ? 1 / (radius * radius) : 0;
    }
    end = begin;
  }
  return out;
}

std::vector<double> openingPotential(const LayoutProblem& problem, const std::vector<Point2>& uv,
                                     const Progress& progress) {
  const auto& [tile, stars, boundary, sides] = problem;
  const std::vector<double> girths = inverseSquareGirths(problem, uv);
  const std::vector<Point2> zeros(at(tile.boundarySize), Point2::Zero());
  LaplaceSystem system = laplaceSystem(stars, cotangentWeights(tile, stars), zeros, MatrixKind::Symmetric);
  for (std::size_t f = 0; f < tile.faces.size(); ++f) {
    const auto [i, j, k] = tile.faces[f];
    const Point& a = tile.points[at(i)];
    // The weights are cot α + cot β, twice the Laplacian's: twice a third of the face's area for each corner.
    const double share = (tile.points[at(j)] - a).cross(tile.points[at(k)] - a).norm() / 3;
    for (const Index v : {i, j, k}) {
      if (v >= tile.boundarySize) {
        const auto row = at(v - tile.boundarySize);
        system.rhs[row].x() += share * girths[row];
      }
    }
  }
  LaplaceSolver solver(std::move(system));
  if (solver.solve(kPotentialTolerance, progress) == LaplaceSolver::Outcome::Cancelled) {
    return {};
  }
  std::vector<double> potential(tile.points.size(), 0);
  for (std::size_t r = 0; r < girths.size(); ++r) {
    potential[r + at(tile.boundarySize)] = solver.solution()[r].x();
  }
  return potential;
}

}  // namespace graftsman
