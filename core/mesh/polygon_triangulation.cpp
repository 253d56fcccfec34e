#include "core/mesh/polygon_triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>

namespace graftsman {
namespace {

// Sine of the smallest angle, in [0, √3/2]; 0 for a triangle without area. It lies opposite the shortest
// edge, so it is never obtuse and its sine grows with it.
double shape(const Point& a, const Point& b, const Point& c) {
  std::array<Point, 3> edges = {b - a, c - b, a - c};
  std::array<double, 3> lengths = {edges[0].norm(), edges[1].norm(), edges[2].norm()};
  const auto shortest =
      static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
  const std::size_t i = (shortest + 1) % 3;
  const std::size_t j = (shortest + 2) % 3;
  const double sine = (edges[i] / lengths[i]).cross(edges[j] / lengths[j]).norm();
  return sine > 0 ? sine : 0;  // also for a length of zero, where it is not a number
}

/// Cuts ears off a polygon, best first.
///
/// It never gets stuck: let m ≥ 4 corners be left, not all on one side. A corner is *cuttable* if it and its
/// two neighbours are not on one side, and if the others are not all on one side.
/// - If some corner v is the only one off a side e, its neighbour u is cuttable: u and the next one are on e,
///   and two points share at most one side, so these two and v are on none; what is left has v and, as m ≥ 4,
///   two points of e, and is on none either.
/// - Otherwise every corner fulfils the second condition, and one the first: else each three consecutive
///   corners were on one side, consecutive threes share two points and so the side, and all were on it.
/// So what is left is never all on one side, and the last three corners are a valid triangle. Nor does a cut
/// ever lay a diagonal along a side: the polygon is convex, so its other corners would lie on that side, too.
class EarCutter {
 public:
  EarCutter(std::span<const Index> ids, std::span<const Point> points, std::span<const std::uint8_t> sides,
            std::vector<Face>& out)
      : ids_(ids), points_(points), sides_(sides), out_(out), left_(ids.size()), corners_(ids.size()) {
    for (std::size_t k = 0; k < left_; ++k) {
      corners_[k] = {(k + left_ - 1) % left_, (k + 1) % left_, 0};
      for (std::size_t side = 0; side < 3; ++side) {
        offSide_[side] += onSide(k, side) ? 0 : 1;
      }
    }
    for (std::size_t k = 0; k < left_; ++k) {
      push(k);
    }
    std::make_heap(heap_.begin(), heap_.end());
  }

  void cutAll() {
    while (left_ > 4) {
      assert(!heap_.empty());
      std::pop_heap(heap_.begin(), heap_.end());
      const Ear ear = heap_.back();
      heap_.pop_back();
      if (ear.version == corners_[ear.corner].version && !isOnlyOneOff(ear.corner)) {
        cut(ear.corner);
      }
    }
    cutLastFour();
  }

 private:
  struct Corner {
    std::size_t prev;
    std::size_t next;
    std::uint32_t version;  // counts changes of the neighbours; an ear of an older version is void
  };
  struct Ear {
    double shape;
    std::size_t corner;
    std::uint32_t version;
    bool operator<(const Ear& other) const {
      return shape != other.shape ? shape < other.shape : corner > other.corner;
    }
  };

  [[nodiscard]] bool onSide(std::size_t k, std::size_t side) const { return (sides_[k] >> side & 1) != 0; }

  // Once true of a corner it stays so, for the number of corners off a side never grows.
  [[nodiscard]] bool isOnlyOneOff(std::size_t k) const {
    for (std::size_t side = 0; side < 3; ++side) {
      if (offSide_[side] == 1 && !onSide(k, side)) {
        return true;
      }
    }
    return false;
  }

  void push(std::size_t k) {
    const auto& [prev, next, version] = corners_[k];
    if ((sides_[prev] & sides_[k] & sides_[next]) == 0) {
      heap_.push_back({shape(points_[prev], points_[k], points_[next]), k, version});
    }
  }

  void cut(std::size_t k) {
    const auto [prev, next, version] = corners_[k];
    out_.push_back({ids_[prev], ids_[k], ids_[next]});
    corners_[prev].next = next;
    corners_[next].prev = prev;
    ++corners_[k].version;
    for (std::size_t side = 0; side < 3; ++side) {
      offSide_[side] -= onSide(k, side) ? 0 : 1;
    }
    --left_;
    first_ = prev;
    for (const std::size_t changed : {prev, next}) {
      ++corners_[changed].version;
      const std::size_t size = heap_.size();
      push(changed);
      if (heap_.size() > size) {
        std::push_heap(heap_.begin(), heap_.end());
      }
    }
  }

  void cutLastFour() {
    std::array<std::size_t, 4> rest;
    for (std::size_t& k : rest) {
      k = first_;
      first_ = corners_[first_].next;
    }
    std::sort(rest.begin(), rest.end());  // numbers rise along the polygon but for one wrap
    std::array<Index, 4> ids;
    std::array<Point, 4> points;
    std::array<std::uint8_t, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) {
      ids[i] = ids_[rest[i]];
      points[i] = points_[rest[i]];
      sides[i] = sides_[rest[i]];
    }
    triangulatePolygon(ids, points, sides, out_);
  }

  std::span<const Index> ids_;
  std::span<const Point> points_;
  std::span<const std::uint8_t> sides_;
  std::vector<Face>& out_;
  std::size_t left_;
  std::size_t first_ = 0;  // a corner that is left
  std::vector<Corner> corners_;
  std::vector<Ear> heap_;
  std::array<std::size_t, 3> offSide_ = {0, 0, 0};  // how many corners that are left are not on each side
};

void triangulateQuadrilateral(std::span<const Index> ids, std::span<const Point> points,
                              std::span<const std::uint8_t> sides, std::vector<Face>& out) {
  // −1 if the triangle is invalid: never chosen, since one of the diagonals is valid on both sides.
  const auto value = [&](std::size_t a, std::size_t b, std::size_t c) {
    return (sides[a] & sides[b] & sides[c]) != 0 ? -1 : shape(points[a], points[b], points[c]);
  };
  const double diagonal02 = std::min(value(0, 1, 2), value(0, 2, 3));
  const double diagonal13 = std::min(value(0, 1, 3), value(1, 2, 3));
  assert(diagonal02 >= 0 || diagonal13 >= 0);
  if (diagonal02 >= diagonal13) {
    out.insert(out.end(), {Face{ids[0], ids[1], ids[2]}, Face{ids[0], ids[2], ids[3]}});
  } else {
    out.insert(out.end(), {Face{ids[0], ids[1], ids[3]}, Face{ids[1], ids[2], ids[3]}});
  }
}

}  // namespace

void triangulatePolygon(std::span<const Index> ids, std::span<const Point> points,
                        std::span<const std::uint8_t> sides, std::vector<Face>& out) {
  assert(ids.size() >= 3 && points.size() == ids.size() && sides.size() == ids.size());
  if (ids.size() == 3) {
    assert((sides[0] & sides[1] & sides[2]) == 0);
    out.push_back({ids[0], ids[1], ids[2]});
  } else if (ids.size() == 4) {
    triangulateQuadrilateral(ids, points, sides, out);
  } else {
    EarCutter(ids, points, sides, out).cutAll();
  }
}

}  // namespace graftsman
