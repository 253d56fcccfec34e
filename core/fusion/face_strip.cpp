#include "core/fusion/face_strip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace graftsman {
namespace {

// How far a path keeps off an obstacle, as a fraction of the free interval: small, to stay short; not so
// small that a few paths side by side run out of doubles.
constexpr double kKeepOff = 0.125;

double angleBetween(const Point& a, const Point& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The faces round a vertex, counter-clockwise: edge k, face k, edge k + 1, face k + 1, …
class Fan {
 public:
  Fan(const TriangleMesh& mesh, Index v) : mesh_(mesh), v_(v) {
    const Index first = mesh.outgoing(v);
    open_ = mesh.twin(first) < 0;
    double angle = 0;
    for (Index h = first; h >= 0;) {
      spokes_.push_back(h);
      angles_.push_back(angle);
      angle += cornerAngle(mesh, h);
      h = mesh.twin(TriangleMesh::prev(h));
      if (h == first) {
        break;
      }
    }
    angles_.push_back(angle);
  }

  struct Direction {
    std::size_t index = 0;  // of the edge, or of the face
    bool alongEdge = false;
    double angle = 0;
  };

  // Which way `p` lies from v. Precondition: they share a face or an edge.
  Direction towards(const EdgePoint& p) const {
    const auto [edge, face] = sharedPlace(mesh_, EdgePoint{v_, -1, 0}, p);
    for (std::size_t k = 0; k < spokes_.size(); ++k) {
      const Index h = spokes_[k];
      if (edge >= 0 && canonical(mesh_, h) == edge) {
        return {k, true, angles_[k]};
      }
      if (face >= 0 && TriangleMesh::faceOf(h) == face) {
        const Point& origin = mesh_.point(v_);
        const double within = angleBetween(mesh_.point(mesh_.to(h)) - origin, position(mesh_, p) - origin);
        return {k, false, angles_[k] + within};
      }
    }
    assert(open_ && canonical(mesh_, TriangleMesh::prev(spokes_.back())) == edge);
    return {spokes_.size(), true, angles_.back()};
  }

  // True if turning counter-clockwise from `a` to `b` is possible and the smaller angle.
  bool counterClockwise(const Direction& a, const Direction& b) const {
    if (open_) {
      return std::pair(a.index, !a.alongEdge) < std::pair(b.index, !b.alongEdge);
    }
    const double turn = b.angle - a.angle;
    return (turn < 0 ? turn + angles_.back() : turn) <= angles_.back() / 2;
  }

  // The halfedges that are crossed on the way from a to b, each in the face that is left.
  std::vector<Index> crossed(const Direction& a, const Direction& b, bool ccw) const {
    const std::size_t size = spokes_.size();
    std::vector<Index> result;
    if (ccw) {
      const std::size_t stop = (b.alongEdge ? b.index : b.index + 1);
      for (std::size_t k = a.index + 1; k % size != stop % size; ++k) {
        result.push_back(mesh_.twin(spokes_[k % size]));
      }
      return result;
    }
    // One before an edge, but the edge at the start of a face.
    for (std::size_t k = a.index + size - (a.alongEdge ? 1 : 0); k % size != b.index % size; --k) {
      result.push_back(spokes_[k % size]);
    }
    return result;
  }

  // The face in which one is when turning that way, just after (before) looking along the edge of d.
  Index faceBeside(const Direction& d, bool after) const {
    const std::size_t size = spokes_.size();
    return TriangleMesh::faceOf(spokes_[(after ? d.index : d.index + size - 1) % size]);
  }

 private:
  const TriangleMesh& mesh_;
  Index v_;
  bool open_ = false;
  std::vector<Index> spokes_;
  std::vector<double> angles_;  // of edge k; one more: the whole
};

class StripBuilder {
 public:
  StripBuilder(const TriangleMesh& mesh, const PathObstacles& obstacles)
      : mesh_(mesh), obstacles_(obstacles) {}

  std::vector<Portal> build(std::span<const EdgePoint> points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (points[i].isVertex()) {
        turn(points[i - 1], points[i], points[i + 1]);
      } else {
        cross(points[i - 1], points[i]);
      }
    }
    return std::move(portals_);
  }

 private:
  void cross(const EdgePoint& before, const EdgePoint& p) {
    const Index face = sharedPlace(mesh_, before, p).face;
    assert(face >= 0);
    const Index h = TriangleMesh::faceOf(p.halfedge) == face ? p.halfedge : mesh_.twin(p.halfedge);
    pushPortal(mesh_, portals_, makePortal(obstacles_.intervalAround(h, p.t), h));
    face_ = TriangleMesh::faceOf(mesh_.twin(h));
  }

  void turn(const EdgePoint& before, const EdgePoint& p, const EdgePoint& after) {
    const Fan fan(mesh_, p.vertex);
    const Fan::Direction in = fan.towards(before);
    const Fan::Direction out = fan.towards(after);
    const bool ccw = fan.counterClockwise(in, out);
    if (in.alongEdge) {
      changeSides(before.vertex, p.vertex, fan.faceBeside(in, ccw));
    }
    for (const Index h : fan.crossed(in, out, ccw)) {
      pushPortal(mesh_, portals_, makePortal(obstacles_.intervalNear(h, p.vertex), h));
    }
    face_ = out.alongEdge ? fan.faceBeside(out, !ccw) : -1;
  }

  // Having run along the edge from a to b beside face_, go on beside `face`.
  void changeSides(Index a, Index b, Index face) {
    if (face_ < 0 || face_ == face) {
      return;
    }
    Index h = mesh_.halfedgeBetween(a, b);
    if (TriangleMesh::faceOf(h) != face_) {
      h = mesh_.twin(h);
    }
    assert(TriangleMesh::faceOf(h) == face_);
    pushPortal(mesh_, portals_, makePortal(obstacles_.intervalNear(h, b), h));
  }

  const TriangleMesh& mesh_;
  const PathObstacles& obstacles_;
  std::vector<Portal> portals_;
  Index face_ = -1;  // where the path is, having run along an edge from a vertex; −1: not decided
};

bool touches(const TriangleMesh& mesh, const Portal& portal, Index v) {
  const Index edge = canonical(mesh, portal.h);
  return (portal.lo == 0 && mesh.from(edge) == v) || (portal.hi == 1 && mesh.to(edge) == v);
}

}  // namespace

