#include "core/fusion/wavefront.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fusion/min_heap.h"
#include "core/fusion/zeroed_array.h"

namespace graftsman {
namespace {

// A candidate's estimated length may exceed the least by this part: more than the error of the wavefront
// (below 1 % on models of everyday quality), so that the shortest way is among the candidates.
constexpr double kSpread = 0.02;
// So many candidates are straightened: past these, none was ever the shortest on the sample models.
constexpr std::size_t kMostWays = 6;
// A distance is corrected only if it falls by more than this part; less is rounding, and would go on for long.
constexpr double kSmallestCorrection = 1e-7;
constexpr int kProgressInterval = 1024;

struct Node {
  double distance;
  Index parent;       // the neighbour through or past which the distance came
  std::int32_t state;  // 0 untouched, 1 open, 2 settled
};

class Front {
 public:
  Front(const TriangleMesh& mesh, Index source)
      : mesh_(mesh), nodes_(static_cast<std::size_t>(mesh.vertexCount())) {
    nodes_[source] = {0, -1, 1};
    heap_.push(0, source);
  }

  [[nodiscard]] const Node& node(Index v) const { return nodes_[v]; }

  // The radius up to which everything is settled.
  [[nodiscard]] double radius() {
    while (!heap_.empty() && stale(heap_.top())) {
      heap_.pop();
    }
    return heap_.empty() ? std::numeric_limits<double>::infinity() : heap_.top().key;
  }

  // Settles the next vertex. Precondition: radius() is finite.
  Index settle() {
    const Index v = heap_.pop().value;
    nodes_[v].state = 2;
    const Index first = mesh_.outgoing(v);
    for (Index h = first; h >= 0;) {
      const Index last = TriangleMesh::prev(h);
      spread(v, h, last);
      h = mesh_.twin(last);
      if (h == first) {
        break;
      }
    }
    return v;
  }

  [[nodiscard]] std::vector<Index> chainFrom(Index v) const {
    std::vector<Index> chain;
    for (; v >= 0; v = nodes_[v].parent) {
      chain.push_back(v);
    }
    return chain;
  }

 private:
  [[nodiscard]] bool stale(const MinHeap::Entry& entry) const {
    const Node& node = nodes_[entry.value];
    return node.state == 2 || node.distance != entry.key;
  }

  void lower(Index v, double distance, Index parent) {
    Node& node = nodes_[v];
    if (node.state != 0 && !(distance < node.distance * (1 - kSmallestCorrection))) {
      return;
    }
    node = {distance, parent, 1};
    heap_.push(distance, v);
  }

  // From the settled v into the face between its halfedges h (outgoing) and last (incoming), and past the
  // opposite edge's ends.
  void spread(Index v, Index h, Index last) {
    const Index a = mesh_.to(h);
    const Index b = mesh_.from(last);
    const double dv = nodes_[v].distance;
    const Point& origin = mesh_.point(v);
    const Point va = mesh_.point(a) - origin;
    const Point vb = mesh_.point(b) - origin;
    if (!mesh_.singular(a)) {
      lower(a, dv + va.norm(), v);
    }
    if (mesh_.singular(b)) {
      return;
    }
    if (mesh_.twin(last) < 0) {
      lower(b, dv + vb.norm(), v);
    }
    if (nodes_[a].state == 2) {
      through(v, a, b, va, vb);
    }
    if (nodes_[b].state == 2 && !mesh_.singular(a)) {
      through(v, b, a, vb, va);
    }
  }

  // Updates c from the settled a and b: their distances put the source in the plane of the triangle, on the
  // other side of a–b; ab and ac are vectors from a.
  void through(Index a, Index b, Index c, const Point& ab, const Point& ac) {
    const double da = nodes_[a].distance;
    const double db = nodes_[b].distance;
    const double dc = nodes_[c].state == 0 ? std::numeric_limits<double>::infinity() : nodes_[c].distance;
    if (std::min(da, db) >= dc) {
      return;
    }
    const double base2 = ab.squaredNorm();
    if (base2 == 0) {
      return;
    }
    const double base = std::sqrt(base2);
    const double sx = (da * da - db * db + base2) / (2 * base);
    const double sy2 = da * da - sx * sx;
    const double cx = ab.dot(ac) / base;
    const double cy2 = ac.squaredNorm() - cx * cx;
    if (!(sy2 > 0) || !(cy2 > 0)) {
      return;
    }
    const double sy = std::sqrt(sy2);
    const double cy = std::sqrt(cy2);
    const double x = sx * cy + cx * sy;  // where the ray passes a–b, times (sy + cy)
    if (x <= 0 || x >= base * (sy + cy)) {
      return;
    }
    // A parent is always nearer than its child, so that chains end, even where distances are corrected later.
    const double distance = std::sqrt((cx - sx) * (cx - sx) + (cy + sy) * (cy + sy));
    if (distance > std::min(da, db)) {
      const Index nearer = da < db ? a : b;
      const Index besideRay = x < base * (sy + cy) / 2 ? a : b;
      lower(c, distance, nodes_[besideRay].distance < distance ? besideRay : nearer);
    }
  }

