#include "core/fusion/laplace_solver.h"

#include <cmath>

#include "core/fusion/multigrid.h"

namespace graftsman {
namespace {

/// Unknowns up to which a factorisation is as fast as the iteration: LDLᵀ, LU.
constexpr std::size_t kDirectSymmetric = 3000;
constexpr std::size_t kDirectUnsymmetric = 600;

/// A converging iteration needs 10 to 30 steps; one that has not converged after so many will not.
constexpr int kMostSteps = 150;

/// No preconditioned residual falls below this in doubles.
constexpr double kRounding = 1e-14;

/// A residual that stands for positions so far outside the unit circle is no longer going to shrink.
constexpr double kDiverged = 1e4;

/// A quantity of the systems for u and for v.
using Both = Eigen::Array2d;
using Vectors = std::vector<Point2>;

Both dot(const Vectors& a, const Vectors& b) {
  Both sum = Both::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i].array() * b[i].array();
  }
  return sum;
}

/// a / b, and 0 where b is 0: that system is solved.
Both quotient(const Both& a, const Both& b) {
  return {b.x() != 0 ? a.x() / b.x() : 0, b.y() != 0 ? a.y() / b.y() : 0};
}

/// out = A x; returns x · A x.
Both multiply(const SparseRows& a, const Vectors& x, Vectors& out) {
  Both product = Both::Zero();
  for (std::size_t r = 0; r < a.rows(); ++r) {
    Point2 sum = a.diagonal[r] * x[r];
    for (auto k = static_cast<std::size_t>(a.offsets[r]); k < static_cast<std::size_t>(a.offsets[r + 1]);
         ++k) {
      sum += a.values[k] * x[static_cast<std::size_t>(a.columns[k])];
    }
    out[r] = sum;
    product += sum.array() * x[r].array();
  }
  return product;
}

double rootMeanSquare(const Both& squares, std::size_t count) {
  return std::sqrt(squares.maxCoeff() / static_cast<double>(count));
}

}  // namespace

/// One run of a Krylov method; its vectors and the preconditioner live on between runs.
struct LaplaceSolver::Iteration {
  const LaplaceSystem& system;
  Multigrid preconditioner;
  Vectors r, z, p, q, s, t;

  explicit Iteration(const LaplaceSystem& of)
      : system(of),
        preconditioner(of.matrix,
                       of.kind == MatrixKind::Drifting ? Interpolation::Constant : Interpolation::Smoothed) {
    for (Vectors* v : {&r, &z, &p, &q}) {
      v->resize(of.rhs.size());
    }
    if (of.kind != MatrixKind::Symmetric) {
      s.resize(of.rhs.size());
      t.resize(of.rhs.size());
    }
  }

  Outcome conjugateGradients(Vectors& x, double tolerance, const Progress& progress);
  Outcome stabilisedBiconjugateGradients(Vectors& x, double tolerance, const Progress& progress);
};

LaplaceSolver::Outcome LaplaceSolver::Iteration::conjugateGradients(Vectors& x, double tolerance,
                                                                    const Progress& progress) {
  const std::size_t n = x.size();
  residual(system, x, r);
  preconditioner.apply(r, z);
  p = z;
  Both rz = dot(r, z);
  for (int step = 0; step < kMostSteps; ++step) {
    if (rootMeanSquare(dot(z, z), n) <= tolerance) {
      return Outcome::Solved;
    }
    if (!progress.keepGoing(step / 40.0)) {
      return Outcome::Cancelled;
    }
    const Both alpha = quotient(rz, multiply(system.matrix, p, q));
    for (std::size_t i = 0; i < n; ++i) {
      x[i].array() += alpha * p[i].array();
      r[i].array() -= alpha * q[i].array();
    }
    preconditioner.apply(r, z);
    // Polak & Ribière's form: it forgives the rounding of the single-precision preconditioner.
    const Both beta = -alpha * quotient(dot(q, z), rz);
    rz = dot(r, z);
    if (!(rz >= 0).all()) {
      return Outcome::Failed;
    }
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = z[i] + Point2(beta * p[i].array());
    }
  }
  return Outcome::Failed;
}

