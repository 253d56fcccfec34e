#include "core/fusion/paths.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/base/parallel.h"
#include "core/fusion/edge_graph_search.h"
#include "core/fusion/loop_router.h"
#include "core/fusion/path_obstacles.h"
#include "core/fusion/path_straighten.h"
#include "core/fusion/wavefront.h"
#include "core/fusion/window_search.h"

namespace graftsman {
namespace {

using PathPtr = std::shared_ptr<const Path>;

// The share of the work that the direct paths are; the rest is leading them round each other.
constexpr double kDirectShare = 0.7;
// The bound need not be straightened further once a round gains less than this part.
constexpr double kRoughRounds = 2e-3;
// What is longer than the best by no more than this part may still become shorter when straightened to the
// end.
constexpr double kHopeful = 0.01;
// So coarse a mesh shapes the wavefront with its few triangles; the exact search is as good as free there.
constexpr Index kFewVertices = 1500;
// The exact search gives up after so many windows: about a second. A search that finds its goal needs fewer
// than ten a vertex on the sample models.
constexpr std::size_t kWindowsPerVertex = 16;
constexpr std::size_t kLeastWindows = 50'000;
constexpr std::size_t kMostWindows = 2'000'000;
// It looks only for paths that are shorter by this part, a tenth of what the wavefront is trusted for.
constexpr double kWorthWindows = 1e-4;

tl::unexpected<Error> pathsCancelled() {
  return fail(ErrorCode::Cancelled, "The search for the paths was cancelled.");
}

PathPtr makePath(const TriangleMesh& mesh, std::vector<EdgePoint> points) {
  const double length = polylineLength(mesh, points);
  return std::make_shared<Path>(Path{std::move(points), length});
}

bool neighbours(const TriangleMesh& mesh, Index a, Index b) {
  return mesh.halfedgeBetween(a, b) >= 0 || mesh.halfedgeBetween(b, a) >= 0;
}

// Keeps the shortest of the ways, each straightened.
class BestPath {
 public:
  BestPath(const TriangleMesh& mesh, const PathObstacles& obstacles) : mesh_(mesh), obstacles_(obstacles) {}

  void offer(const std::vector<EdgePoint>& way) {
    auto points = straightened(mesh_, obstacles_, withoutDetours(obstacles_, way));
    const double length = polylineLength(mesh_, points);
    if (length < length_) {
      length_ = length;
      points_ = std::move(points);
    }
  }

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] PathPtr path() const { return std::make_shared<Path>(Path{points_, length_}); }

 private:
  const TriangleMesh& mesh_;
  const PathObstacles& obstacles_;
  std::vector<EdgePoint> points_;
  double length_ = std::numeric_limits<double>::infinity();
};

// A quick way gives a bound, within it the wavefront finds ways that may be the shortest, and where that is
// not to be trusted, windows find the shortest itself.
PathPtr straightenedPath(const TriangleMesh& mesh, PathObstacles& obstacles, Index from, Index to,
                         const Progress& progress) {
  BestPath best(mesh, obstacles);
  const auto quick = quickWayAlongEdges(mesh, from, to, progress.span(0, 0.2));
  if (progress.cancelled()) {
    return nullptr;
  }
  if (quick.empty()) {
    return pathAround(mesh, obstacles, from, to, PathMode::Straightened, progress);
  }
  const auto rough = straightened(mesh, obstacles, withoutDetours(obstacles, quick), kRoughRounds);
  const double bound = polylineLength(mesh, rough);
  const auto found = waysByWavefront(mesh, from, to, bound, progress.span(0.2, 0.7));
  for (const auto& way : found.ways) {
    best.offer(way);
  }
  if (bound < best.length() * (1 + kHopeful)) {
    best.offer(rough);
  }
  if (found.elongated || mesh.vertexCount() <= kFewVertices) {
    const std::size_t budget = std::clamp(kWindowsPerVertex * static_cast<std::size_t>(mesh.vertexCount()),
                                          kLeastWindows, kMostWindows);
    const auto way =
        shortestByWindows(mesh, from, to, best.length() * (1 - kWorthWindows), budget, progress.span(0.7, 1));
    if (!way.empty()) {
      best.offer(way);
    }
  }
  return progress.cancelled() ? nullptr : best.path();
}

std::string arrow(std::size_t i, std::size_t n) {
  return std::to_string(i) + " → " + std::to_string((i + 1) % n);
}

Error impossible(Side side, std::size_t i, std::size_t n) {
  const std::size_t next = (i + 1) % n;
  return {ErrorCode::PathImpossible,
          "No path on the " + std::string(name(side)) + " leads from CV " + std::to_string(i) + " to CV " +
              std::to_string(next) + ": they lie on different components. Move one of them to the other's.",
          side,
          {static_cast<int>(i), static_cast<int>(next)},
          {static_cast<int>(i)}};
}

Error crossing(Side side, const RoutedLoop& loop, std::size_t n) {
  const auto i = static_cast<std::size_t>(loop.failed);
  const int next = static_cast<int>((i + 1) % n);
  Error error{ErrorCode::PathsCross, "Path " + arrow(i, n), side, {loop.failed, next}, {loop.failed}};
  if (loop.otherPath >= 0) {
    const auto other = static_cast<std::size_t>(loop.otherPath);
    error.message += " crosses path " + arrow(other, n);
    error.paths.push_back(loop.otherPath);
    for (const int cv : {loop.otherPath, static_cast<int>((other + 1) % n)}) {
      if (std::find(error.cvs.begin(), error.cvs.end(), cv) == error.cvs.end()) {
        error.cvs.push_back(cv);
      }
    }
  } else {
    error.message += " passes CV " + std::to_string(loop.otherCv);
    error.cvs.push_back(loop.otherCv);
  }
  error.message += " on the " + std::string(name(side)) + " and there is no way round. Move CV " +
                   std::to_string(next) + " or insert a pair between them.";
  return error;
}

// The previous direct path from a to b, if there is one.
PathPtr previousDirect(const LoopPaths* previous, const std::vector<Index>& previousCvs, Index a, Index b) {
  const std::size_t n = previous ? std::min(previousCvs.size(), previous->direct.size()) : 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (previousCvs[i] == a && previousCvs[(i + 1) % n] == b) {
      return previous->direct[i];
    }
  }
  return nullptr;
}

