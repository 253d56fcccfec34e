#include "core/fusion/window_search.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/fusion/face_strip.h"
#include "core/fusion/min_heap.h"
#include "core/fusion/path_points.h"
#include "core/fusion/zeroed_array.h"

namespace graftsman {
namespace {

using Point2 = Eigen::Vector2d;

// A window is dropped for a nearer vertex beside it only if that is nearer by more than this part: windows
// that graze the vertex itself must stay.
constexpr double kGrazing = 1e-10;
// Windows narrower than this part of their edge are rounding.
constexpr double kNarrowest = 1e-12;
// A vertex with more than this over 2π is a saddle, round which shortest ways bend; less is rounding.
constexpr double kSaddle = 1e-9;
// Ways that graze a singular vertex are led by it at this part of the edge.
constexpr double kOffSingular = 1e-3;
constexpr std::size_t kWindowsPerLook = 1024;

// Seen from inside the face of h, which it is about to enter: the edge runs from the origin along x, the face
// lies above it and the (virtual) source below.
struct Window {
  Index h;
  Index parent;   // the window that it came from, or −1: directly from the source
  Index root;     // the vertex that is the source
  double b0, b1;  // the stretch of the edge
  Point2 source;
  double rootDistance;
};

struct Label {
  double distance;
  Index via;  // the vertex, or ~w: the window, that the distance came by
  bool known;
};

class WindowSearch {
 public:
  WindowSearch(const TriangleMesh& mesh, Index from, Index to, double bound, std::size_t budget)
      : mesh_(mesh),
        to_(to),
        goal_(mesh.point(to)),
        given_(bound),
        bound_(bound),
        budget_(budget),
        labels_(static_cast<std::size_t>(mesh.vertexCount())) {
    labels_[from] = {0, from, true};
    heap_.push((mesh.point(from) - goal_).norm(), ~from);
  }

  std::vector<EdgePoint> run(const Progress& progress) {
    std::size_t steps = 0;
    while (!heap_.empty() && heap_.top().key < bound_ && windows_.size() < budget_) {
      const auto [key, value] = heap_.pop();
      if (value >= 0) {
        propagate(value);
      } else if (key <= labels_[~value].distance + (mesh_.point(~value) - goal_).norm()) {
        emanate(~value);
      }
      if (++steps % kWindowsPerLook == 0 &&
          !progress.keepGoing(static_cast<double>(windows_.size()) / static_cast<double>(budget_))) {
        return {};
      }
    }
    return distance(to_) < given_ ? way() : std::vector<EdgePoint>();
  }

 private:
  [[nodiscard]] double distance(Index v) const {
    return labels_[v].known ? labels_[v].distance : std::numeric_limits<double>::infinity();
  }

  // All windows straight from vertex v: on the edges opposite it, and its neighbours.
  void emanate(Index v) {
    const Index first = mesh_.outgoing(v);
    for (Index h = first; h >= 0;) {
      const Index last = TriangleMesh::prev(h);
      lower(mesh_.to(h), labels_[v].distance + length(h), v);
      if (mesh_.twin(last) < 0) {
        lower(mesh_.from(last), labels_[v].distance + length(last), v);
      }
      const Index opposite = mesh_.twin(TriangleMesh::next(h));
      if (opposite >= 0) {
        const Frame frame(mesh_, opposite);
        add({opposite, -1, v, 0, frame.length, frame.below(mesh_.point(v)), labels_[v].distance}, frame);
      }
      h = mesh_.twin(last);
      if (h == first) {
        break;
      }
    }
  }

  // The plane of a face with the edge of h on the x axis.
  struct Frame {
    Frame(const TriangleMesh& mesh, Index h) : origin(mesh.point(mesh.from(h))) {
      x = mesh.point(mesh.to(h)) - origin;
      length = x.norm();
      if (length > 0) {
        x /= length;
      }
    }
    Point2 above(const Point& p) const {
      const double along = x.dot(p - origin);
      return {along, std::sqrt(std::max(0.0, (p - origin).squaredNorm() - along * along))};
    }
    Point2 below(const Point& p) const {
      const Point2 q = above(p);
      return {q.x(), -q.y()};
    }
    Point at(double b) const { return origin + b * x; }
    Point origin;
    Point x;
    double length = 0;
  };

  double length(Index h) const { return (mesh_.point(mesh_.to(h)) - mesh_.point(mesh_.from(h))).norm(); }

  void lower(Index v, double distance, Index via) {
    Label& label = labels_[v];
    if (mesh_.singular(v) || (label.known && label.distance <= distance)) {
      return;
    }
    label = {distance, via, true};
    if (v == to_) {
      bound_ = std::min(bound_, distance);
    } else if (bends(v)) {
      const double key = distance + (mesh_.point(v) - goal_).norm();
      if (key < bound_) {
        heap_.push(key, ~v);
      }
    }
  }

  // True where a shortest way may bend: at a saddle or on the border.
  bool bends(Index v) const {
    if (mesh_.onBorder(v)) {
      return true;
    }
    double angle = 0;
    const Index first = mesh_.outgoing(v);
    Index h = first;
    do {
      angle += cornerAngle(mesh_, h);
      h = mesh_.twin(TriangleMesh::prev(h));
    } while (h != first);
    return angle > 2 * std::numbers::pi * (1 + kSaddle);
  }

