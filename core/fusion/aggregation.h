#pragma once

#include "core/fusion/laplace_system.h"

namespace graftsman {

/// The interpolation from a coarse level to the next finer one: N rows, values > 0 for an M-matrix.
struct Prolongation {
  std::vector<Index> offsets;  // N + 1
  std::vector<Index> columns;  // numbers of coarse unknowns
  std::vector<double> values;
  Index coarseCount = 0;
};

/// How the indicator functions of the groups become an interpolation.
enum class Interpolation { Smoothed, Constant };

/// Groups neighbouring unknowns with strong connections and smooths the groups' indicator functions by one
/// damped Jacobi step (Vaněk, Mandel & Brezina 1996), or leaves them as they are: slower, but the coarse
/// matrices of an unsymmetric M-matrix then are M-matrices, too, however strongly it drifts.
[[nodiscard]] Prolongation aggregate(const SparseRows& matrix, Interpolation interpolation);

/// Pᵀ A P.
[[nodiscard]] SparseRows coarseMatrix(const SparseRows& matrix, const Prolongation& p);

}  // namespace graftsman
