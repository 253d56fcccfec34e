#include "core/fusion/embedding_layout.h"

#include <algorithm>

#include "core/fusion/embedding_mend.h"
#include "core/fusion/laplace_solver.h"

namespace graftsman {
namespace {

/// Errors of the positions in the unit circle, tried until the signs of all faces are right. The first is
/// far below what shows on a model; the last is about what doubles hold.
constexpr double kTolerances[] = {1e-6, 1e-9, 1e-13};

}  // namespace

std::optional<Layout> layOut(const LayoutProblem& problem, const SlotWeights& weights, MatrixKind kind,
                             std::span<const Point2> start, Effort effort, const Progress& progress) {
  const auto boundarySize = static_cast<std::ptrdiff_t>(problem.boundary.size());
  std::vector<Point2> interior;
  if (!start.empty()) {
    interior.assign(start.begin() + boundarySize, start.end());
  }
  LaplaceSolver solver(laplaceSystem(problem.stars, weights, problem.boundary, kind), std::move(interior));
  Layout layout;
  layout.uv.assign(problem.boundary.begin(), problem.boundary.end());
  layout.uv.resize(problem.tile.points.size());
  double done = 0.1;
  for (const double tolerance : kTolerances) {
    const auto outcome = solver.solve(tolerance, progress.span(done, done + 0.3));
    done += 0.3;
    if (outcome == LaplaceSolver::Outcome::Cancelled || !progress.keepGoing(done)) {
      return {};
    }
    if (outcome == LaplaceSolver::Outcome::Exhausted) {
      break;
    }
    std::copy(solver.solution().begin(), solver.solution().end(), layout.uv.begin() + boundarySize);
    layout.check = checkLayout(problem.tile, layout.uv, problem.sides);
    if (layout.check.valid() || outcome == LaplaceSolver::Outcome::Failed ||
        (effort == Effort::Decide && layout.check.squeezes())) {
      break;
    }
  }
  if (!layout.check.valid() && mendLayout(problem.tile, problem.stars, layout.check.badFaces, layout.uv)) {
    const Index flipped = layout.check.flippedFaces;
    layout.check = checkLayout(problem.tile, layout.uv, problem.sides);
    layout.check.flippedFaces = flipped;
  }
  return layout;
}

}  // namespace graftsman
