#include "core/fusion/line_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

// The inner loop once more for wider vectors, chosen when the program starts. The operations and their order
// are the same, and -ffp-contract=off keeps them apart, so that every copy gives the same bits. Sanitizers do
// not get along with the choice at program start.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GRAFTSMAN_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define GRAFTSMAN_VECTOR_CLONES
#endif

namespace graftsman {
namespace {

constexpr int kBlock = 256;  // points that stay in the nearest cache while all lines pass over them
constexpr int kFastest = 8;  // greatest falloff by multiplication; single precision does not underflow there

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

// Eqs. 4–8 for one line and the points of a block.
GRAFTSMAN_VECTOR_CLONES
void LineField::addLine(const FastLine& line, int falloff, Block& block) {
  const FastLine c = line;  // a copy: the compiler need not fear that the block's arrays overlap it
  alignas(64) float x[kBlock];
  alignas(64) float y[kBlock];
  alignas(64) float z[kBlock];
  alignas(64) float w[kBlock];
  for (int j = 0; j < kBlock; ++j) {
    x[j] = (block.xHigh[j] - c.originHigh[0]) + (block.xLow[j] - c.originLow[0]);
    y[j] = (block.yHigh[j] - c.originHigh[1]) + (block.yLow[j] - c.originLow[1]);
    z[j] = (block.zHigh[j] - c.originHigh[2]) + (block.zLow[j] - c.originLow[2]);
    float along = x[j] * c.overLength2[0] + y[j] * c.overLength2[1] + z[j] * c.overLength2[2];
    along = along > 0 ? along : 0;
    along = along < 1 ? along : 1;
    const float dx = x[j] - along * c.edge[0];
    const float dy = y[j] - along * c.edge[1];
    const float dz = z[j] - along * c.edge[2];
    const float distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    w[j] = block.unit[j] * c.length / (c.length + distance);
  }
  if (falloff == 5) {
    for (int j = 0; j < kBlock; ++j) {
      const float square = w[j] * w[j];
      w[j] *= square * square;
    }
  } else {
    float base[kBlock];
    std::copy(w, w + kBlock, base);
    for (int i = 1; i < falloff; ++i) {
      for (int j = 0; j < kBlock; ++j) {
        w[j] *= base[j];
      }
    }
  }
  for (int j = 0; j < kBlock; ++j) {
    const float dx = c.linear[0] * x[j] + c.linear[1] * y[j] + c.linear[2] * z[j] + c.shift[0];
    const float dy = c.linear[3] * x[j] + c.linear[4] * y[j] + c.linear[5] * z[j] + c.shift[1];
    const float dz = c.linear[6] * x[j] + c.linear[7] * y[j] + c.linear[8] * z[j] + c.shift[2];
    block.xMove[j] += w[j] * dx;
    block.yMove[j] += w[j] * dy;
    block.zMove[j] += w[j] * dz;
    block.weight[j] += w[j];
  }
}

void LineField::moveBlock(std::span<Point> points) const {
  Block block = {};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point x = points[i] / size_;
    block.xHigh[i] = static_cast<float>(x.x());
    block.yHigh[i] = static_cast<float>(x.y());
    block.zHigh[i] = static_cast<float>(x.z());
    block.xLow[i] = static_cast<float>(x.x() - static_cast<double>(block.xHigh[i]));
    block.yLow[i] = static_cast<float>(x.y() - static_cast<double>(block.yHigh[i]));
    block.zLow[i] = static_cast<float>(x.z() - static_cast<double>(block.zHigh[i]));
    block.unit[i] = static_cast<float>(1 + x.norm() / longest_);
  }
  for (const FastLine& line : fastLines_) {
    addLine(line, static_cast<int>(falloff_), block);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d sum(block.xMove[i], block.yMove[i], block.zMove[i]);
    const Eigen::Vector3d displacement = sum / static_cast<double>(block.weight[i]);
    points[i] = displacement.allFinite() ? Point(points[i] + size_ * displacement) : moved(points[i]);
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
  for (std::size_t begin = 0; begin < points.size(); begin += kBlock) {
    moveBlock(points.subspan(begin, std::min<std::size_t>(kBlock, points.size() - begin)));
  }
}

}  // namespace graftsman
