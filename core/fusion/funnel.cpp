#include "core/fusion/funnel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

namespace graftsman {
namespace {

using Point2 = Funnel::Point2;

// A way that crosses an edge closer to its end than this fraction of the edge goes through that end: it gets
// longer by at most twice this fraction of the edge, and the pieces of cut faces are no needles.
constexpr double kFunnelSnap = 1e-6;

double cross(const Point2& a, const Point2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The apex c of a triangle over the edge a → b that lies in the plane from a2 to b2; on the right of the
// edge if `side` is 1, on its left if −1. A degenerate edge points upwards.
Point2 apexAt(const Point& a, const Point& b, const Point& c, const Point2& a2, const Point2& b2,
              double side) {
  const Point edge = b - a;
  const Point towards = c - a;
  const double length = edge.norm();
  const double along = length > 0 ? edge.dot(towards) / length : 0;
  const double height = length > 0 ? edge.cross(towards).norm() / length : towards.norm();
  const Point2 edge2 = b2 - a2;
  const double length2 = edge2.norm();
  const Point2 up = length2 > 0 ? Point2(edge2 / length2) : Point2(0, 1);
  return a2 + along * up + side * height * Point2(up.y(), -up.x());
}

}  // namespace

const Point2& Funnel::edgeEnd(Index portal, bool left) const {
  if (portal < 0) {
    return start_;
  }
  if (portal >= static_cast<Index>(gates_.size())) {
    return end_;
  }
  const Gate& gate = gates_[static_cast<std::size_t>(portal)];
  return left ? gate.leftEnd : gate.rightEnd;
}

void Funnel::unfold(const TriangleMesh& mesh, const FaceStrip& strip) {
  gates_.resize(strip.portals.size());
  const Index first = strip.portals.front().h;
  Point2 right(0, 0);
  Point2 left(0, (mesh.point(mesh.to(first)) - mesh.point(mesh.from(first))).norm());
  start_ = apexAt(mesh.point(mesh.from(first)), mesh.point(mesh.to(first)), mesh.point(strip.from), right,
                  left, -1);
  for (std::size_t k = 0; k < gates_.size(); ++k) {
    const Portal& portal = strip.portals[k];
    const Index twin = mesh.twin(portal.h);
    Gate& gate = gates_[k];
    gate.rightEnd = right;
    gate.leftEnd = left;
    const bool sameWay = portal.h < twin;
    gate.rightShare = sameWay ? portal.lo : 1 - portal.hi;
    gate.leftShare = sameWay ? portal.hi : 1 - portal.lo;
    gate.right = gate.rightShare == 0 ? right : Point2(right + gate.rightShare * (left - right));
    gate.left = gate.leftShare == 1 ? left : Point2(right + gate.leftShare * (left - right));
    const Index apex = mesh.from(TriangleMesh::prev(twin));
    const Point2 apex2 = apexAt(mesh.point(mesh.from(portal.h)), mesh.point(mesh.to(portal.h)),
                                mesh.point(apex), right, left, 1);
    if (k + 1 == gates_.size()) {
      assert(apex == strip.to);
      end_ = apex2;
    } else if (strip.portals[k + 1].h == TriangleMesh::next(twin)) {
      left = apex2;
    } else {
      assert(strip.portals[k + 1].h == TriangleMesh::prev(twin));
      right = apex2;
    }
  }
}

void Funnel::add(const Corner& corner) {
  auto& own = chains_[corner.left];
  auto& other = chains_[!corner.left];
  std::size_t& ownHead = heads_[corner.left];
  std::size_t& otherHead = heads_[!corner.left];
  const double sign = corner.left ? 1 : -1;
  while (own.size() > ownHead) {
    const Point2& before = own.size() > ownHead + 1 ? own[own.size() - 2].at : corners_.back().at;
    const Point2& last = own.back().at;
    if (sign * cross(last - before, corner.at - last) > 0) {
      own.push_back(corner);
      return;
    }
    own.pop_back();
  }
  while (other.size() > otherHead) {
    const Point2& apex = corners_.back().at;
    if (sign * cross(other[otherHead].at - apex, corner.at - apex) >= 0) {
      break;
    }
    corners_.push_back(other[otherHead++]);
  }
  own.push_back(corner);
}

void Funnel::solve(const TriangleMesh& mesh, const FaceStrip& strip) {
  unfold(mesh, strip);
  corners_.assign(1, {start_, -1, false});
  for (const int side : {0, 1}) {
    chains_[side].clear();
    heads_[side] = 0;
  }
  for (std::size_t k = 0; k < gates_.size(); ++k) {
    const Gate& gate = gates_[k];
    const Gate* before = k > 0 ? &gates_[k - 1] : nullptr;
    if (!before || before->right != gate.right) {
      add({gate.right, static_cast<Index>(k), false});
    }
    if (!before || before->left != gate.left) {
      add({gate.left, static_cast<Index>(k), true});
    }
  }
  add({end_, static_cast<Index>(gates_.size()), true});
  corners_.insert(corners_.end(), chains_[1].begin() + static_cast<std::ptrdiff_t>(heads_[1]),
                  chains_[1].end());
}

// Where the straight line from corner a to corner b, of earlier and later portals, passes portal k.
EdgePoint Funnel::crossing(const TriangleMesh& mesh, const Portal& portal, std::size_t k, const Corner& a,
                           const Corner& b) const {
  const Gate& gate = gates_[k];
  double share;
  if (b.portal == static_cast<Index>(k)) {
    share = b.left ? gate.leftShare : gate.rightShare;
  } else if (gate.right == a.at || gate.right == b.at) {
    share = gate.rightShare;
  } else if (gate.left == a.at || gate.left == b.at) {
    share = gate.leftShare;
  } else {
    const Point2 line = b.at - a.at;
    const double fromRight = cross(line, gate.rightEnd - a.at);  // below 0
    const double fromLeft = cross(line, gate.leftEnd - a.at);    // above 0
    const double span = fromLeft - fromRight;
    share = std::clamp(span > 0 ? -fromRight / span : 0.5, gate.rightShare, gate.leftShare);
  }
  const Index edge = canonical(mesh, portal.h);
  const double t = edge == portal.h ? share : 1 - share;
  if (portal.lo == 0 && t < kFunnelSnap) {
    return {mesh.from(edge), -1, 0};
  }
  if (portal.hi == 1 && t > 1 - kFunnelSnap) {
    return {mesh.to(edge), -1, 0};
  }
  return {-1, edge, std::clamp(t, portal.lo, portal.hi)};
}

std::vector<EdgePoint> Funnel::points(const TriangleMesh& mesh, const FaceStrip& strip) const {
  std::vector<EdgePoint> result;
  result.reserve(gates_.size() + 2);
  result.push_back({strip.from, -1, 0});
  std::size_t leg = 0;
  for (std::size_t k = 0; k < gates_.size(); ++k) {
    while (corners_[leg + 1].portal < static_cast<Index>(k)) {
      ++leg;
    }
    result.push_back(crossing(mesh, strip.portals[k], k, corners_[leg], corners_[leg + 1]));
  }
  result.push_back({strip.to, -1, 0});
  return result;
}

}  // namespace graftsman
