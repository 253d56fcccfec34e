#include "core/fusion/multigrid.h"

#include <Eigen/Dense>

namespace graftsman {
namespace {

/// Unknowns that a dense inverse solves at the price of a Gauss–Seidel sweep or two on the level above.
constexpr std::size_t kDense = 120;

/// Above this share of the finer level's unknowns, coarsening does not pay any more.
constexpr double kPoorCoarsening = 0.8;

/// Sweeps that stand for the solution on a last level too large for the dense inverse.
constexpr int kCoarsestSweeps = 20;

/// The inverse with rows and columns in the given order.
Eigen::MatrixXf denseInverse(const SparseRows& a, const std::vector<Index>& order) {
  const auto n = static_cast<Eigen::Index>(a.rows());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index r = 0; r < n; ++r) {
    const auto row = static_cast<std::size_t>(r);
    dense(r, r) = a.diagonal[row];
    for (auto k = static_cast<std::size_t>(a.offsets[row]); k < static_cast<std::size_t>(a.offsets[row + 1]);
         ++k) {
      dense(r, a.columns[k]) = a.values[k];
    }
  }
  const Eigen::MatrixXd inverse = dense.partialPivLu().inverse();
  return inverse(order, order).cast<float>();
}

}  // namespace

Multigrid::Multigrid(const SparseRows& matrix, Interpolation interpolation) {
  levels_.emplace_back(matrix);
  SparseRows coarse;
  const SparseRows* finest = &matrix;
  while (finest->rows() > kDense) {
    const Prolongation p = aggregate(*finest, interpolation);
    if (static_cast<double>(p.coarseCount) > kPoorCoarsening * static_cast<double>(finest->rows())) {
      return;
    }
    coarse = coarseMatrix(*finest, p);
    finest = &coarse;
    levels_.emplace_back(coarse);
    levels_[levels_.size() - 2].connect(p, levels_.back());
  }
  coarsest_ = denseInverse(*finest, levels_.back().order());
}

void Multigrid::cycle(std::size_t depth) {
  MultigridLevel& level = levels_[depth];
  if (depth + 1 < levels_.size()) {
    level.sweepFromZero();
    level.restrictTo(levels_[depth + 1].b);
    cycle(depth + 1);
    level.addFrom(levels_[depth + 1].x);
    level.sweepBackward();
  } else if (coarsest_.size() > 0) {
    using Pairs = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;
    const auto n = static_cast<Eigen::Index>(level.rows());
    const Eigen::Map<const Pairs> b(reinterpret_cast<const float*>(level.b.data()), n, 2);
    Eigen::Map<Pairs>(reinterpret_cast<float*>(level.x.data()), n, 2).noalias() = coarsest_ * b;
  } else {
    std::fill(level.x.begin(), level.x.end(), Pair{});
    for (int i = 0; i < kCoarsestSweeps; ++i) {
      level.sweepForward();
      level.sweepBackward();
    }
  }
}

void Multigrid::apply(std::span<const Point2> in, std::span<Point2> out) {
  MultigridLevel& top = levels_.front();
  for (std::size_t r = 0; r < in.size(); ++r) {
    const Point2& p = in[static_cast<std::size_t>(top.order()[r])];
    top.b[r].value = Pair::Two{static_cast<float>(p.x()), static_cast<float>(p.y())};
  }
  cycle(0);
  for (std::size_t r = 0; r < out.size(); ++r) {
    const Pair::Two& value = top.x[r].value;
    out[static_cast<std::size_t>(top.order()[r])] = {value[0], value[1]};
  }
}

}  // namespace graftsman
