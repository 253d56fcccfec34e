#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include "core/fusion/laplace_solver.h"

namespace graftsman {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

Matrix eigenMatrix(const SparseRows& a) {
  const auto n = static_cast<Eigen::Index>(a.rows());
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows(n, n);
  std::vector<Index> sizes(a.rows());
  for (std::size_t r = 0; r < a.rows(); ++r) {
    sizes[r] = a.offsets[r + 1] - a.offsets[r] + 1;
  }
  rows.reserve(sizes);
  for (std::size_t r = 0; r < a.rows(); ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    rows.insert(row, row) = a.diagonal[r];
    for (auto k = static_cast<std::size_t>(a.offsets[r]); k < static_cast<std::size_t>(a.offsets[r + 1]);
         ++k) {
      rows.insert(row, a.columns[k]) = a.values[k];
    }
  }
  rows.makeCompressed();
  return rows;
}

template <class Factorisation>
Columns solveWith(const Matrix& matrix, const Columns& rhs) {
  Factorisation factorisation(matrix);
  return factorisation.info() == Eigen::Success ? Columns(factorisation.solve(rhs)) : Columns(0, 2);
}

}  // namespace

std::vector<Point2> solveDirectly(const LaplaceSystem& system) {
  const Matrix matrix = eigenMatrix(system.matrix);
  Columns rhs(matrix.rows(), 2);
  for (std::size_t r = 0; r < system.rhs.size(); ++r) {
    rhs.row(static_cast<Eigen::Index>(r)) = system.rhs[r];
  }
  const Columns solution = system.kind == MatrixKind::Symmetric
                               ? solveWith<Eigen::SimplicialLDLT<Matrix>>(matrix, rhs)
                               : solveWith<Eigen::SparseLU<Matrix>>(matrix, rhs);
  std::vector<Point2> out(static_cast<std::size_t>(solution.rows()));
  for (std::size_t r = 0; r < out.size(); ++r) {
    out[r] = solution.row(static_cast<Eigen::Index>(r));
    if (!out[r].allFinite()) {
      return {};
    }
  }
  return out;
}

}  // namespace graftsman