LaplaceSolver::Outcome LaplaceSolver::Iteration::stabilisedBiconjugateGradients(Vectors& x, double tolerance,
                                                                                const Progress& progress) {
  const std::size_t n = x.size();
  Vectors& shadow = z;
  Vectors& v = q;
  const auto apply = [&](const Vectors& in, Vectors& out) {
    multiply(system.matrix, in, out);
    preconditioner.apply(out, out);
  };
  Both rho = Both::Zero();
  Both alpha = Both::Ones();
  Both omega = Both::Ones();
  bool restart = true;
  for (int step = 0; step < kMostSteps; ++step) {
    if (restart) {
      residual(system, x, r);
      preconditioner.apply(r, r);
      if (rootMeanSquare(dot(r, r), n) <= tolerance) {
        return Outcome::Solved;
      }
      shadow = r;
      p = r;
      rho = dot(shadow, r);
    }
    if (!progress.keepGoing(step / 40.0)) {
      return Outcome::Cancelled;
    }
    apply(p, v);
    alpha = quotient(rho, dot(shadow, v));
    for (std::size_t i = 0; i < n; ++i) {
      s[i] = r[i] - Point2(alpha * v[i].array());
    }
    apply(s, t);
    omega = quotient(dot(t, s), dot(t, t));
    for (std::size_t i = 0; i < n; ++i) {
      x[i].array() += alpha * p[i].array() + omega * s[i].array();
      r[i] = s[i] - Point2(omega * t[i].array());
    }
    const Both rr = dot(r, r);
    if (!(rootMeanSquare(rr, n) < kDiverged)) {
      return Outcome::Failed;
    }
    const Both old = rho;
    rho = dot(shadow, r);
    const Both beta = quotient(rho, old) * quotient(alpha, omega);
    // Restart where the residual has become orthogonal to its shadow, and to measure the true residual.
    restart = rootMeanSquare(rr, n) <= tolerance || !(rho.abs() > 1e-14 * rr).all() || (beta == 0).any();
    for (std::size_t i = 0; i < n && !restart; ++i) {
      p[i] = r[i] + Point2(beta * (p[i].array() - omega * v[i].array()));
    }
  }
  return Outcome::Failed;
}

LaplaceSolver::LaplaceSolver(LaplaceSystem system, std::vector<Point2> start)
    : system_(std::move(system)), solution_(std::move(start)) {
  if (solution_.empty()) {
    solution_.assign(system_.rhs.size(), Point2::Zero());
  }
}

LaplaceSolver::~LaplaceSolver() = default;

LaplaceSolver::Outcome LaplaceSolver::solve(double tolerance, const Progress& progress) {
  if (exact_) {
    return Outcome::Exhausted;
  }
  const bool isSymmetric = system_.kind == MatrixKind::Symmetric;
  if (system_.rhs.size() <= (isSymmetric ? kDirectSymmetric : kDirectUnsymmetric)) {
    return factorise(progress);
  }
  if (!iteration_) {
    iteration_ = std::make_unique<Iteration>(system_);
  }
  const double reachable = std::max(tolerance, kRounding);
  if (isSymmetric) {
    const Outcome outcome = iteration_->conjugateGradients(solution_, reachable, progress);
    return outcome == Outcome::Failed ? factorise(progress) : outcome;
  }
  const std::vector<Point2> start = solution_;
  Outcome outcome = iteration_->stabilisedBiconjugateGradients(solution_, reachable, progress);
  if (outcome == Outcome::Failed && system_.kind == MatrixKind::NearlySymmetric) {
    system_.kind = MatrixKind::Drifting;
    iteration_ = std::make_unique<Iteration>(system_);
    solution_ = start;
    outcome = iteration_->stabilisedBiconjugateGradients(solution_, reachable, progress);
  }
  return outcome == Outcome::Failed ? factorise(progress) : outcome;
}

LaplaceSolver::Outcome LaplaceSolver::factorise(const Progress& progress) {
  if (!progress.keepGoing(0)) {
    return Outcome::Cancelled;
  }
  iteration_.reset();
  exact_ = true;
  std::vector<Point2> exact = solveDirectly(system_);
  if (exact.empty()) {
    return Outcome::Failed;
  }
  solution_ = std::move(exact);
  return progress.keepGoing(1) ? Outcome::Solved : Outcome::Cancelled;
}

}  // namespace graftsman