Result<std::vector<PathPtr>> directPaths(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                                         PathMode mode, Side side, const LoopPaths* previous,
                                         const std::vector<Index>& previousCvs, const Progress& progress) {
  const std::size_t n = cvs.size();
  std::vector<PathPtr> direct(n);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < n; ++i) {
    direct[i] = previousDirect(previous, previousCvs, cvs[i], cvs[(i + 1) % n]);
    if (!direct[i]) {
      missing.push_back(i);
    }
  }
  std::vector<std::optional<Error>> errors(n);
  std::atomic<std::size_t> done = 0;
  parallelFor(missing.size(), [&](std::size_t k) {
    if (progress.cancelled()) {
      return;
    }
    const std::size_t i = missing[k];
    const double count = static_cast<double>(missing.size());
    const Progress part =
        progress.span(static_cast<double>(done) / count, (static_cast<double>(done) + 1) / count);
    auto path = findPath(mesh, cvs[i], cvs[(i + 1) % n], mode, part);
    if (path) {
      direct[i] = std::move(*path);
    } else if (path.error().code == ErrorCode::PathImpossible) {
      errors[i] = impossible(side, i, n);
    }
    ++done;
    (void)progress.keepGoing(static_cast<double>(done) / count);
  });
  if (progress.cancelled()) {
    return pathsCancelled();
  }
  for (auto& error : errors) {
    if (error) {
      return fail(std::move(*error));
    }
  }
  return direct;
}

// Independent of the order in which the paths were settled.
[[maybe_unused]] bool isSimple(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                               const std::vector<PathPtr>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    PathObstacles others(mesh);
    for (std::size_t j = 0; j < paths.size(); ++j) {
      others.addCv(cvs[j], static_cast<int>(j));
      if (j != i) {
        others.addPath(paths[j]->points, static_cast<int>(j));
      }
    }
    if (others.conflict(paths[i]->points)) {
      return false;
    }
  }
  return true;
}

}  // namespace

Result<PathPtr> findPath(const TriangleMesh& mesh, Index from, Index to, PathMode mode,
                         const Progress& progress) {
  assert(from != to);
  PathPtr path;
  if (!mesh.singular(from) && !mesh.singular(to)) {
    if (!progress.keepGoing(0)) {
      return pathsCancelled();
    }
    if (neighbours(mesh, from, to)) {
      return makePath(mesh, {{from, -1, 0}, {to, -1, 0}});
    }
    PathObstacles obstacles(mesh);
    path = mode == PathMode::Paper ? pathAround(mesh, obstacles, from, to, mode, progress)
                                   : straightenedPath(mesh, obstacles, from, to, progress);
  }
  if (progress.cancelled()) {
    return pathsCancelled();
  }
  if (!path) {
    return fail(ErrorCode::PathImpossible,
                "No path leads from vertex " + std::to_string(from) + " to vertex " + std::to_string(to) +
                    ": they lie on different components. Pick both on the same one.");
  }
  return path;
}

Result<std::shared_ptr<const LoopPaths>> findPaths(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                                                   PathMode mode, Side side, const LoopPaths* previous,
                                                   const std::vector<Index>& previousCvs,
                                                   const Progress& progress) {
  const std::size_t n = cvs.size();
  assert(n >= 3);
  auto direct = directPaths(mesh, cvs, mode, side, previous, previousCvs, progress.span(0, kDirectShare));
  if (!direct) {
    return fail(std::move(direct.error()));
  }
  if (previous && previous->direct == *direct) {
    return std::make_shared<const LoopPaths>(*previous);
  }
  const RoutedLoop routed = routeLoop(mesh, cvs, *direct, mode, progress.span(kDirectShare, 1));
  if (progress.cancelled() || !progress.keepGoing(1)) {
    return pathsCancelled();
  }
  if (routed.paths.empty()) {
    return fail(crossing(side, routed, n));
  }
  assert(isSimple(mesh, cvs, routed.paths));
  return std::make_shared<const LoopPaths>(LoopPaths{std::move(*direct), routed.paths});
}

}  // namespace graftsman
