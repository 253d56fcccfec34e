#include "core/fusion/seam_snap.h"

#include <algorithm>
#include <cmath>

#include "core/base/predicates.h"

namespace graftsman::overlay_detail {
namespace {

// Of the shortest boundary edge there: the correspondence along a side is a free choice (by length), so that
// a thousandth of an edge is nothing to anyone, while the needle triangle that it would leave at the seam
// shows.
constexpr double kSnap = 1e-3;
// Of a side: nearer than this, positions on a side, which are rounded to about 1e-16, have too few bits left
// for the triangles there.
constexpr double kSnapAlways = 1e-12;

/// The boundary positions of one embedding, with the parameters at both sides of each.
struct Positions {
  const std::vector<BoundaryPosition>& at;

  [[nodiscard]] Index size() const { return static_cast<Index>(at.size()); }
  [[nodiscard]] const BoundaryPosition& operator[](Index i) const { return at[static_cast<std::size_t>(i)]; }
  /// Of a vertex that is no corner: the parameters of the vertices before and after it on its side.
  [[nodiscard]] double before(Index i) const { return (*this)[i - 1].t; }
  [[nodiscard]] double after(Index i) const {
    return i + 1 < size() && (*this)[i + 1].side == (*this)[i].side ? (*this)[i + 1].t : 1;
  }
  [[nodiscard]] double shorterEdge(Index i) const {
    return std::min((*this)[i].t - before(i), after(i) - (*this)[i].t);
  }
};

/// Of each boundary vertex, the faces round it.
struct BoundaryStars {
  std::vector<Index> start;
  std::vector<Index> faces;
};

BoundaryStars starsOf(const Embedding& embedding) {
  std::vector<Index> start(embedding.boundary.size() + 2, 0);
  std::vector<Index> faces;
  const auto count = static_cast<Index>(embedding.boundary.size());
  for (const Face& face : embedding.faces) {
    for (const Index v : face) {
      if (v < count) {
        ++start[static_cast<std::size_t>(v) + 2];
      }
    }
  }
  for (std::size_t i = 2; i < start.size(); ++i) {
    start[i] += start[i - 1];
  }
  faces.resize(static_cast<std::size_t>(start.back()));
  for (std::size_t f = 0; f < embedding.faces.size(); ++f) {
    for (const Index v : embedding.faces[f]) {
      if (v < count) {
        faces[static_cast<std::size_t>(start[static_cast<std::size_t>(v) + 1]++)] = static_cast<Index>(f);
      }
    }
  }
  return {std::move(start), std::move(faces)};
}

/// Moves part boundary vertices one by one; each move keeps all triangles counter-clockwise.
class Snapping {
 public:
  Snapping(const Embedding& part, std::vector<BoundaryPosition>& moved) : part_(part), moved_(moved) {}

  void move(Index i, double t) {
    if (stars_.start.empty()) {
      stars_ = starsOf(part_);
    }
    BoundaryPosition& position = moved_[static_cast<std::size_t>(i)];
    const BoundaryPosition old = position;
    position.t = t;
    for (auto k = stars_.start[static_cast<std::size_t>(i)];
         k < stars_.start[static_cast<std::size_t>(i) + 1]; ++k) {
      const Face& face = part_.faces[static_cast<std::size_t>(stars_.faces[static_cast<std::size_t>(k)])];
      if (orient2d(uv(face[0]), uv(face[1]), uv(face[2])) <= 0) {
        position = old;
        return;
      }
    }
  }

 private:
  [[nodiscard]] Point2 uv(Index v) const {
    const auto i = static_cast<std::size_t>(v);
    return i < moved_.size() ? boundaryPoint(part_.sides, moved_[i]) : part_.uv[i];
  }

  const Embedding& part_;
  std::vector<BoundaryPosition>& moved_;
  BoundaryStars stars_;  // made for the first move: often there is none
};

}  // namespace

std::vector<BoundaryPosition> snapBoundary(const Embedding& part, const Embedding& base) {
  std::vector<BoundaryPosition> moved = part.boundary;
  const Positions parts{part.boundary};
  const Positions bases{base.boundary};
  Snapping snapping(part, moved);
  Index lastTaken = -1;
  Index b = 0;
  for (Index p = 0; p < parts.size(); ++p) {
    if (parts[p].t == 0) {
      continue;
    }
    while (b < bases.size() && bases[b] < parts[p]) {
      ++b;
    }
    // The base's neighbours on both sides of parts[p]; the nearer one that is no corner.
    Index nearest = -1;
    for (const Index candidate : {b - 1, b}) {
      if (candidate < bases.size() && bases[candidate].side == parts[p].side && bases[candidate].t != 0 &&
          (nearest < 0 ||
           std::abs(bases[candidate].t - parts[p].t) < std::abs(bases[nearest].t - parts[p].t))) {
        nearest = candidate;
      }
    }
    if (nearest <= lastTaken) {
      continue;
    }
    const double distance = std::abs(bases[nearest].t - parts[p].t);
    const double reach =
        std::max(kSnapAlways, kSnap * std::min(parts.shorterEdge(p), bases.shorterEdge(nearest)));
    const double t = bases[nearest].t;
    const bool orderStays = moved[static_cast<std::size_t>(p) - 1].t < t && t < parts.after(p);
    if (distance == 0) {
      lastTaken = nearest;
    } else if (distance <= reach && orderStays) {
      snapping.move(p, t);
      if (moved[static_cast<std::size_t>(p)].t == t) {
        lastTaken = nearest;
      }
    }
  }
  return moved;
}

}  // namespace graftsman::overlay_detail