  const TriangleMesh& mesh_;
  ZeroedArray<Node> nodes_;
  MinHeap heap_;
};

class Meeting {
 public:
  Meeting(const TriangleMesh& mesh, Index from, Index to) : mesh_(mesh), fronts_{{mesh, from}, {mesh, to}} {}

  bool run(const Progress& progress) {
    int settled = 0;
    for (;;) {
      const double r0 = fronts_[0].radius();
      const double r1 = fronts_[1].radius();
      if (!(r0 + r1 < best_ * (1 + kSpread))) {
        return true;  // also where both are infinite
      }
      Front& front = fronts_[r0 <= r1 ? 0 : 1];
      const Front& other = fronts_[r0 <= r1 ? 1 : 0];
      const Index v = front.settle();
      if (other.node(v).state != 0) {
        met_.push_back(v);
        best_ = std::min(best_, sum(v));
      }
      if (++settled % kProgressInterval == 0 && !progress.keepGoing(settled / (2.0 * mesh_.vertexCount()))) {
        return false;
      }
    }
  }

  std::vector<std::vector<Index>> ways() {
    for (std::size_t i = 0, size = met_.size(); i < size; ++i) {
      forNeighbours(met_[i], [&](Index w) {
        if (metAt(w)) {
          met_.push_back(w);
        }
      });
    }
    std::sort(met_.begin(), met_.end());
    met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
    for (const Index v : met_) {
      best_ = std::min(best_, sum(v));
    }
    std::vector<Index> places;
    for (const Index v : met_) {
      if (sum(v) <= best_ * (1 + kSpread) && isLocalMinimum(v)) {
        places.push_back(v);
      }
    }
    std::stable_sort(places.begin(), places.end(), [&](Index a, Index b) { return sum(a) < sum(b); });
    places.resize(std::min(places.size(), kMostWays));
    std::vector<std::vector<Index>> result;
    for (const Index v : places) {
      std::vector<Index> chain = fronts_[0].chainFrom(v);
      std::reverse(chain.begin(), chain.end());
      const std::vector<Index> rest = fronts_[1].chainFrom(v);
      chain.insert(chain.end(), rest.begin() + 1, rest.end());
      result.push_back(std::move(chain));
    }
    return result;
  }

 private:
  double sum(Index v) const { return fronts_[0].node(v).distance + fronts_[1].node(v).distance; }

  bool metAt(Index v) const { return fronts_[0].node(v).state != 0 && fronts_[1].node(v).state != 0; }

  template <class Visit>
  void forNeighbours(Index v, const Visit& visit) const {
    const Index first = mesh_.outgoing(v);
    for (Index h = first; h >= 0;) {
      visit(mesh_.to(h));
      const Index last = TriangleMesh::prev(h);
      h = mesh_.twin(last);
      if (h < 0) {
        visit(mesh_.from(last));
      }
      if (h == first) {
        break;
      }
    }
  }

  bool isLocalMinimum(Index v) const {
    bool least = true;
    forNeighbours(v, [&](Index w) {
      least = least && !(metAt(w) && (sum(w) < sum(v) || (sum(w) == sum(v) && w < v)));
    });
    return least;
  }

  const TriangleMesh& mesh_;
  Front fronts_[2];
  std::vector<Index> met_;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<std::vector<Index>> waysByWavefront(const TriangleMesh& mesh, Index from, Index to,
                                                const Progress& progress) {
  Meeting meeting(mesh, from, to);
  if (!meeting.run(progress)) {
    return {};
  }
  return meeting.ways();
}

}  // namespace graftsman