  void add(const Window& w, const Frame& frame) {
    if (!(w.b1 - w.b0 > kNarrowest * frame.length)) {
      return;
    }
    const double d0 = w.rootDistance + std::hypot(w.source.x() - w.b0, w.source.y());
    const double d1 = w.rootDistance + std::hypot(w.source.x() - w.b1, w.source.y());
    const double keep = 1 + kGrazing;
    if (d1 > (distance(mesh_.from(w.h)) + w.b1) * keep ||
        d0 > (distance(mesh_.to(w.h)) + frame.length - w.b0) * keep) {
      return;
    }
    const double nearest = std::clamp(w.source.x(), w.b0, w.b1);
    const double least = w.rootDistance + std::hypot(w.source.x() - nearest, w.source.y());
    const double rest = (frame.at((w.b0 + w.b1) / 2) - goal_).norm() - (w.b1 - w.b0) / 2;
    const double key = least + std::max(0.0, rest);
    if (key < bound_) {
      heap_.push(key, static_cast<Index>(windows_.size()));
      windows_.push_back(w);
    }
  }

  // Through the face in front of the window, onto its other two edges.
  void propagate(Index index) {
    const Window w = windows_[static_cast<std::size_t>(index)];
    const Frame frame(mesh_, w.h);
    const Index apexVertex = mesh_.from(TriangleMesh::prev(w.h));
    const Point2 apex = frame.above(mesh_.point(apexVertex));
    const double rise = apex.y() - w.source.y();
    if (!(rise > 0)) {
      return;
    }
    // Where the ray to the apex passes the edge.
    const double passing = w.source.x() - (apex.x() - w.source.x()) * w.source.y() / rise;
    const double slack = kGrazing * frame.length;
    if (w.b0 - slack <= passing && passing <= w.b1 + slack) {
      lower(apexVertex, w.rootDistance + (apex - w.source).norm(), ~index);
    }
    if (passing > w.b0) {
      child(index, w, TriangleMesh::prev(w.h), Point2(0, 0), apex, w.b0, std::min(w.b1, passing),
            passing <= w.b1);
    }
    if (passing < w.b1) {
      child(index, w, TriangleMesh::next(w.h), apex, Point2(frame.length, 0), std::max(w.b0, passing), w.b1,
            passing >= w.b0);
    }
  }

  // On the edge `side` of the window's face, from p to q in the window's frame (left to right seen from the
  // source), between the rays through b0 and b1 of the window's edge.
  void child(Index index, const Window& w, Index side, const Point2& p, const Point2& q, double b0, double b1,
             bool toApex) {
    const Index h = mesh_.twin(side);
    if (h < 0) {
      return;
    }
    const Frame frame(mesh_, h);
    const Point2 edge = q - p;
    // The part of p → q where the ray from the source through (b, 0) meets it.
    const auto meet = [&](double b) {
      const Point2 ray(b - w.source.x(), -w.source.y());
      const Point2 offset = p - w.source;
      const double det = ray.x() * edge.y() - ray.y() * edge.x();
      const double share = (ray.y() * offset.x() - ray.x() * offset.y()) / det;
      return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
    };
    const bool left = p.x() == 0 && p.y() == 0;
    const double s0 = toApex && !left ? 0.0 : meet(b0);
    const double s1 = toApex && left ? 1.0 : meet(b1);
    // The halfedge of the next face runs from p to q in both cases.
    const double len2 = edge.norm();
    const Point2 u = len2 > 0 ? Point2(edge / len2) : Point2(1, 0);
    const Point2 relative = w.source - p;
    const Point2 source(relative.dot(u), -std::abs(u.x() * relative.y() - u.y() * relative.x()));
    add({h, index, w.root, s0 * frame.length, s1 * frame.length, source, w.rootDistance}, frame);
  }

  // From the goal back to the source.
  std::vector<EdgePoint> way() const {
    std::vector<EdgePoint> points = {{to_, -1, 0}};
    for (Index v = to_; labels_[v].via != v;) {
      const Index via = labels_[v].via;
      if (via < 0) {
        v = back(~via, points);
      } else {
        v = via;
      }
      points.push_back({v, -1, 0});
    }
    std::reverse(points.begin(), points.end());
    return points;
  }

  // Adds the points where the straight line from the last point to the window's source passes edges.
  Index back(Index index, std::vector<EdgePoint>& points) const {
    for (;;) {
      const Window& w = windows_[static_cast<std::size_t>(index)];
      const Frame frame(mesh_, w.h);
      const Point2 target = frame.above(position(mesh_, points.back()));
      const double rise = target.y() - w.source.y();
      const double b =
          rise > 0 ? w.source.x() - (target.x() - w.source.x()) * w.source.y() / rise : w.source.x();
      const double share = frame.length > 0 ? std::clamp(b, w.b0, w.b1) / frame.length : 0;
      const Index edge = canonical(mesh_, w.h);
      const double t = edge == w.h ? share : 1 - share;
      const Index end = t < 0.5 ? mesh_.from(edge) : mesh_.to(edge);
      if (t > 0 && t < 1) {
        points.push_back({-1, edge, t});
      } else if (!mesh_.singular(end)) {
        points.push_back({end, -1, 0});
      } else {
        points.push_back({-1, edge, std::clamp(t, kOffSingular, 1 - kOffSingular)});
      }
      if (w.parent < 0) {
        return w.root;
      }
      index = w.parent;
    }
  }

  const TriangleMesh& mesh_;
  Index to_;
  Point goal_;
  double given_;
  double bound_;  // falls when the goal is reached
  std::size_t budget_;
  ZeroedArray<Label> labels_;
  std::vector<Window> windows_;
  MinHeap heap_;
};

}  // namespace

std::vector<EdgePoint> shortestByWindows(const TriangleMesh& mesh, Index from, Index to, double bound,
                                         std::size_t budget, const Progress& progress) {
  return WindowSearch(mesh, from, to, bound, budget).run(progress);
}

}  // namespace graftsman
