#pragma once

#include <span>
#include <vector>

#include "core/fusion/aggregation.h"
#include "core/fusion/laplace_system.h"

namespace graftsman {

/// An approximate inverse of a Laplace matrix in linear time: one V-cycle over aggregates (Vaněk, Mandel &
/// Brezina 1996) with Gauss–Seidel smoothing, in single precision, for two right-hand sides at once.
/// Symmetric if the matrix is. Deterministic. About 90 bytes a matrix row and column pair.
class Multigrid {
 public:
  Multigrid(const SparseRows& matrix, Interpolation interpolation);
  ~Multigrid();
  Multigrid(Multigrid&&) noexcept;
  Multigrid& operator=(Multigrid&&) noexcept;

  /// out ≈ A⁻¹ in. Both N×2; they may be the same. Not thread-safe: uses buffers of its own.
  void apply(std::span<const Point2> in, std::span<Point2> out);

 private:
  struct Level;
  std::vector<Level> levels_;
  Eigen::MatrixXf coarsest_;  // the inverse on the last level, empty if that is too large
  void cycle(std::size_t depth);
};

}  // namespace graftsman
