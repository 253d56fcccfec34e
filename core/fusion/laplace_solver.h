#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/fusion/laplace_system.h"

namespace graftsman {

/// Solves a LaplaceSystem, for u and v together, as exactly as asked for. Small systems are factorised; large
/// ones iterate with a multigrid preconditioner (conjugate gradients, or BiCGSTAB where the matrix is not
/// symmetric), and are factorised only where that does not converge. Deterministic.
class LaplaceSolver {
 public:
  enum class Outcome {
    Solved,     // the solution is as exact as asked for
    Exhausted,  // it is as exact as doubles allow; asking for more will not change it
    Failed,     // the matrix is singular in doubles
    Cancelled
  };

  /// start: N×2, where the iteration begins; empty for the origin.
  explicit LaplaceSolver(LaplaceSystem system, std::vector<Point2> start = {});
  ~LaplaceSolver();

  /// Continues until the solution's error is about `tolerance` (root mean square, unit circle).
  [[nodiscard]] Outcome solve(double tolerance, const Progress& progress);

  /// N×2.
  [[nodiscard]] const std::vector<Point2>& solution() const { return solution_; }

 private:
  Outcome factorise(const Progress& progress);

  struct Iteration;
  LaplaceSystem system_;
  std::vector<Point2> solution_;
  std::unique_ptr<Iteration> iteration_;
  bool exact_ = false;
};

/// The solution by a sparse factorisation: LDLᵀ if symmetric, otherwise LU; empty if it breaks down.
[[nodiscard]] std::vector<Point2> solveDirectly(const LaplaceSystem& system);

}  // namespace graftsman
