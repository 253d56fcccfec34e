// What a drag of a curve point costs the result's pane before anything is drawn: positions and normals of a
// result of about 200,000 vertices, nearly all of them in the tile.

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "core/base/parallel.h"
#include "core/fusion/update.h"
#include "tests/benchmarks/benchmark_main.h"
#include "tests/support/shapes.h"
#include "widgets/viewport/morph_surface.h"

namespace {

using namespace graftsman;

/// A fusion of two tori that are turned against each other; the tile is most of a half of the surface.
FusionResults fusion(Index n) {
  const shapes::MeshPtr base = shapes::torus(n, n);
  std::vector<Point> moved = base->points();
  const Eigen::AngleAxisd turn(0.7, Point(1, 2, 3).normalized());
  for (Point& p : moved) {
    p = turn * p * 1.3;
  }
  FusionInputs inputs;
  inputs.base = base;
  inputs.part = std::make_shared<TriangleMesh>(std::move(moved), base->faces());
  for (int k = 0; k < 8; ++k) {
    const double angle = 2 * std::numbers::pi * k / 8;
    const auto i = static_cast<Index>(n * (0.5 + 0.35 * std::cos(angle)));
    const auto j = static_cast<Index>(n * (0.5 + 0.35 * std::sin(angle)));
    const auto shifted = static_cast<Index>(n * (0.5 + 0.35 * std::sin(angle + 0.1)));
    inputs.loop.push_back({SurfacePoint::atVertex(i * n + shifted), SurfacePoint::atVertex(i * n + j)});
  }
  FusionResults results = update(inputs, {}, {});
  if (results.error) {
    std::fprintf(stderr, "%s\n", results.error->message.c_str());
    std::exit(1);
  }
  return results;
}

constexpr Index kSize = 300;

const FusionResults& sharedFusion() {
  static const FusionResults kResults = fusion(kSize);
  return kResults;
}

FCF curve(double f) {
  return FCF::through({{0, 0}, {0.3, f}, {0.7, 0.9}, {1, 1}}).value();
}

void curveDrag(benchmark::State& state, int threads) {
  setThreadCount(threads);
  const FusionResults& results = sharedFusion();
  MorphSurface surface(results.join, results.combined, results.inputs.fcf);
  double f = 0.1;
  for (auto _ : state) {
    surface.setCurve(curve(f));
    benchmark::ClobberMemory();
    f = f < 0.8 ? f + 0.001 : 0.1;
  }
  state.counters["tile vertices"] = static_cast<double>(surface.layout().tileSize);
  state.counters["vertices"] = static_cast<double>(results.join->points.size());
  setThreadCount(0);
}

void prepare(benchmark::State& state) {
  const FusionResults& results = sharedFusion();
  for (auto _ : state) {
    const MorphSurface surface(results.join, results.combined, results.inputs.fcf);
    benchmark::DoNotOptimize(surface.tile().positions);
  }
}

BENCHMARK_CAPTURE(curveDrag, one_thread, 1)->Name("morph/curve_drag/1_thread")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curveDrag, threads, 0)->Name("morph/curve_drag/threads")->Unit(benchmark::kMillisecond);
BENCHMARK(prepare)->Name("morph/prepare")->Unit(benchmark::kMillisecond);

}  // namespace

GRAFTSMAN_BENCHMARK_MAIN();
