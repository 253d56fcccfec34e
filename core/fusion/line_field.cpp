#include "core/fusion/line_field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/vector_clones.h"

namespace graftsman {
namespace {

constexpr int kFastest = 8;  // greatest falloff by multiplication; single precision does not underflow there

// Range of a point's sums in which no weight that matters was lost.
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
  alignas(64) float unit[kBlock];  // common factor of a point's weights, against underflow far away
  alignas(64) float weight[kBlock];
  alignas(64) float xMove[kBlock];
  alignas(64) float yMove[kBlock];
  alignas(64) float zMove[kBlock];
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
    longest_ = std::max(longest_, length);
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
  const float unitScale = static_cast<float>(1 / longest_);
  for (std::size_t j = 0; j < kBlock; ++j) {
    const double x = coordinates[3 * j] * scale;
    const double y = coordinates[3 * j + 1] * scale;
    const double z = coordinates[3 * j + 2] * scale;
    const auto xHigh = static_cast<float>(x);
    const auto yHigh = static_cast<float>(y);
    const auto zHigh = static_cast<float>(z);
    block.xHigh[j] = xHigh;
    block.yHigh[j] = yHigh;
    block.zHigh[j] = zHigh;
    block.xLow[j] = static_cast<float>(x - static_cast<double>(xHigh));
    block.yLow[j] = static_cast<float>(y - static_cast<double>(yHigh));
    block.zLow[j] = static_cast<float>(z - static_cast<double>(zHigh));
    block.unit[j] = 1 + std::sqrt(xHigh * xHigh + yHigh * yHigh + zHigh * zHigh) * unitScale;
    block.weight[j] = 0;
    block.xMove[j] = 0;
    block.yMove[j] = 0;
    block.zMove[j] = 0;
  }
}

// Eqs. 4–8 for one line and the points of a block; `power` is x ↦ x^n.
GRAFTSMAN_INLINE void LineField::addLine(const FastLine& line, Block& block, auto power) {
  const FastLine c = line;  // a copy: the compiler need not fear that the block's arrays overlap it
  for (std::size_t j = 0; j < kBlock; ++j) {
    const float x = (block.xHigh[j] - c.originHigh[0]) + (block.xLow[j] - c.originLow[0]);
    const float y = (block.yHigh[j] - c.originHigh[1]) + (block.yLow[j] - c.originLow[1]);
    const float z = (block.zHigh[j] - c.originHigh[2]) + (block.zLow[j] - c.originLow[2]);
    const float t = x * c.overLength2[0] + y * c.overLength2[1] + z * c.overLength2[2];
    const float along = 0.5F * (std::abs(t) - std::abs(t - 1) + 1);  // t clamped to [0, 1], without a branch
    const float dx = x - along * c.edge[0];
    const float dy = y - along * c.edge[1];
    const float dz = z - along * c.edge[2];
    const float distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const float w = power(block.unit[j] * c.length / (c.length + distance));
    const float xMove = c.linear[0] * x + c.linear[1] * y + c.linear[2] * z + c.shift[0];
    const float yMove = c.linear[3] * x + c.linear[4] * y + c.linear[5] * z + c.shift[1];
    const float zMove = c.linear[6] * x + c.linear[7] * y + c.linear[8] * z + c.shift[2];
    block.xMove[j] += w * xMove;
    block.yMove[j] += w * yMove;
    block.zMove[j] += w * zMove;
    block.weight[j] += w;
  }
}

// All lines for a block, with n = 5 as the paper has it, and any other n up to kFastest.
GRAFTSMAN_VECTOR_CLONES
void LineField::addLines(Block& block) const {
  if (falloff_ == 5) {
    for (const FastLine& line : fastLines_) {
      addLine(line, block, [](float x) { return (x * x) * (x * x) * x; });
    }
    return;
  }
  const auto n = static_cast<unsigned>(falloff_);
  for (const FastLine& line : fastLines_) {
    addLine(line, block, [n](float x) {
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

// Whether single precision neither over- nor underflowed, as it does for points very far away.
GRAFTSMAN_INLINE bool LineField::isRight(const Block& block, std::size_t j) {
  const float sum = std::abs(block.xMove[j]) + std::abs(block.yMove[j]) + std::abs(block.zMove[j]);
  return block.weight[j] > kSmallestSum && block.weight[j] < kGreatestSum && sum < kGreatestSum;
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
  for (std::size_t j = 0; j < kBlock; ++j) {
    const float factor = 1 / block.weight[j];
    coordinates[3 * j] += size_ * static_cast<double>(factor * block.xMove[j]);
    coordinates[3 * j + 1] += size_ * static_cast<double>(factor * block.yMove[j]);
    coordinates[3 * j + 2] += size_ * static_cast<double>(factor * block.zMove[j]);
  }
}

void LineField::moveBlock(std::span<Point, kBlock> points) const {
  Block block;
  load(points[0].data(), block);
  addLines(block);
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
    moveBlock(points.first<kBlock>());
  }
  if (!points.empty()) {
    std::array<Point, kBlock> rest;
    rest.fill(points[0]);
    std::copy(points.begin(), points.end(), rest.begin());
    moveBlock(rest);
    std::copy_n(rest.begin(), points.size(), points.begin());
  }
}

}  // namespace graftsman
