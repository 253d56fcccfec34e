#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/base/parallel.h"
#include "core/fusion/adjustment.h"
#include "core/fusion/boundary_lines.h"
#include "core/fusion/line_field.h"
#include "tests/benchmarks/benchmark_main.h"

using namespace graftsman;

namespace {

constexpr int kLines = 8;

std::vector<Point> ring(double bump) {
  std::vector<Point> points;
  for (int i = 0; i < kLines; ++i) {
    const double a = 2 * std::numbers::pi * i / kLines;
    points.emplace_back(std::cos(a), std::sin(a), bump * std::sin(2 * a));
  }
  return points;
}

std::vector<Point> tile(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(unit(random), unit(random), unit(random));
  }
  return points;
}

void countPerVertexAndLine(benchmark::State& state, std::size_t count) {
  const double done = static_cast<double>(state.iterations()) * static_cast<double>(count * kLines);
  state.counters["ns_per_vertex_line"] =
      benchmark::Counter(done / 1e9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// STEP 3 alone, one thread.
void lineField(benchmark::State& state, double falloff) {
  const std::size_t count = 500000;
  const LineField field(boundaryLines(ring(0), ring(0.2), Eigen::Matrix3d::Identity()), 2, falloff);
  const std::vector<Point> given = tile(count);
  std::vector<Point> points = given;
  for (auto _ : state) {
    state.PauseTiming();
    points = given;
    state.ResumeTiming();
    field.move(points);
    benchmark::DoNotOptimize(points.data());
  }
  countPerVertexAndLine(state, count);
}

// All steps, as the fusion runs them.
void adjustAll(benchmark::State& state, int threads) {
  const std::vector<Point> points = tile(500000);
  const std::vector<Point> part = ring(0);
  const std::vector<Point> base = ring(0.2);
  setThreadCount(threads);
  for (auto _ : state) {
    benchmark::DoNotOptimize(adjust(points, part, base, {}, {}));
  }
  setThreadCount(0);
  countPerVertexAndLine(state, points.size());
}

}  // namespace

BENCHMARK_CAPTURE(lineField, paper, 5.0)->Name("line_field/ours/500k")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lineField, any, 4.5)
    ->Name("line_field_any_falloff/ours/500k")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(adjustAll, one, 1)->Name("adjust/ours/500k")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(adjustAll, two, 2)
    ->Name("adjust_two_threads/ours/500k")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

GRAFTSMAN_BENCHMARK_MAIN();
