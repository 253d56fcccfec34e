#include "core/io/weld.h"

#include <algorithm>
#include <bit>

namespace graftsman {
namespace {

constexpr std::size_t kBatch = 96;        // points, of 32 facets
constexpr std::size_t kFewPoints = 1024;  // below so many additions the mean search says nothing

std::uint64_t mix(std::uint64_t bits) {
  // The finalizer of SplitMix64 (Steele, Lea and Flood 2014).
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31);
}

// Adding zero turns −0 into 0 and changes nothing else.
std::uint64_t bitsOf(double coordinate) {
  return std::bit_cast<std::uint64_t>(coordinate + 0.0);
}

std::uint32_t hashOf(const Point& p) {
  return static_cast<std::uint32_t>(mix(0x9e3779b97f4a7c15U * bitsOf(p.x()) +
                                        0xc2b2ae3d27d4eb4fU * bitsOf(p.y()) +
                                        0x165667b19e3779f9U * bitsOf(p.z())));
}

}  // namespace

PointWelder::PointWelder(std::size_t expected, std::size_t probesPerPoint)
    : probesPerPoint_(probesPerPoint), slots_(std::bit_ceil(std::max<std::size_t>(2 * expected, 16))) {
  points_.reserve(expected);
}

Index PointWelder::append(const Point& point) {
  points_.push_back(point);
  return static_cast<Index>(points_.size() - 1);
}

Index PointWelder::add(const Point& point) {
  return isOrdered_ ? addOrdered(point) : addHashed(point, hashOf(point));
}

// The table is larger than the caches: what a batch of points needs is asked for in advance.
void PointWelder::add(std::span<const Point> points, std::span<Index> numbers) {
  std::array<std::uint32_t, kBatch> hashes;
  for (std::size_t first = 0; first < points.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, points.size() - first);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      hashes[i] = hashOf(points[first + i]);
      __builtin_prefetch(slots_.data() + (hashes[i] & mask));
    }
    for (std::size_t i = 0; i < count && !isOrdered_; ++i) {
      const Index point = slots_[hashes[i] & mask].point;
      __builtin_prefetch(points_.data() + std::max(point, 0));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Point& point = points[first + i];
      numbers[first + i] = isOrdered_ ? addOrdered(point) : addHashed(point, hashes[i]);
    }
  }
}

Index PointWelder::addHashed(const Point& point, std::uint32_t hash) {
  ++additions_;
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
    Slot& slot = slots_[at];
    if (slot.point < 0) {
      slot = {hash, append(point)};
      const Index number = slot.point;
      if (2 * points_.size() > slots_.size()) {
        grow();
      }
      return number;
    }
    if (slot.hash == hash && points_[static_cast<std::size_t>(slot.point)] == point) {
      return slot.point;
    }
    if (++probes_ > probesPerPoint_ * (additions_ + kFewPoints)) {
      isOrdered_ = true;
      slots_ = {};
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const Point& p = points_[i];
        ordered_.try_emplace({p.x(), p.y(), p.z()}, static_cast<Index>(i));
      }
      return addOrdered(point);
    }
  }
}

// The keys' order is that of numbers, in which −0 and 0 are one.
Index PointWelder::addOrdered(const Point& point) {
  const auto [found, isNew] =
      ordered_.try_emplace({point.x(), point.y(), point.z()}, static_cast<Index>(points_.size()));
  return isNew ? append(point) : found->second;
}

void PointWelder::grow() {
  std::vector<Slot> larger(2 * slots_.size());
  const std::size_t mask = larger.size() - 1;
  for (const Slot& slot : slots_) {
    if (slot.point >= 0) {
      std::size_t at = slot.hash & mask;
      while (larger[at].point >= 0) {
        at = (at + 1) & mask;
      }
      larger[at] = slot;
    }
  }
  slots_ = std::move(larger);
}

}  // namespace graftsman
