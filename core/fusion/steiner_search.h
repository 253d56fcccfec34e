#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/fusion/path_obstacles.h"
#include "core/fusion/zeroed_array.h"

namespace graftsman {

/// The graph that a search walks over: the mesh's vertices and edges, and additional points on edges. Two
/// points are joined if they lie in one face, and no obstacle between them.
struct SteinerGraph {
  int pointsPerEdge = 0;                     // additional points on an edge that no obstacle touches
  int pointsPerInterval = 0;                 // on each interval of an edge that one does
  const ZeroedArray<bool>* faces = nullptr;  // only these faces; null: all
};

/// The shortest way over the graph, without detours and loops; empty if there is none, or if cancelled. With
/// all faces and at least one point per interval there is one whenever the surface has one.
/// Source: Lanthier et al. 1997; A* with the straight distance.
[[nodiscard]] std::vector<EdgePoint> searchSteinerGraph(const TriangleMesh& mesh,
                                                        const PathObstacles& obstacles, Index from, Index to,
                                                        const SteinerGraph& graph, const Progress& progress);

}  // namespace graftsman
