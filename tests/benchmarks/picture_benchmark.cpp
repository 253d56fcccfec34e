#include <benchmark/benchmark.h>

#include "core/picture/draw.h"
#include "tests/benchmarks/benchmark_main.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

// A bumpy torus of about 100k faces, seen from a little above.
void drawOurs(benchmark::State& state) {
  const auto mesh = shapes::torus(320, 160, 0.4);
  std::vector<Point> points = mesh->points();
  for (Point& p : points) {
    p *= 1 + 0.03 * std::sin(9 * p.x()) * std::sin(7 * p.y());
  }
  const PictureSize size = {static_cast<int>(state.range(0)), static_cast<int>(state.range(1))};
  const PictureCamera camera =
      frame(points, {{0.3, -1, 0.8}}, static_cast<double>(size.width) / static_cast<double>(size.height));
  for (auto _ : state) {
    benchmark::DoNotOptimize(draw(points, mesh->faces(), camera, size));
  }
}

void png(benchmark::State& state) {
  const auto mesh = shapes::torus(320, 160, 0.4);
  const PictureCamera camera = frame(mesh->points(), {{0.3, -1, 0.8}}, 4.0 / 3);
  const Picture picture = draw(mesh->points(), mesh->faces(), camera, {256, 192});
  for (auto _ : state) {
    benchmark::DoNotOptimize(formatPng(picture));
  }
}

}  // namespace

BENCHMARK(drawOurs)->Name("picture/ours/100k/256x192")->Args({256, 192})->Unit(benchmark::kMillisecond);
BENCHMARK(drawOurs)->Name("picture/ours/100k/1280x720")->Args({1280, 720})->Unit(benchmark::kMillisecond);
BENCHMARK(png)->Name("picture/png/256x192")->Unit(benchmark::kMillisecond);

GRAFTSMAN_BENCHMARK_MAIN();
