#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Gathers points and numbers the different ones by first appearance. Equal means the same coordinates bit
/// for bit, except that −0 is 0; the first one's bits are kept. Precondition: finite coordinates.
///
/// Each addition looks into a hash table. A file made of points that collide there cannot stall it: when the
/// searches get long, an ordered map takes over.
class PointWelder {
 public:
  /// Mean length of the searches that makes the map take over; good hashes stay below 2.
  static constexpr std::size_t kProbesPerPoint = 16;

  /// Room for `expected` different points at first.
  explicit PointWelder(std::size_t expected, std::size_t probesPerPoint = kProbesPerPoint);

  /// The number of the point.
  [[nodiscard]] Index add(const Point& point);

  /// Adds the points one after the other; the number of point i becomes numbers[i]. Faster than one by one.
  void add(std::span<const Point> points, std::span<Index> numbers);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] std::vector<Point> takePoints() { return std::move(points_); }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    Index point = -1;  // −1: free
  };
  using Key = std::array<double, 3>;

  [[nodiscard]] Index addHashed(const Point& point, std::uint32_t hash);
  [[nodiscard]] Index addOrdered(const Point& point);
  Index append(const Point& point);
  void grow();

  std::size_t probesPerPoint_;
  std::size_t probes_ = 0;
  std::size_t additions_ = 0;
  std::vector<Point> points_;
  std::vector<Slot> slots_;  // a power of two many, at most half of them taken
  bool isOrdered_ = false;
  std::map<Key, Index> ordered_;
};

}  // namespace graftsman
