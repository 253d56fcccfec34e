#include <benchmark/benchmark.h>

#include <numeric>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/blend.h"
#include "tests/benchmarks/benchmark_main.h"

using namespace graftsman;

namespace {

CombinedTile tile(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  CombinedTile result;
  for (std::size_t i = 0; i < count; ++i) {
    result.part.emplace_back(unit(random), unit(random), unit(random));
    result.base.emplace_back(unit(random), unit(random), unit(random));
    result.s.push_back(unit(random));
  }
  return result;
}

std::vector<Index> targets(std::size_t count) {
  std::vector<Index> result(count);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

// Bytes that the blend of one vertex reads and writes: two positions, s, target; one position.
constexpr std::size_t kBytes = 2 * sizeof(Point) + sizeof(double) + sizeof(Index) + sizeof(Point);

void blendOurs(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const CombinedTile combined = tile(count);
  const std::vector<Index> target = targets(count);
  const FCF fcf = FCF::preset(FCF::Preset::KeepBaseSlope);
  std::vector<Point> out(count);
  setThreadCount(1);
  for (auto _ : state) {
    blend(combined, fcf, target, out);
    benchmark::ClobberMemory();
  }
  setThreadCount(0);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(count * kBytes));
}

// STREAM's triad, a = b + q c, over as many bytes as the blend of so many vertices touches.
void triad(benchmark::State& state) {
  const std::size_t count = static_cast<std::size_t>(state.range(0)) * kBytes / (3 * sizeof(double));
  std::vector<double> a(count, 0);
  const std::vector<double> b(count, 1.5);
  const std::vector<double> c(count, 2.5);
  for (auto _ : state) {
    double* const to = a.data();
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = b[i] + 3.0 * c[i];
    }
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(3 * sizeof(double) * count));
}

// The curve alone, for many s.
void evaluate(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<double> s = tile(count).s;
  const FCF fcf = FCF::preset(FCF::Preset::KeepBaseSlope);
  std::vector<double> out(count);
  for (auto _ : state) {
    fcf.evaluate(s, out);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

// What each mouse move of a curve point costs the core: a new curve and the blend.
void curveDrag(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const CombinedTile combined = tile(count);
  const std::vector<Index> target = targets(count);
  std::vector<Point> out(count);
  double f = 0.1;
  for (auto _ : state) {
    const Result<FCF> fcf = FCF::through({{0, 0}, {0.3, f}, {0.7, 0.9}, {1, 1}});
    blend(combined, *fcf, target, out);
    benchmark::ClobberMemory();
    f = f < 0.8 ? f + 0.001 : 0.1;
  }
}

}  // namespace

BENCHMARK(blendOurs)->Name("blend/ours/200k")->Arg(200000)->Unit(benchmark::kMillisecond);
BENCHMARK(triad)->Name("blend/triad/200k")->Arg(200000)->Unit(benchmark::kMillisecond);
BENCHMARK(blendOurs)->Name("blend/ours/1M")->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(triad)->Name("blend/triad/1M")->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(evaluate)->Name("fcf_evaluate/ours/200k")->Arg(200000)->Unit(benchmark::kMillisecond);
BENCHMARK(curveDrag)->Name("curve_drag/ours/200k")->Arg(200000)->Unit(benchmark::kMillisecond);

GRAFTSMAN_BENCHMARK_MAIN();
