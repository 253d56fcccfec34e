#pragma once

#include <span>
#include <vector>

#include "core/fusion/embedding_weights.h"

namespace graftsman {

/// A square sparse matrix by rows, its diagonal apart.
struct SparseRows {
  std::vector<Index> offsets;  // N + 1
  std::vector<Index> columns;
  std::vector<double> values;
  std::vector<double> diagonal;  // N

  [[nodiscard]] std::size_t rows() const { return diagonal.size(); }
};

/// What an iteration may expect of a matrix.
enum class MatrixKind {
  Symmetric,
  NearlySymmetric,  // after a scaling of its rows
  Drifting          // weights differ by orders of magnitude within a row: to one side of it, in the main
};

/// Σ w (ring − i) = 0 for every interior vertex i, with the boundary vertices moved to the right-hand sides.
struct LaplaceSystem {
  SparseRows matrix;
  std::vector<Point2> rhs;  // N×2, one column each for u and v
  MatrixKind kind = MatrixKind::Symmetric;
};

/// The system of the weights. boundary: B×2, the boundary's positions. Rows of an unsymmetric system are
/// divided by the sum of their weights.
[[nodiscard]] LaplaceSystem laplaceSystem(const Stars& stars, const SlotWeights& weights,
                                          std::span<const Point2> boundary, MatrixKind kind);

/// b − A x.
void residual(const LaplaceSystem& system, std::span<const Point2> x, std::span<Point2> out);

}  // namespace graftsman
