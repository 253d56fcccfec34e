#include "core/fusion/laplace_system.h"

namespace graftsman {

LaplaceSystem laplaceSystem(const Stars& stars, const SlotWeights& weights, std::span<const Point2> boundary,
                            MatrixKind kind) {
  const std::size_t rows = stars.offsets.size() - 1;
  const auto first = static_cast<Index>(boundary.size());
  LaplaceSystem system;
  system.kind = kind;
  system.rhs.assign(rows, Point2::Zero());
  SparseRows& matrix = system.matrix;
  matrix.offsets.reserve(rows + 1);
  matrix.columns.reserve(stars.ring.size());
  matrix.values.reserve(stars.ring.size());
  matrix.diagonal.resize(rows);
  matrix.offsets.push_back(0);
  for (std::size_t r = 0; r < rows; ++r) {
    const auto begin = static_cast<std::size_t>(stars.offsets[r]);
    const auto end = static_cast<std::size_t>(stars.offsets[r + 1]);
    double sum = 0;
    for (std::size_t slot = begin; slot < end; ++slot) {
      sum += weights[slot];
    }
    const double scale = kind == MatrixKind::Symmetric ? 1 : 1 / sum;
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Index column = stars.ring[slot] - first;
      if (column >= 0) {
        matrix.columns.push_back(column);
        matrix.values.push_back(-scale * weights[slot]);
      } else {
        system.rhs[r] += scale * weights[slot] * boundary[static_cast<std::size_t>(stars.ring[slot])];
      }
    }
    matrix.offsets.push_back(static_cast<Index>(matrix.columns.size()));
    matrix.diagonal[r] = scale * sum;
  }
  return system;
}

void residual(const LaplaceSystem& system, std::span<const Point2> x, std::span<Point2> out) {
  const SparseRows& a = system.matrix;
  for (std::size_t r = 0; r < a.rows(); ++r) {
    Point2 sum = system.rhs[r] - a.diagonal[r] * x[r];
    for (auto k = static_cast<std::size_t>(a.offsets[r]); k < static_cast<std::size_t>(a.offsets[r + 1]);
         ++k) {
      sum -= a.values[k] * x[static_cast<std::size_t>(a.columns[k])];
    }
    out[r] = sum;
  }
}

}  // namespace graftsman
