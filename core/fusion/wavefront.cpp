#include "core/fusion/wavefront.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/fusion/min_heap.h"
#include "core/fusion/path_points.h"
#include "core/fusion/zeroed_array.h"

namespace graftsman {
namespace {

// A candidate's estimated length may exceed the least by this part: more than the error of the wavefront
// (below 1 % on models of everyday quality), so that the shortest way is among the candidates.
constexpr double kSpread = 0.02;
// So many candidates are straightened: past these, none was ever the shortest on the sample models.
constexpr std::size_t kMostWays = 6;
// A distance is corrected only if it falls by more than this part; less is rounding, and would go on for
// long.
constexpr double kSmallestCorrection = 1e-7;
constexpr int kFrontsPerLook = 1024;
// A vertex is among long and thin triangles if its longest edge is so many times its shortest; models for
// animation and scans have a few percent of such vertices, tessellated solids nearly nothing else.
constexpr double kElongated = 8;
constexpr double kManyElongated = 0.2;
// A ray that passes a vertex closer than this part of the edge goes through it: closer than its own error.
constexpr double kNearVertex = 1e-3;
// A ray ends at the vertex of a face from where the rest is longer by at most this part, which is rounding.
constexpr double kSameLength = 1e-6;
// A ray crosses about as many edges as the mesh is vertices wide; a limit against circles.
constexpr std::size_t kMostStepsPerVertex = 100;

struct Node {
  double distance;
  Index via;  // the vertex that the distance came from, or ~h if it came through h, opposite in its face
  std::int32_t state;  // 0 untouched, 1 open, 2 settled
};

// A virtual source in the plane of a triangle, with the edge a → b on the x axis and a at the origin.
struct Unfolded {
  double base, sx, sy;  // the source lies at (sx, sy), sy > 0, on the other side of the edge than the target
  bool valid;
};

Unfolded unfoldSource(double base, double da, double db) {
  const double sx = (da * da - db * db + base * base) / (2 * base);
  const double sy2 = da * da - sx * sx;
  return sy2 > 0 ? Unfolded{base, sx, std::sqrt(sy2), true} : Unfolded{base, 0, 0, false};
}

class Front {
 public:
  Front(const TriangleMesh& mesh, Index source, Index goal, double bound)
      : mesh_(mesh),
        goal_(mesh.point(goal)),
        bound_(bound),
        nodes_(static_cast<std::size_t>(mesh.vertexCount())) {
    nodes_[source] = {0, source, 1};
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
    gatherSpokes(v);
    countElongated();
    const double distance = nodes_[v].distance;
    const std::size_t size = spokes_.size();
    for (std::size_t k = 0; k < size; ++k) {
      const Spoke& target = spokes_[k];
      const Spoke* after = k + 1 < size ? &spokes_[k + 1] : closed_ ? &spokes_.front() : nullptr;
      const Spoke* before = k > 0 ? &spokes_[k - 1] : closed_ ? &spokes_.back() : nullptr;
      Update best{target.node.distance, v};
      if (target.node.state == 0 || distance < best.distance) {
        best.distance = distance + std::sqrt(target.squaredLength);
      }
      if (after && mayCross(*after, target)) {
        through(distance, *after, target, TriangleMesh::prev(target.h), best);
      }
      if (before && mayCross(*before, target)) {
        through(distance, *before, target, before->h, best);
      }
      if (target.node.state == 0 || best.distance < target.node.distance) {
        lower(target.vertex, best);
      }
    }
    return v;
  }

  [[nodiscard]] long settledCount() const { return settled_; }
  [[nodiscard]] long elongatedCount() const { return elongated_; }

  // The way from v back to the source, along the rays that its distance came by.
  [[nodiscard]] std::vector<EdgePoint> wayFrom(Index v) const {
    std::vector<EdgePoint> way = {{v, -1, 0}};
    const std::size_t most =
        kMostStepsPerVertex * static_cast<std::size_t>(std::sqrt(mesh_.vertexCount()) + 10);
    while (nodes_[v].via != v && way.size() < most) {
      const Index via = nodes_[v].via;
      v = via >= 0 ? via : followRay(v, ~via, way, most);
      way.push_back({v, -1, 0});
    }
    // Rays of inconsistent distances might lead round in circles; from vertex to nearer vertex does not.
    for (; nodes_[v].via != v; way.push_back({v, -1, 0})) {
      v = nearerVertex(v);
    }
    return way;
  }

