#include "core/fusion/harmonic_extension.h"

#include <algorithm>
#include <string>

#include "core/fusion/embedding_tile.h"
#include "core/fusion/embedding_weights.h"
#include "core/fusion/laplace_solver.h"

namespace graftsman {
namespace {

// Of the greatest boundary value: a ten-millionth of a correction that is itself small.
constexpr double kTolerance = 1e-7;

// Components `first` and `second` of the extension's interior values; false if cancelled.
bool solvePair(const Stars& stars, const SlotWeights& weights, std::span<const Eigen::Vector3d> boundary,
               double unit, int first, int second, const Progress& progress,
               std::span<Eigen::Vector3d> interior) {
  std::vector<Point2> values;
  values.reserve(boundary.size());
  for (const Eigen::Vector3d& value : boundary) {
    values.emplace_back(value[first] / unit, value[second] / unit);
  }
  LaplaceSolver solver(laplaceSystem(stars, weights, values, MatrixKind::Symmetric));
  if (solver.solve(kTolerance, progress) == LaplaceSolver::Outcome::Cancelled) {
    return false;
  }
  const std::vector<Point2>& solution = solver.solution();
  for (std::size_t i = 0; i < interior.size() && i < solution.size(); ++i) {
    if (solution[i].allFinite()) {
      interior[i][first] = unit * solution[i].x();
      interior[i][second] = unit * solution[i].y();
    }
  }
  return true;
}

}  // namespace

Result<std::vector<Eigen::Vector3d>> extendHarmonically(std::span<const Point> points,
                                                        std::span<const Face> faces,
                                                        std::span<const Eigen::Vector3d> boundary,
                                                        const Progress& progress) {
  const auto bad = std::find_if(points.begin(), points.end(), [](const Point& p) { return !p.allFinite(); });
  if (bad != points.end()) {
    return fail(ErrorCode::EmbeddingFailed,
                "Vertex " + std::to_string(bad - points.begin()) +
                    " of the region has a coordinate that is no number. Repair the model.");
  }
  std::vector<Eigen::Vector3d> values(boundary.begin(), boundary.end());
  values.resize(points.size(), Eigen::Vector3d::Zero());
  double unit = 0;
  for (const Eigen::Vector3d& value : boundary) {
    unit = std::max(unit, value.cwiseAbs().maxCoeff());
  }
  if (unit == 0 || points.size() == boundary.size()) {
    return values;
  }
  const EmbeddingTile tile = prepareTile(points, faces, static_cast<Index>(boundary.size()));
  const Stars stars = gatherStars(tile);
  const SlotWeights weights = cotangentWeights(tile, stars);
  const auto interior = std::span(values).subspan(boundary.size());
  if (!progress.keepGoing(0.2) ||
      !solvePair(stars, weights, boundary, unit, 0, 1, progress.span(0.2, 0.6), interior) ||
      !solvePair(stars, weights, boundary, unit, 2, 2, progress.span(0.6, 1), interior)) {
    return fail(ErrorCode::Cancelled, "The adjustment was cancelled.");
  }
  return values;
}

}  // namespace graftsman
