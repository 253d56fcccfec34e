#include "core/fusion/blend.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/parallel.h"
#include "core/base/vector_clones.h"

namespace graftsman {
namespace {

// From here on starting threads costs less than it saves.
constexpr std::size_t kManyVertices = 1 << 18;
constexpr std::size_t kBlendGrain = 1 << 16;

// Weights at a time: few enough that the positions which are asked for meanwhile find room in the nearest
// cache.
constexpr std::size_t kBlendBlock = 64;

// Eq. 1. Not by the formula where f is 0 or 1: 0 · v¹ + v² turns −0 into 0.
GRAFTSMAN_INLINE double mix(double f, double part, double base) {
  const double mixed = f * part + (1 - f) * base;
  const double notPart = f == 0 ? base : mixed;
  return f == 1 ? part : notPart;
}

// Whether the vertices go to consecutive places.
bool isRun(std::span<const Index> target) {
  Index steps = 0;
  for (std::size_t i = 1; i < target.size(); ++i) {
    steps |= (target[i] - target[i - 1]) ^ 1;
  }
  return steps == 0;
}

// Coordinates of a block as one list, with the weight of each.
GRAFTSMAN_VECTOR_CLONES
void blendRun(const double* weights, const double* part, const double* base, double* out, std::size_t size) {
  std::array<double, 3 * kBlendBlock> weight;
  for (std::size_t j = 0; j < size; ++j) {
    weight[3 * j] = weights[j];
    weight[3 * j + 1] = weights[j];
    weight[3 * j + 2] = weights[j];
  }
  for (std::size_t j = 0; j < 3 * size; ++j) {
    out[j] = mix(weight[j], part[j], base[j]);
  }
}

// Asks for the positions before they are needed: they arrive while the weights are computed.
void prefetch(const Point* points, std::size_t size) {
  constexpr std::size_t kLine = 64;
  const auto* const bytes = reinterpret_cast<const char*>(points);
  for (std::size_t i = 0; i < size * sizeof(Point); i += kLine) {
    __builtin_prefetch(bytes + i);
  }
}

void blendRange(const CombinedTile& combined, const FCF& fcf, std::span<const Index> target,
                std::span<Point> out, std::size_t begin, std::size_t end) {
  std::array<double, kBlendBlock> weights;
  for (; begin < end; begin += kBlendBlock) {
    const std::size_t size = std::min(kBlendBlock, end - begin);
    const std::span<const Index> to = target.subspan(begin, size);
    prefetch(combined.part.data() + begin, size);
    prefetch(combined.base.data() + begin, size);
    fcf.evaluate(std::span(combined.s).subspan(begin, size), std::span(weights).first(size));
    if (isRun(to)) {
      blendRun(weights.data(), combined.part[begin].data(), combined.base[begin].data(),
               out[static_cast<std::size_t>(to[0])].data(), size);
      continue;
    }
    for (std::size_t j = 0; j < size; ++j) {
      const Point& part = combined.part[begin + j];
      const Point& base = combined.base[begin + j];
      Point& v = out[static_cast<std::size_t>(to[j])];
      for (Eigen::Index k = 0; k < 3; ++k) {
        v[k] = mix(weights[j], part[k], base[k]);
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
  parallelRanges(count, kBlendGrain, [&](std::size_t begin, std::size_t end) {
    blendRange(combined, fcf, target, out, begin, end);
  });
}

}  // namespace graftsman