 private:
  [[nodiscard]] bool stale(const MinHeap::Entry& entry) const {
    const Node& node = nodes_[entry.value];
    return node.state == 2 || node.distance != entry.key;
  }

  struct Spoke {
    Index h;  // from the fan's centre to `vertex`, or back if the last of an open fan
    Index vertex;
    Node node;
    Point vector;
    double squaredLength;
  };
  struct Update {
    double distance;
    Index via;
  };

  void countElongated() {
    double least = spokes_.front().squaredLength;
    double greatest = least;
    for (const Spoke& spoke : spokes_) {
      least = std::min(least, spoke.squaredLength);
      greatest = std::max(greatest, spoke.squaredLength);
    }
    ++settled_;
    elongated_ += greatest > kElongated * kElongated * least ? 1 : 0;
  }

  void gatherSpokes(Index v) {
    spokes_.clear();
    const Point& origin = mesh_.point(v);
    const auto add = [&](Index h, Index w) {
      const Point vector = mesh_.point(w) - origin;
      spokes_.push_back({h, w, nodes_[w], vector, vector.squaredNorm()});
    };
    const Index first = mesh_.outgoing(v);
    Index h = first;
    do {
      add(h, mesh_.to(h));
      const Index last = TriangleMesh::prev(h);
      h = mesh_.twin(last);
      if (h < 0) {
        add(last, mesh_.from(last));
      }
    } while (h >= 0 && h != first);
    closed_ = h == first;
  }

  void lower(Index v, const Update& update) {
    Node& node = nodes_[v];
    if (mesh_.singular(v)) {
      return;
    }
    if (node.state != 0 && !(update.distance < node.distance * (1 - kSmallestCorrection))) {
      return;
    }
    if (node.state == 0 && update.distance + (mesh_.point(v) - goal_).norm() > bound_) {
      return;
    }
    node = {update.distance, update.via, 1};
    heap_.push(update.distance, v);
  }

  // Whether the ray to c may come through the edge to b: a front reaches a settled corner late through the
  // opposite edge only if the corner is obtuse.
  static bool mayCross(const Spoke& b, const Spoke& c) {
    return b.node.state == 2 && (c.node.state != 2 || c.squaredLength < b.vector.dot(c.vector));
  }

  // The distance of c by the ray through the edge from a, the vertex just settled, to b, settled, too; h is
  // its halfedge opposite c: their distances put the source in the plane of the triangle, on the edge's other
  // side.
  static void through(double da, const Spoke& b, const Spoke& c, Index h, Update& best) {
    const double along = b.vector.dot(c.vector);
    const double base = std::sqrt(b.squaredLength);
    const double db = b.node.distance;
    const Unfolded s = unfoldSource(base, da, db);
    const double cx = along / base;
    const double cy2 = c.squaredLength - cx * cx;
    if (!(base > 0) || !s.valid || !(cy2 > 0)) {
      return;
    }
    const double cy = std::sqrt(cy2);
    const double x = s.sx * cy + cx * s.sy;  // where the ray passes a–b, times (sy + cy)
    if (x <= 0 || x >= base * (s.sy + cy)) {
      return;
    }
    const double distance = std::sqrt((cx - s.sx) * (cx - s.sx) + (cy + s.sy) * (cy + s.sy));
    // Always from a nearer vertex, so that chains of nearerVertex() end, even where distances fall later.
    if (distance < best.distance && distance > std::min(da, db)) {
      best = {distance, ~h};
    }
  }

  Index nearerVertex(Index v) const {
    const Index via = nodes_[v].via;
    if (via >= 0) {
      return via;
    }
    const Index a = mesh_.from(~via);
    const Index b = mesh_.to(~via);
    return nodes_[a].distance <= nodes_[b].distance ? a : b;
  }

