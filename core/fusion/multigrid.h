#pragma once

#include <span>
#include <vector>

#include "core/fusion/multigrid_level.h"

namespace graftsman {

/// An approximate inverse of a Laplace matrix in linear time: one V-cycle over aggregates (Vaněk, Mandel &
/// Brezina 1996) with Gauss–Seidel smoothing, in single precision, for two right-hand sides at once.
/// Symmetric if the matrix is. Deterministic.
class Multigrid {
 public:
  Multigrid(const SparseRows& matrix, Interpolation interpolation);

  /// out ≈ A⁻¹ in. Both N×2; they may be the same. Not thread-safe: uses buffers of its own.
  void apply(std::span<const Point2> in, std::span<Point2> out);

 private:
  void cycle(std::size_t depth);

  std::vector<MultigridLevel> levels_;
  Eigen::MatrixXf coarsest_;  // the inverse on the last level; empty if that is too large
};

}  // namespace graftsman