double cornerAngle(const TriangleMesh& mesh, Index h) {
  const Point& corner = mesh.point(mesh.from(h));
  return angleBetween(mesh.point(mesh.to(h)) - corner, mesh.point(mesh.from(TriangleMesh::prev(h))) - corner);
}

Portal makePortal(const PathObstacles::Interval& interval, Index h) {
  const double width = interval.hi - interval.lo;
  return {h, interval.loBlocked ? interval.lo + kKeepOff * width : interval.lo,
          interval.hiBlocked ? interval.hi - kKeepOff * width : interval.hi};
}

void pushPortal(const TriangleMesh& mesh, std::vector<Portal>& portals, const Portal& portal) {
  if (!portals.empty() && portals.back().h == mesh.twin(portal.h)) {
    portals.pop_back();
  } else {
    portals.push_back(portal);
  }
}

void trimEnds(const TriangleMesh& mesh, FaceStrip& strip) {
  auto& portals = strip.portals;
  const auto last = std::find_if(portals.rbegin(), portals.rend(),
                                 [&](const Portal& p) { return touches(mesh, p, strip.from); });
  portals.erase(portals.begin(), last.base());
  const auto first = std::find_if(portals.begin(), portals.end(),
                                  [&](const Portal& p) { return touches(mesh, p, strip.to); });
  portals.erase(first, portals.end());
}

FaceStrip stripAlong(const TriangleMesh& mesh, const PathObstacles& obstacles,
                     std::span<const EdgePoint> points) {
  FaceStrip strip{points.front().vertex, points.back().vertex, StripBuilder(mesh, obstacles).build(points)};
  trimEnds(mesh, strip);
  return strip;
}

}  // namespace graftsman
