#include "core/fusion/loop_router.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "core/fusion/path_obstacles.h"
#include "core/fusion/path_refine.h"
#include "core/fusion/path_straighten.h"
#include "core/fusion/steiner_search.h"

namespace graftsman {
namespace {

// Points on each interval of an edge beside obstacles: enough to choose between its ends and its middle; how
// the path runs in the strip is found afterwards.
constexpr int kPointsPerInterval = 3;
// A way round that is longer than the direct path by this factor is not what the person drew: perhaps the
// other path can give way more cheaply.
constexpr double kLongWay = 1.25;
// Attempts that only look for a shorter total.
constexpr int kMostImprovements = 3;
// While none has succeeded, a path may come to the front so often. On a disk with CVs on its border, the only
// case where attempts fail although there is a way, that found it in all of a thousand random loops.
constexpr int kMostPromotions = 4;

using PathPtr = std::shared_ptr<const Path>;

class Router {
 public:
  Router(const TriangleMesh& mesh, const std::vector<Index>& cvs, const std::vector<PathPtr>& direct,
         PathMode mode, const Progress& progress)
      : mesh_(mesh), cvs_(cvs), direct_(direct), mode_(mode), progress_(progress) {}

  RoutedLoop run() {
    RoutedLoop result = bestAttempt(false);
    if (result.paths.empty() && !progress_.cancelled()) {
      RoutedLoop offBorder = bestAttempt(true);
      if (!offBorder.paths.empty()) {
        return offBorder;
      }
    }
    return result;
  }

 private:
  struct Attempt {
    RoutedLoop loop;
    double total = 0;
    int worst = -1;  // the path that went the longest way round for its length, if a long one
  };

  // From the shortest to the longest. Off the border, those come last of which one in each chain from border
  // CV to border CV closes that chain: the others never part the surface, and with all CVs then tied to the
  // border by them, a closing one parts only what must be parted. So on a disk a way is found if there is
  // one.
  std::vector<int> settlingOrder(bool keepOffBorder) const {
    std::vector<int> order(direct_.size());
    std::iota(order.begin(), order.end(), 0);
    const auto length = [&](int i) { return direct_[static_cast<std::size_t>(i)]->length; };
    const std::vector<bool> closing = keepOffBorder ? closingPaths() : std::vector<bool>(order.size(), false);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      const bool aLast = closing[static_cast<std::size_t>(a)];
      const bool bLast = closing[static_cast<std::size_t>(b)];
      return aLast != bLast ? bLast : length(a) < length(b);
    });
    return order;
  }

  // The longest path between each two consecutive border CVs.
  std::vector<bool> closingPaths() const {
    const std::size_t n = cvs_.size();
    std::vector<bool> closing(n, false);
    const auto onBorder = [&](std::size_t i) { return mesh_.onBorder(cvs_[i % n]); };
    for (std::size_t i = 0; i < n; ++i) {
      if (!onBorder(i)) {
        continue;
      }
      std::size_t longest = i;
      for (std::size_t k = i + 1; !onBorder(k); ++k) {
        longest = direct_[k % n]->length > direct_[longest]->length ? k % n : longest;
      }
      closing[longest] = true;
    }
    return closing;
  }

  RoutedLoop bestAttempt(bool keepOffBorder) {
    std::vector<int> order = settlingOrder(keepOffBorder);
    std::vector<int> promotions(order.size(), 0);
    RoutedLoop best;
    RoutedLoop firstFailure;
    double bestTotal = std::numeric_limits<double>::infinity();
    for (int improvements = 0; improvements <= kMostImprovements;) {
      Attempt attempt = route(order, keepOffBorder);
      if (progress_.cancelled()) {
        return {};
      }
      int promote = attempt.loop.failed;
      if (promote < 0) {
        ++improvements;
        promote = attempt.worst;
        if (attempt.total < bestTotal) {
          bestTotal = attempt.total;
          best = std::move(attempt.loop);
        }
      } else if (firstFailure.failed < 0) {
        firstFailure = attempt.loop;
      }
      const int most = best.paths.empty() ? kMostPromotions : 1;
      if (promote < 0 || promotions[static_cast<std::size_t>(promote)] >= most) {
        break;
      }
      ++promotions[static_cast<std::size_t>(promote)];
      const auto at = std::find(order.begin(), order.end(), promote);
      std::rotate(order.begin(), at, at + 1);
    }
    return best.paths.empty() ? firstFailure : best;
  }

  Attempt route(const std::vector<int>& order, bool keepOffBorder) {
    PathObstacles obstacles(mesh_, keepOffBorder);
    for (std::size_t i = 0; i < cvs_.size(); ++i) {
      obstacles.addCv(cvs_[i], static_cast<int>(i));
    }
    Attempt attempt;
    attempt.loop.paths.resize(order.size());
    double worstFactor = kLongWay;
    for (const int i : order) {
      PathPtr path = direct_[static_cast<std::size_t>(i)];
      const Index from = path->points.front().vertex;
      const Index to = path->points.back().vertex;
      obstacles.setEnds(from, to);
      if (const auto conflict = obstacles.conflict(path->points)) {
        path = pathAround(mesh_, obstacles, from, to, mode_, progress_);
        assert(!path || !obstacles.conflict(path->points));
        if (!path || obstacles.conflict(path->points)) {
          attempt.loop = {{}, i, conflict->path, conflict->cv};
          return attempt;
        }
        const double factor = path->length / direct_[static_cast<std::size_t>(i)]->length;
        if (factor > worstFactor) {
          worstFactor = factor;
          attempt.worst = i;
        }
      }
      obstacles.addPath(path->points, i);
      attempt.total += path->length;
      attempt.loop.paths[static_cast<std::size_t>(i)] = std::move(path);
    }
    return attempt;
  }

  const TriangleMesh& mesh_;
  const std::vector<Index>& cvs_;
  const std::vector<PathPtr>& direct_;
  PathMode mode_;
  const Progress& progress_;
};

}  // namespace

std::shared_ptr<const Path> pathAround(const TriangleMesh& mesh, PathObstacles& obstacles, Index from,
                                       Index to, PathMode mode, const Progress& progress) {
  obstacles.setEnds(from, to);
  auto points = searchSteinerGraph(mesh, obstacles, from, to, {0, kPointsPerInterval}, progress);
  if (points.empty()) {
    return nullptr;
  }
  points = mode == PathMode::Paper ? refined(mesh, obstacles, std::move(points), progress)
                                   : straightened(mesh, obstacles, std::move(points));
  if (progress.cancelled()) {
    return nullptr;
  }
  const double length = polylineLength(mesh, points);
  return std::make_shared<Path>(Path{std::move(points), length});
}

RoutedLoop routeLoop(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                     const std::vector<std::shared_ptr<const Path>>& direct, PathMode mode,
                     const Progress& progress) {
  return Router(mesh, cvs, direct, mode, progress).run();
}

}  // namespace graftsman