  // Adds the edge points of the ray by which the distance of c came through h; returns the vertex it ends at.
  Index followRay(Index c, Index h, std::vector<EdgePoint>& way, std::size_t most) const {
    // From c at (cx, −cy) below the edge h → the source above it.
    Point origin = position(mesh_, {c, -1, 0});
    for (;;) {
      const Index a = mesh_.from(h);
      const Index b = mesh_.to(h);
      const Index nearer = nodes_[a].distance <= nodes_[b].distance ? a : b;
      const Point ab = mesh_.point(b) - mesh_.point(a);
      const Unfolded s = unfoldSource(ab.norm(), nodes_[a].distance, nodes_[b].distance);
      const Index twin = mesh_.twin(h);
      if (!s.valid || twin < 0 || way.size() >= most) {
        return nearer;
      }
      const Point down = origin - mesh_.point(a);
      const double px = down.dot(ab) / s.base;
      const double py = std::sqrt(std::max(0.0, down.squaredNorm() - px * px));
      const double x = (s.sx * py + px * s.sy) / (s.sy + py);
      if (!(x > kNearVertex * s.base)) {
        return a;
      }
      if (!(x < (1 - kNearVertex) * s.base)) {
        return b;
      }
      const Index edge = canonical(mesh_, h);
      way.push_back({-1, edge, edge == h ? x / s.base : 1 - x / s.base});
      // The face beyond, its third vertex d above the edge.
      const Index d = mesh_.from(TriangleMesh::prev(twin));
      if (nodes_[d].state == 0) {
        return nearer;
      }
      const Point up = mesh_.point(d) - mesh_.point(a);
      const double dx = up.dot(ab) / s.base;
      const double dy = std::sqrt(std::max(0.0, up.squaredNorm() - dx * dx));
      const double left = std::hypot(s.sx - x, s.sy);
      if (nodes_[d].distance + std::hypot(dx - x, dy) <= left * (1 + kSameLength)) {
        return d;
      }
      const double side = (s.sx - x) * dy - s.sy * (dx - x);  // above 0: the ray passes d on b's side
      h = side > 0 ? TriangleMesh::prev(twin) : TriangleMesh::next(twin);
      origin = position(mesh_, way.back());
    }
  }

  const TriangleMesh& mesh_;
  Point goal_;
  double bound_;
  ZeroedArray<Node> nodes_;
  MinHeap heap_;
  long settled_ = 0;
  long elongated_ = 0;         // of these, how many have edges of very different length
  std::vector<Spoke> spokes_;  // of the vertex just settled
  bool closed_ = false;        // whether they go all the way round
};

class Meeting {
 public:
  Meeting(const TriangleMesh& mesh, Index from, Index to, double bound)
      : mesh_(mesh), fronts_{{mesh, from, to, bound}, {mesh, to, from, bound}}, bound_(bound) {}

  bool run(const Progress& progress) {
    int settled = 0;
    for (;;) {
      const double r0 = fronts_[0].radius();
      const double r1 = fronts_[1].radius();
      if (!(r0 + r1 < std::min(bound_, best_ * (1 + kSpread)))) {
        return true;  // also where both are infinite
      }
      Front& front = fronts_[r0 <= r1 ? 0 : 1];
      const Front& other = fronts_[r0 <= r1 ? 1 : 0];
      const Index v = front.settle();
      if (other.node(v).state != 0) {
        met_.push_back(v);
        best_ = std::min(best_, sum(v));
      }
      if (++settled % kFrontsPerLook == 0 && !progress.keepGoing(settled / (2.0 * mesh_.vertexCount()))) {
        return false;
      }
    }
  }

  bool elongated() const {
    const auto settled = static_cast<double>(fronts_[0].settledCount() + fronts_[1].settledCount());
    const auto count = static_cast<double>(fronts_[0].elongatedCount() + fronts_[1].elongatedCount());
    return count > kManyElongated * settled;
  }

  std::vector<std::vector<EdgePoint>> ways() {
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
    std::vector<std::vector<EdgePoint>> result;
    for (const Index v : places) {
      std::vector<EdgePoint> way = fronts_[0].wayFrom(v);
      std::reverse(way.begin(), way.end());
      const std::vector<EdgePoint> rest = fronts_[1].wayFrom(v);
      way.insert(way.end(), rest.begin() + 1, rest.end());
      result.push_back(std::move(way));
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
  double bound_;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace

WavefrontWays waysByWavefront(const TriangleMesh& mesh, Index from, Index to, double bound,
                              const Progress& progress) {
  Meeting meeting(mesh, from, to, bound * (1 + kSpread));
  if (!meeting.run(progress)) {
    return {};
  }
  return {meeting.ways(), meeting.elongated()};
}

}  // namespace graftsman
