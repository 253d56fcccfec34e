#include "core/fusion/path_refine.h"

#include "core/fusion/steiner_search.h"
#include "core/fusion/zeroed_array.h"

namespace graftsman {
namespace {

// A round that shortens the path by less than this part has settled: with the same points, the path has
// stopped moving; with twice the points, what is left is a third of the last gain (the error falls with the
// square of their distance), below a 1e-4 part, which nobody sees.
constexpr double kSettled = 1e-4;
// 1, 3, 7, 15 points an edge: a path that keeps to points 1/16 of an edge apart bends by about 1/16 at each
// edge at most, half a 1/16² part too long.
constexpr int kMostPointsPerEdge = 15;
// Up to so many points an edge the path may still move to other faces, so that their neighbours are searched,
// too; with more, it only settles in its own faces.
constexpr int kMostPointsOfWideSearch = 1;
// The path moves by about a face a round at first; past as many rounds as this it is not the same way.
constexpr int kMostRounds = 1000;

// The faces that the path touches; if wide, those at every vertex of these.
class FacesAround {
 public:
  explicit FacesAround(const TriangleMesh& mesh)
      : mesh_(mesh), marked_(static_cast<std::size_t>(mesh.faceCount())) {}

  const ZeroedArray<bool>& mark(const std::vector<EdgePoint>& points, bool wide) {
    for (const Index face : list_) {
      marked_[face] = false;
    }
    list_.clear();
    for (const EdgePoint& p : points) {
      if (p.isVertex()) {
        addFan(p.vertex);
      } else {
        add(TriangleMesh::faceOf(p.halfedge));
        add(TriangleMesh::faceOf(mesh_.twin(p.halfedge)));
      }
    }
    for (std::size_t i = 0, touched = wide ? list_.size() : 0; i < touched; ++i) {
      for (const Index v : mesh_.face(list_[i])) {
        if (!mesh_.singular(v)) {
          addFan(v);
        }
      }
    }
    return marked_;
  }

 private:
  void add(Index face) {
    if (!marked_[face]) {
      marked_[face] = true;
      list_.push_back(face);
    }
  }

  void addFan(Index v) {
    const Index first = mesh_.outgoing(v);
    for (Index h = first; h >= 0;) {
      add(TriangleMesh::faceOf(h));
      h = mesh_.twin(TriangleMesh::prev(h));
      if (h == first) {
        break;
      }
    }
  }

  const TriangleMesh& mesh_;
  ZeroedArray<bool> marked_;
  std::vector<Index> list_;
};

}  // namespace

std::vector<EdgePoint> refined(const TriangleMesh& mesh, const PathObstacles& obstacles,
                               std::vector<EdgePoint> points, const Progress& progress) {
  const Index from = points.front().vertex;
  const Index to = points.back().vertex;
  FacesAround around(mesh);
  double length = polylineLength(mesh, points);
  int round = 0;
  for (int perEdge = 1; perEdge <= kMostPointsPerEdge; perEdge = 2 * perEdge + 1) {
    const double lengthBefore = length;
    for (bool moving = true; moving && round < kMostRounds; ++round) {
      const SteinerGraph graph{perEdge, perEdge, &around.mark(points, perEdge <= kMostPointsOfWideSearch)};
      auto found = searchSteinerGraph(mesh, obstacles, from, to, graph, progress);
      const double foundLength = found.empty() ? length : polylineLength(mesh, found);
      moving = foundLength < length * (1 - kSettled);
      if (foundLength < length) {
        points = std::move(found);
        length = foundLength;
      }
      if (!progress.keepGoing(static_cast<double>(perEdge) / (2 * kMostPointsPerEdge))) {
        return points;
      }
    }
    if (perEdge > 1 && length > lengthBefore * (1 - kSettled)) {
      break;
    }
  }
  return points;
}

}  // namespace graftsman
