#include "core/fusion/line_field.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/vector_clones.h"

namespace graftsman {
namespace {

constexpr int kFastest = 8;  // greatest falloff by multiplication; only points very far away underflow there

// Range of a point's sums in which no weight that matters was lost. Beyond, double precision takes over.
constexpr float kSmallestSum = 1e-25F;
constexpr float kGreatestSum = 1e30F;

}  // namespace

/// Points in units of the loop's size, and sums over the lines.
struct LineField::Block {
  alignas(64) float xHigh[kBlock];  // x = high + low, so that differences near 0 keep all their digits
  alignas(64) float yHigh[kBlock];
  alignas(64) float zHigh[kBlock];
  alignas(64) float xLow[kBlock];
  alignas(64) float yLow[kBlock];
  alignas(64) float zLow[kBlock];
  alignas(64) float weight[kBlock];
  alignas(64) float xMove[kBlock];
  alignas(64) float yMove[kBlock];
  alignas(64) float zMove[kBlock];
};

/// Between the two halves of a line's pass. In one loop the square root and the division would wait for each
/// other: the processor does not look far enough ahead to fill both waits.
struct LineField::Approach {
  alignas(64) float x[kBlock];  // from the line's origin
  alignas(64) float y[kBlock];
  alignas(64) float z[kBlock];
  alignas(64) float reach[kBlock];  // l + d
};

LineField::LineField(std::vector<BoundaryLine> lines, double size, double falloff)
    : lines_(std::move(lines)), size_(size), falloff_(falloff) {
  assert(!lines_.empty() && size > 0 && falloff > 0);
  fastLines_.reserve(lines_.size());
  for (const BoundaryLine& line : lines_) {
    const Point origin = line.origin / size;
    const Eigen::Vector3d edge = line.edge / size;
    const Eigen::Vector3d shift = (line.image - line.origin) / size;
    const double length = edge.norm();
    FastLine fast = {};
    for (int i = 0; i < 3; ++i) {
      fast.originHigh[i] = static_cast<float>(origin[i]);
      fast.originLow[i] = static_cast<float>(origin[i] - static_cast<double>(fast.originHigh[i]));
      fast.edge[i] = static_cast<float>(edge[i]);
      fast.overLength2[i] = static_cast<float>(edge[i] / (length * length));
      fast.shift[i] = static_cast<float>(shift[i]);
      for (int j = 0; j < 3; ++j) {
        fast.linear[3 * i + j] = static_cast<float>(line.linear(i, j) - (i == j ? 1 : 0));
      }
    }
    fast.length = static_cast<float>(length);
    fastLines_.push_back(fast);
  }
}

// Puts the points, `coordinates` of them three each, into a block.
GRAFTSMAN_VECTOR_CLONES
void LineField::load(const double* coordinates, Block& block) const {
  const double scale = 1 / size_;
  // As they lie in memory first: conversions in order, and only then the dealing out of the narrow numbers.
  alignas(64) float high[3 * kBlock];
  alignas(64) float low[3 * kBlock];
  for (std::size_t i = 0; i < 3 * kBlock; ++i) {
    const double x = coordinates[i] * scale;
    high[i] = static_cast<float>(x);
    low[i] = static_cast<float>(x - static_cast<double>(high[i]));
  }
  for (std::size_t j = 0; j < kBlock; ++j) {
    block.xHigh[j] = high[3 * j];
    block.yHigh[j] = high[3 * j + 1];
    block.zHigh[j] = high[3 * j + 2];
    block.xLow[j] = low[3 * j];
    block.yLow[j] = low[3 * j + 1];
    block.zLow[j] = low[3 * j + 2];
    block.weight[j] = 0;
    block.xMove[j] = 0;
    block.yMove[j] = 0;
    block.zMove[j] = 0;
  }
}

// Eqs. 4 and 8 for one line and the points of a block, up to the power n.
GRAFTSMAN_INLINE void LineField::approach(const FastLine& line, const Block& block, Approach& to) {
  const FastLine c = line;  // a copy: the compiler need not fear that the block's arrays overlap it
  for (std::size_t j = 0; j < kBlock; ++j) {
    const float x = (block.xHigh[j] - c.originHigh[0]) + (block.xLow[j] - c.originLow[0]);
    const float y = (block.yHigh[j] - c.originHigh[1]) + (block.yLow[j] - c.originLow[1]);
    const float z = (block.zHigh[j] - c.originHigh[2]) + (block.zLow[j] - c.originLow[2]);
    const float t = std::fma(z, c.overLength2[2], std::fma(y, c.overLength2[1], x * c.overLength2[0]));
    const float along = std::min(std::max(t, 0.0F), 1.0F);
    const float dx = std::fma(-along, c.edge[0], x);
    const float dy = std::fma(-along, c.edge[1], y);
    const float dz = std::fma(-along, c.edge[2], z);
    to.x[j] = x;
    to.y[j] = y;
    to.z[j] = z;
    to.reach[j] = c.length + std::sqrt(std::fma(dz, dz, std::fma(dy, dy, dx * dx)));
  }
}

// Eqs. 5–8, the line's share in the sums of Eq. 7; `power` is x ↦ x^n.
GRAFTSMAN_INLINE void LineField::addLine(const FastLine& line, const Approach& from, Block& block,
                                         auto power) {
  const FastLine c = line;
  for (std::size_t j = 0; j < kBlock; ++j) {
    const auto move = [&](int i) {
      const float* row = c.linear + 3 * i;
      return std::fma(from.z[j], row[2],
                      std::fma(from.y[j], row[1], std::fma(from.x[j], row[0], c.shift[i])));
    };
    const float w = power(c.length / from.reach[j]);
    block.xMove[j] = std::fma(w, move(0), block.xMove[j]);
    block.yMove[j] = std::fma(w, move(1), block.yMove[j]);
    block.zMove[j] = std::fma(w, move(2), block.zMove[j]);
    block.weight[j] += w;
  }
}

// All lines for a block, with n = 5 as the paper has it, and any other n up to kFastest. Meanwhile the points
// of the next block come from memory, a share with each line.
GRAFTSMAN_VECTOR_CLONES
void LineField::addLines(Block& block, std::span<const Point> next) const {
  const std::size_t share = next.size() / fastLines_.size() + 1;
  const auto fetchShare = [&] {
    const std::span<const Point> fetched = next.first(std::min(share, next.size()));
    for (std::size_t i = 0; i < fetched.size(); i += 2) {  // a cache line holds less than three
      __builtin_prefetch(&fetched[i], 1);
    }
    next = next.subspan(fetched.size());
  };
  Approach between;
  if (falloff_ == 5) {
    for (const FastLine& line : fastLines_) {
      fetchShare();
      approach(line, block, between);
      addLine(line, between, block, [](float x) { return (x * x) * (x * x) * x; });
    }
    return;
  }
  const auto n = static_cast<unsigned>(falloff_);
  for (const FastLine& line : fastLines_) {
    fetchShare();
    approach(line, block, between);
    addLine(line, between, block, [n](float x) {
      float power = n & 1 ? x : 1;
      x *= x;
      power = n & 2 ? power * x : power;
      x *= x;
      power = n & 4 ? power * x : power;
      x *= x;
      return n & 8 ? power * x : power;
    });
  }
}

// Whether single precision neither over- nor underflowed, as it does for points very far away. In bits,
// which numbers of one sign order alike: the compiler takes every float of this file for finite.
GRAFTSMAN_INLINE bool LineField::isRight(const Block& block, std::size_t j) {
  const auto bits = [](float number) { return std::bit_cast<std::uint32_t>(number); };
  const float sum = std::abs(block.xMove[j]) + std::abs(block.yMove[j]) + std::abs(block.zMove[j]);
  return bits(block.weight[j]) > bits(kSmallestSum) && bits(block.weight[j]) < bits(kGreatestSum) &&
         bits(sum) < bits(kGreatestSum);
}

GRAFTSMAN_VECTOR_CLONES
bool LineField::areRight(const Block& block) {
  int wrong = 0;
  for (std::size_t j = 0; j < kBlock; ++j) {
    wrong |= isRight(block, j) ? 0 : 1;
  }
  return wrong == 0;
}

// Eq. 7.
GRAFTSMAN_VECTOR_CLONES
void LineField::store(const Block& block, double* coordinates) const {
  alignas(64) float moves[3 * kBlock];
  for (std::size_t j = 0; j < kBlock; ++j) {
    const float factor = 1 / block.weight[j];
    moves[3 * j] = factor * block.xMove[j];
    moves[3 * j + 1] = factor * block.yMove[j];
    moves[3 * j + 2] = factor * block.zMove[j];
  }
  for (std::size_t i = 0; i < 3 * kBlock; ++i) {
    coordinates[i] += size_ * static_cast<double>(moves[i]);
  }
}

void LineField::moveBlock(std::span<Point, kBlock> points, std::span<const Point> next) const {
  Block block;
  load(points[0].data(), block);
  addLines(block, next);
  if (areRight(block)) {
    store(block, points[0].data());
    return;
  }
  std::array<Point, kBlock> given;
  std::copy(points.begin(), points.end(), given.begin());
  store(block, points[0].data());
  for (std::size_t j = 0; j < kBlock; ++j) {
    if (!isRight(block, j)) {
      points[j] = moved(given[j]);
    }
  }
}

// The same in double precision, for any falloff.
Point LineField::moved(const Point& point) const {
  const auto nearness = [&](const BoundaryLine& line) {
    const Eigen::Vector3d u = point - line.origin;
    const double length = line.edge.norm();
    const double along = std::clamp(u.dot(line.edge / length) / length, 0.0, 1.0);
    return length / (length + (u - along * line.edge).norm());
  };
  double nearest = 0;
  for (const BoundaryLine& line : lines_) {
    nearest = std::max(nearest, nearness(line));
  }
  double weight = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const BoundaryLine& line : lines_) {
    const double w = std::pow(nearness(line) / nearest, falloff_);  // relative: the nearest has weight 1
    sum += w * (line.linear * (point - line.origin) + (line.image - point));
    weight += w;
  }
  return point + sum / weight;
}

void LineField::move(std::span<Point> points) const {
  const bool fast = falloff_ <= kFastest && falloff_ == std::floor(falloff_);
  if (!fast) {
    for (Point& point : points) {
      point = moved(point);
    }
    return;
  }
  for (; points.size() >= kBlock; points = points.subspan(kBlock)) {
    moveBlock(points.first<kBlock>(), points.subspan(kBlock, std::min(kBlock, points.size() - kBlock)));
  }
  if (!points.empty()) {
    std::array<Point, kBlock> rest;
    rest.fill(points[0]);
    std::copy(points.begin(), points.end(), rest.begin());
    moveBlock(rest, {});
    std::copy_n(rest.begin(), points.size(), points.begin());
  }
}

}  // namespace graftsman
