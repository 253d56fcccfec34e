#include "core/fusion/blend.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/parallel.h"

namespace graftsman {
namespace {

// From here on starting threads costs less than it saves.
constexpr std::size_t kManyVertices = 1 << 18;
constexpr std::size_t kGrain = 1 << 16;

// Weights at a time: they stay in the nearest cache.
constexpr std::size_t kBlock = 512;

void blendRange(const CombinedTile& combined, const FCF& fcf, std::span<const Index> target,
                std::span<Point> out, std::size_t begin, std::size_t end) {
  std::array<double, kBlock> weights;
  for (; begin < end; begin += kBlock) {
    const std::size_t size = std::min(kBlock, end - begin);
    fcf.evaluate(std::span(combined.s).subspan(begin, size), std::span(weights).first(size));
    for (std::size_t j = 0; j < size; ++j) {
      const std::size_t i = begin + j;
      const double f = weights[j];
      const Point& part = combined.part[i];
      const Point& base = combined.base[i];
      Point& v = out[static_cast<std::size_t>(target[i])];
      if (f == 0) {  // not by Eq. 1: 0 · v¹ + v² turns −0 into 0
        v = base;
      } else if (f == 1) {
        v = part;
      } else {
        v = f * part + (1 - f) * base;
      }
    }
  }
}

}  // namespace

void blend(const CombinedTile& combined, const FCF& fcf, std::span<const Index> target,
           std::span<Point> out) {
  const std::size_t count = combined.s.size();
  assert(combined.part.size() == count && combined.base.size() == count && target.size() == count);
  if (count <= kManyVertices) {
    blendRange(combined, fcf, target, out, 0, count);
    return;
  }
  parallelRanges(count, kGrain, [&](std::size_t begin, std::size_t end) {
    blendRange(combined, fcf, target, out, begin, end);
  });
}

}  // namespace graftsman
