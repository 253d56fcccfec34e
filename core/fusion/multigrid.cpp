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

struct Pair {
  float u = 0;
  float v = 0;
};

}  // namespace

struct Multigrid::Level {
  std::vector<Index> offsets, middles, columns;
  std::vector<float> values, inverseDiagonal;
  std::vector<Index> coarseOffsets, coarseColumns;  // the prolongation from the next level; empty on the last
  std::vector<float> coarseValues;
  std::vector<Pair> b, x;

  explicit Level(const SparseRows& a)
      : offsets(a.offsets),
        middles(a.middles),
        columns(a.columns),
        values(a.values.begin(), a.values.end()),
        inverseDiagonal(a.rows()),
        b(a.rows()),
        x(a.rows()) {
    for (std::size_t r = 0; r < a.rows(); ++r) {
      inverseDiagonal[r] = static_cast<float>(1 / a.diagonal[r]);
    }
  }

  void prolongBy(const Prolongation& p) {
    coarseOffsets = p.offsets;
    coarseColumns = p.columns;
    coarseValues.assign(p.values.begin(), p.values.end());
  }

  [[nodiscard]] std::size_t rows() const { return x.size(); }

  /// Subtracts the row's entries [begin, end) times x from (u, v).
  void subtract(Index begin, Index end, float& u, float& v) const {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      const Pair& other = x[static_cast<std::size_t>(columns[k])];
      u -= values[k] * other.u;
      v -= values[k] * other.v;
    }
  }

  /// A forward sweep from x = 0: the upper half of the matrix meets zeros.
  void sweepFromZero() {
    for (std::size_t r = 0; r < rows(); ++r) {
      auto [u, v] = b[r];
      subtract(offsets[r], middles[r], u, v);
      x[r] = {u * inverseDiagonal[r], v * inverseDiagonal[r]};
    }
  }

  void sweepForward() {
    for (std::size_t r = 0; r < rows(); ++r) {
      relax(r);
    }
  }

  void sweepBackward() {
    for (std::size_t r = rows(); r-- > 0;) {
      relax(r);
    }
  }

  void relax(std::size_t r) {
    auto [u, v] = b[r];
    subtract(offsets[r], offsets[r + 1], u, v);
    x[r] = {u * inverseDiagonal[r], v * inverseDiagonal[r]};
  }

  /// The residual after sweepFromZero(), for which only the upper half counts, restricted to `coarse`.
  void restrictTo(std::vector<Pair>& coarse) const {
    std::fill(coarse.begin(), coarse.end(), Pair{});
    for (std::size_t r = 0; r < rows(); ++r) {
      float u = 0;
      float v = 0;
      subtract(middles[r], offsets[r + 1], u, v);
      for (auto k = static_cast<std::size_t>(coarseOffsets[r]);
           k < static_cast<std::size_t>(coarseOffsets[r + 1]); ++k) {
        Pair& target = coarse[static_cast<std::size_t>(coarseColumns[k])];
        target.u += coarseValues[k] * u;
        target.v += coarseValues[k] * v;
      }
    }
  }

  void addFrom(const std::vector<Pair>& coarse) {
    for (std::size_t r = 0; r < rows(); ++r) {
      for (auto k = static_cast<std::size_t>(coarseOffsets[r]);
           k < static_cast<std::size_t>(coarseOffsets[r + 1]); ++k) {
        const Pair& source = coarse[static_cast<std::size_t>(coarseColumns[k])];
        x[r].u += coarseValues[k] * source.u;
        x[r].v += coarseValues[k] * source.v;
      }
    }
  }
};

Multigrid::Multigrid(const SparseRows& matrix, Interpolation interpolation) {
  levels_.emplace_back(matrix);
  SparseRows current;
  const SparseRows* finer = &matrix;
  while (finer->rows() > kDense) {
    const Prolongation p = aggregate(*finer, interpolation);
    if (static_cast<double>(p.coarseCount) > kPoorCoarsening * static_cast<double>(finer->rows())) {
      break;
    }
    levels_.back().prolongBy(p);
    current = coarseMatrix(*finer, p);
    finer = &current;
    levels_.emplace_back(current);
  }
  if (finer->rows() > kDense) {
    return;
  }
  const auto n = static_cast<Eigen::Index>(finer->rows());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index r = 0; r < n; ++r) {
    const auto row = static_cast<std::size_t>(r);
    dense(r, r) = finer->diagonal[row];
    for (auto k = static_cast<std::size_t>(finer->offsets[row]);
         k < static_cast<std::size_t>(finer->offsets[row + 1]); ++k) {
      dense(r, finer->columns[k]) = finer->values[k];
    }
  }
  coarsest_ = dense.partialPivLu().inverse().cast<float>();
}

Multigrid::~Multigrid() = default;
Multigrid::Multigrid(Multigrid&&) noexcept = default;
Multigrid& Multigrid::operator=(Multigrid&&) noexcept = default;

void Multigrid::cycle(std::size_t depth) {
  Level& level = levels_[depth];
  if (depth + 1 < levels_.size()) {
    level.sweepFromZero();
    level.restrictTo(levels_[depth + 1].b);
    cycle(depth + 1);
    level.addFrom(levels_[depth + 1].x);
    level.sweepBackward();
  } else if (coarsest_.size() > 0) {
    using Pairs = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;
    const auto n = static_cast<Eigen::Index>(level.rows());
    const Eigen::Map<const Pairs> b(&level.b[0].u, n, 2);
    Eigen::Map<Pairs>(&level.x[0].u, n, 2).noalias() = coarsest_ * b;
  } else {
    std::fill(level.x.begin(), level.x.end(), Pair{});
    for (int i = 0; i < kCoarsestSweeps; ++i) {
      level.sweepForward();
      level.sweepBackward();
    }
  }
}

void Multigrid::apply(std::span<const Point2> in, std::span<Point2> out) {
  Level& top = levels_.front();
  for (std::size_t r = 0; r < in.size(); ++r) {
    top.b[r] = {static_cast<float>(in[r].x()), static_cast<float>(in[r].y())};
  }
  cycle(0);
  for (std::size_t r = 0; r < out.size(); ++r) {
    out[r] = {top.x[r].u, top.x[r].v};
  }
}

}  // namespace graftsman
