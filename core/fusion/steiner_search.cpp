#include "core/fusion/steiner_search.h"

#include <algorithm>

#include "core/fusion/min_heap.h"

namespace graftsman {
namespace {

constexpr int kPointsPerLook = 1024;

class SteinerSearch {
 public:
  SteinerSearch(const TriangleMesh& mesh, const PathObstacles& obstacles, Index to, const SteinerGraph& graph)
      : mesh_(mesh),
        obstacles_(obstacles),
        graph_(graph),
        to_(to),
        vertices_(static_cast<std::size_t>(mesh.vertexCount())),
        edgeSlots_(static_cast<std::size_t>(mesh.halfedgeCount())) {}

  std::vector<EdgePoint> run(Index from, const Progress& progress) {
    reach(from, 0, -1);
    int settled = 0;
    while (!heap_.empty()) {
      const Index x = heap_.pop().value;
      if (node(x).settled) {
        continue;
      }
      node(x).settled = true;
      if (x == to_) {
        return wayTo(x);
      }
      if (++settled % kPointsPerLook == 0 &&
          !progress.keepGoing(settled /
                              (2.0 * (mesh_.vertexCount() + static_cast<double>(points_.size()))))) {
        return {};
      }
      if (isVertex(x)) {
        leaveVertex(x);
      } else {
        leaveEdge(x);
      }
    }
    return {};
  }

 private:
  // Numbers below V are vertices, then come the additional points.
  struct Node {
    double distance;
    Index parent;
    bool reached;
    bool settled;
  };
  struct Range {
    Index first = 0;
    Index count = 0;
  };

  bool isVertex(Index x) const { return x < mesh_.vertexCount(); }
  Node& node(Index x) { return isVertex(x) ? vertices_[x] : added_[added(x)]; }
  std::size_t added(Index x) const { return static_cast<std::size_t>(x - mesh_.vertexCount()); }
  EdgePoint point(Index x) const { return isVertex(x) ? EdgePoint{x, -1, 0} : points_[added(x)]; }
  Point place(Index x) const { return isVertex(x) ? mesh_.point(x) : places_[added(x)]; }
  bool allowed(Index face) const { return !graph_.faces || (*graph_.faces)[face]; }

  void reach(Index x, double distance, Index parent) {
    Node& n = node(x);
    if (n.settled || (n.reached && n.distance <= distance)) {
      return;
    }
    n.distance = distance;
    n.parent = parent;
    n.reached = true;
    heap_.push(distance + (place(x) - mesh_.point(to_)).norm(), x);
  }

  void step(Index x, Index y) { reach(y, node(x).distance + (place(y) - place(x)).norm(), x); }

  void leaveVertex(Index v) {
    const Index first = mesh_.outgoing(v);
    for (Index h = first; h >= 0;) {
      const Index last = TriangleMesh::prev(h);
      if (allowed(TriangleMesh::faceOf(h))) {
        alongEdge(v, h, mesh_.to(h));
        alongEdge(v, last, mesh_.from(last));  // an edge may have one allowed face only
        toEdge(v, TriangleMesh::next(h));
      }
      h = mesh_.twin(last);
      if (h == first) {
        break;
      }
    }
  }

  void leaveEdge(Index x) {
    const Index edge = points_[added(x)].halfedge;
    for (const Index h : {edge, mesh_.twin(edge)}) {
      const Index face = TriangleMesh::faceOf(h);
      if (!allowed(face)) {
        continue;
      }
      const Index opposite = mesh_.from(TriangleMesh::prev(h));
      if (!obstacles_.blocked(opposite) && obstacles_.permitsIn(face, points_[added(x)], {opposite, -1, 0})) {
        step(x, opposite);
      }
      toEdge(x, TriangleMesh::next(h));
      toEdge(x, TriangleMesh::prev(h));
    }
  }

  void alongEdge(Index v, Index h, Index other) {
    if (!obstacles_.blocked(other) && obstacles_.permitsAlong(h)) {
      step(v, other);
    }
  }

  // To the additional points on another edge of the face of h.
  void toEdge(Index x, Index h) {
    const auto [first, count] = pointsOn(h);
    for (Index y = first; y < first + count; ++y) {
      if (obstacles_.permitsIn(TriangleMesh::faceOf(h), point(x), points_[added(y)])) {
        step(x, y);
      }
    }
  }

  // Makes the additional points of an edge when it is met first.
  Range pointsOn(Index h) {
    const Index edge = canonical(mesh_, h);
    if (mesh_.twin(edge) < 0) {
      return {};
    }
    const bool touched = obstacles_.touches(edge);
    const int count = touched ? graph_.pointsPerInterval : graph_.pointsPerEdge;
    if (count == 0) {
      return {};
    }
    Index& slot = edgeSlots_[edge];
    if (slot == 0) {
      Range range{mesh_.vertexCount() + static_cast<Index>(points_.size()), 0};
      for (const auto& interval : obstacles_.intervals(edge)) {
        for (int k = 1; k <= count; ++k) {
          const auto t = interval.inside(k / (count + 1.0));
          if (t && (range.count == 0 || points_.back().t < *t)) {
            points_.push_back({-1, edge, *t});
            places_.push_back(position(mesh_, points_.back()));
            added_.push_back({});
            ++range.count;
          }
        }
      }
      ranges_.push_back(range);
      slot = static_cast<Index>(ranges_.size());
    }
    return ranges_[static_cast<std::size_t>(slot) - 1];
  }

  std::vector<EdgePoint> wayTo(Index x) {
    std::vector<EdgePoint> way;
    for (; x >= 0; x = node(x).parent) {
      way.push_back(point(x));
    }
    std::reverse(way.begin(), way.end());
    way = withoutDetours(obstacles_, way);
    if (removeLoops(mesh_, way)) {
      way = withoutDetours(obstacles_, way);
    }
    return way;
  }

  const TriangleMesh& mesh_;
  const PathObstacles& obstacles_;
  const SteinerGraph& graph_;
  Index to_;
  ZeroedArray<Node> vertices_;
  ZeroedArray<Index> edgeSlots_;  // of each canonical halfedge, 1 + its entry in ranges_; 0: none yet
  std::vector<Range> ranges_;
  std::vector<EdgePoint> points_;
  std::vector<Point> places_;
  std::vector<Node> added_;
  MinHeap heap_;
};

}  // namespace

std::vector<EdgePoint> searchSteinerGraph(const TriangleMesh& mesh, const PathObstacles& obstacles,
                                          Index from, Index to, const SteinerGraph& graph,
                                          const Progress& progress) {
  return SteinerSearch(mesh, obstacles, to, graph).run(from, progress);
}

}  // namespace graftsman
