#pragma once

#include <memory>
#include <vector>

#include "core/fusion/path_obstacles.h"
#include "core/fusion/paths.h"

namespace graftsman {

/// A loop's paths made a simple closed curve, or why that failed.
struct RoutedLoop {
  std::vector<std::shared_ptr<const Path>> paths;  // n; empty if it failed
  int failed = -1;                                 // the path that found no way round …
  int otherPath = -1;                              // … this path, or
  int otherCv = -1;                                // … this CV; −1 where it is neither
};

/// Makes direct paths give way to each other. Paths are settled from the shortest to the longest; one that
/// meets a settled path or a foreign CV is led round all of them. A path that finds no way, or only a long
/// one, is settled earlier in another attempt; the attempt with the least total length counts. Where no
/// attempt succeeds, they are repeated with all paths kept off the mesh's border, which paths along it cut in
/// two. On a connected closed surface there always is a way but for the fineness of doubles. Empty and
/// without `failed` if cancelled.
[[nodiscard]] RoutedLoop routeLoop(const TriangleMesh& mesh, const std::vector<Index>& cvs,
                                   const std::vector<std::shared_ptr<const Path>>& direct, PathMode mode,
                                   const Progress& progress);

/// A path from `from` to `to` off all obstacles; null if there is none or if cancelled.
[[nodiscard]] std::shared_ptr<const Path> pathAround(const TriangleMesh& mesh, PathObstacles& obstacles,
                                                     Index from, Index to, PathMode mode,
                                                     const Progress& progress);

}  // namespace graftsman
