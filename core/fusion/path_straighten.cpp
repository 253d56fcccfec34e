#include "core/fusion/path_straighten.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/fusion/face_strip.h"
#include "core/fusion/funnel.h"

namespace graftsman {
namespace {

using Point2 = Funnel::Point2;

// A bend is left alone if the angle on its other side is short of π by less than this (radians): going round
// there would gain less than its square, a 1e-12 part, which is rounding.
constexpr double kStraight = 1e-6;
// A round that shortens the path by less than this part of its length gains only rounding, and ends.
constexpr double kSmallestGain = 1e-12;
// Each round leads the path over at least one row of faces, and no shortest path is farther from the first
// one than it is long; twice that many rounds are never needed but for rounding.
constexpr std::size_t kRoundsPerPoint = 2;
constexpr std::size_t kLeastRounds = 50;
// A shortest way has no loop, so one removal is already rare; the bound is against rounding.
constexpr int kMostLoopRemovals = 8;

class Straightener {
 public:
  Straightener(const TriangleMesh& mesh, const PathObstacles& obstacles)
      : mesh_(mesh), obstacles_(obstacles) {}

  std::vector<EdgePoint> run(std::vector<EdgePoint> best, double worth) {
    double length = polylineLength(mesh_, best);
    FaceStrip strip = stripAlong(mesh_, obstacles_, best);
    const std::size_t rounds = kLeastRounds + kRoundsPerPoint * best.size();
    for (std::size_t round = 0; round < rounds; ++round) {
      if (strip.portals.empty()) {
        return {{strip.from, -1, 0}, {strip.to, -1, 0}};
      }
      funnel_.solve(mesh_, strip);
      const double found = funnelLength();
      const bool settled = round > 0 && !(found < length * (1 - std::max(worth, kSmallestGain)));
      if (round > 0 && !(found < length)) {
        break;
      }
      length = found;
      solved_ = strip;
      if (settled) {
        break;
      }
      if (!roundBends(strip)) {
        break;
      }
    }
    funnel_.solve(mesh_, solved_);
    return funnel_.points(mesh_, solved_);
  }

 private:
  double funnelLength() const {
    double length = 0;
    const auto& corners = funnel_.corners();
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      length += (corners[i + 1].at - corners[i].at).norm();
    }
    return length;
  }

  // The vertex at one end of a portal, or −1 if the way must keep off it.
  Index vertexAt(const Portal& portal, bool left) const {
    const bool canonicalEnd = (canonical(mesh_, portal.h) == portal.h) == left;
    if (canonicalEnd ? portal.hi != 1 : portal.lo != 0) {
      return -1;
    }
    return left ? mesh_.to(portal.h) : mesh_.from(portal.h);
  }

  // Leads the strip round the other side of its bends where that is shorter. False if it is nowhere.
  bool roundBends(FaceStrip& strip) {
    const auto& corners = funnel_.corners();
    const auto& portals = strip.portals;
    std::vector<Portal> changed;
    std::size_t copied = 0;  // portals of the old strip that are dealt with
    bool any = false;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const auto at = static_cast<std::size_t>(corners[i].portal);
      const bool left = corners[i].left;
      const Index v = vertexAt(portals[at], left);
      if (v < 0 || at < copied) {
        continue;
      }
      std::size_t begin = at;
      while (begin > copied && vertexAt(portals[begin - 1], left) == v) {
        --begin;
      }
      if (begin == copied && begin > 0 && vertexAt(portals[begin - 1], left) == v) {
        continue;  // an earlier bend's change overlaps
      }
      std::size_t end = at + 1;
      while (end < portals.size() && vertexAt(portals[end], left) == v) {
        ++end;
      }
      if (!otherSide(portals, begin, end, corners[i - 1].at, corners[i], corners[i + 1].at)) {
        continue;
      }
      any = true;
      for (; copied < begin; ++copied) {
        pushPortal(mesh_, changed, portals[copied]);
      }
      for (const Index h : crossed_) {
        pushPortal(mesh_, changed, makePortal(obstacles_.intervalNear(h, v), h));
      }
      copied = end;
    }
    if (any) {
      for (; copied < portals.size(); ++copied) {
        pushPortal(mesh_, changed, portals[copied]);
      }
      strip.portals = std::move(changed);
      trimEnds(mesh_, strip);
    }
    return any;
  }

  // Collects in crossed_ the halfedges on the other side of the vertex that portals [begin, end) turn round.
  // False if the angle there is not below π, or the border is there.
  bool otherSide(const std::vector<Portal>& portals, std::size_t begin, std::size_t end, const Point2& before,
                 const Funnel::Corner& corner, const Point2& after) {
    crossed_.clear();
    const bool left = corner.left;
    const auto angle = [&](const Point2& p, Index portal) {
      const Point2 a = p - corner.at;
      const Point2 b = funnel_.edgeEnd(portal, left) - corner.at;
      return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
    };
    const double limit = std::numbers::pi - kStraight;
    const Index lastFace = TriangleMesh::faceOf(mesh_.twin(portals[end - 1].h));
    Index h = portals[begin].h;
    if (TriangleMesh::faceOf(h) == lastFace) {
      return true;
    }
    double sum = angle(before, static_cast<Index>(begin) - 1) + angle(after, static_cast<Index>(end));
    // Round the vertex away from the strip: clockwise if it is on the strip's left.
    h = left ? TriangleMesh::next(h) : TriangleMesh::prev(h);
    for (;;) {
      const Index twin = mesh_.twin(h);
      if (twin < 0) {
        return false;
      }
      crossed_.push_back(h);
      if (TriangleMesh::faceOf(twin) == lastFace) {
        return sum < limit;
      }
      sum += cornerAngle(mesh_, left ? TriangleMesh::next(twin) : twin);
      if (sum >= limit) {
        return false;
      }
      h = left ? TriangleMesh::next(twin) : TriangleMesh::prev(twin);
    }
  }

  const TriangleMesh& mesh_;
  const PathObstacles& obstacles_;
  Funnel funnel_;
  FaceStrip solved_;
  std::vector<Index> crossed_;
};

}  // namespace

std::vector<EdgePoint> straightened(const TriangleMesh& mesh, const PathObstacles& obstacles,
                                    std::vector<EdgePoint> points, double worth) {
  // A loop that went made the path shorter, so this ends by itself but for rounding.
  for (int attempt = 0; attempt < kMostLoopRemovals; ++attempt) {
    points = withoutDetours(obstacles, Straightener(mesh, obstacles).run(std::move(points), worth));
    if (!removeLoops(mesh, points)) {
      break;
    }
    points = withoutDetours(obstacles, points);
  }
  return points;
}

}  // namespace graftsman
