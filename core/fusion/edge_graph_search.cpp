#include "core/fusion/edge_graph_search.h"

#include <algorithm>

#include "core/fusion/min_heap.h"
#include "core/fusion/zeroed_array.h"

namespace graftsman {
namespace {

// On the sample models, 1.5 visits a tenth of the vertices that 1 does, and the way, straightened, is still
// within a few percent of the shortest.
constexpr double kHaste = 1.5;
constexpr int kEdgesPerLook = 1024;

struct GraphNode {
  double distance;
  Index parent;
  bool reached;
  bool settled;
};

class EdgeGraphSearch {
 public:
  EdgeGraphSearch(const TriangleMesh& mesh, Index to)
      : mesh_(mesh), to_(to), nodes_(static_cast<std::size_t>(mesh.vertexCount())) {}

  std::vector<EdgePoint> run(Index from, const Progress& progress) {
    reach(from, 0, -1);
    int settled = 0;
    while (!heap_.empty()) {
      const Index v = heap_.pop().value;
      if (nodes_[v].settled) {
        continue;
      }
      nodes_[v].settled = true;
      if (v == to_) {
        return way();
      }
      if (++settled % kEdgesPerLook == 0 &&
          !progress.keepGoing(static_cast<double>(settled) / mesh_.vertexCount())) {
        return {};
      }
      leave(v);
    }
    return {};
  }

 private:
  void leave(Index v) {
    const Point& origin = mesh_.point(v);
    const double distance = nodes_[v].distance;
    const auto step = [&](Index w) {
      if (!nodes_[w].settled && !mesh_.singular(w)) {
        reach(w, distance + (mesh_.point(w) - origin).norm(), v);
      }
    };
    const Index first = mesh_.outgoing(v);
    for (Index h = first; h >= 0;) {
      step(mesh_.to(h));
      const Index last = TriangleMesh::prev(h);
      h = mesh_.twin(last);
      if (h < 0) {
        step(mesh_.from(last));
      }
      if (h == first) {
        break;
      }
    }
  }

  void reach(Index v, double distance, Index parent) {
    GraphNode& node = nodes_[v];
    if (!node.reached || distance < node.distance) {
      node = {distance, parent, true, false};
      heap_.push(distance + kHaste * (mesh_.point(v) - mesh_.point(to_)).norm(), v);
    }
  }

  std::vector<EdgePoint> way() const {
    std::vector<EdgePoint> points;
    for (Index v = to_; v >= 0; v = nodes_[v].parent) {
      points.push_back({v, -1, 0});
    }
    std::reverse(points.begin(), points.end());
    return points;
  }

  const TriangleMesh& mesh_;
  Index to_;
  ZeroedArray<GraphNode> nodes_;
  MinHeap heap_;
};

}  // namespace

std::vector<EdgePoint> quickWayAlongEdges(const TriangleMesh& mesh, Index from, Index to,
                                          const Progress& progress) {
  return EdgeGraphSearch(mesh, to).run(from, progress);
}

}  // namespace graftsman
