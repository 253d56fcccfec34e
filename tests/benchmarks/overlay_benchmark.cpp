#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <set>

#include "core/base/parallel.h"
#include "core/fusion/combined_tile.h"
#include "tests/support/embeddings.h"

// The overlay of two embedded tiles against CGAL's overlay of the same two planar subdivisions. The argument
// is the number of faces of each tile. `bytes` is what is held of the heap when the overlay is done, inputs
// apart; `peak` the most held at once during it.

namespace {

using namespace graftsman;

struct Tiles {
  shapes::TestTile part;
  shapes::TestTile base;
};

// n faces each, with boundaries as long as a square cut-out's.
const Tiles& tiles(std::int64_t faces) {
  static std::map<std::int64_t, Tiles> made;
  const auto found = made.find(faces);
  if (found != made.end()) {
    return found->second;
  }
  const auto interior = static_cast<Index>(faces / 2);
  const auto perSide = static_cast<Index>(0.8 * std::sqrt(static_cast<double>(interior)));
  return made
      .emplace(faces, Tiles{shapes::randomTile(1, 5, perSide, interior),
                            shapes::randomTile(2, 5, perSide, interior)})
      .first->second;
}

double heapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

void ours(benchmark::State& state) {
  const Tiles& input = tiles(state.range(0));
  setThreadCount(1);
  double vertices = 0;
  double bytes = 0;
  double peak = 0;
  for (auto _ : state) {
    const double before = heapInUse();
    const auto combined = overlay(input.part.view(), input.base.view(), {});
    bytes = heapInUse() - before;
    if (!combined) {
      state.SkipWithError(combined.error().message.c_str());
      break;
    }
    vertices = static_cast<double>(combined->uv.size());
    benchmark::DoNotOptimize(combined->uv.data());
  }
  // Once more, looking at the heap whenever a step reports.
  const double before = heapInUse();
  const Progress watching(
      [&](double) {
        peak = std::max(peak, heapInUse() - before);
        return true;
      },
      std::chrono::milliseconds(0));
  benchmark::DoNotOptimize(overlay(input.part.view(), input.base.view(), watching));
  state.counters["vertices"] = vertices;
  state.counters["bytes"] = bytes;
  state.counters["peak"] = peak;
}

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;

Arrangement arrangement(const Embedding& embedding) {
  std::vector<Kernel::Point_2> points;
  for (const Point2& p : embedding.uv) {
    points.emplace_back(p.x(), p.y());
  }
  std::set<std::pair<Index, Index>> edges;
  for (const Face& f : embedding.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.insert(std::minmax(f[k], f[(k + 1) % 3]));
    }
  }
  std::vector<Traits::X_monotone_curve_2> curves;
  for (const auto& [a, b] : edges) {
    curves.emplace_back(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)]);
  }
  Arrangement result;
  CGAL::insert_non_intersecting_curves(result, curves.begin(), curves.end());
  return result;
}

// Building the two arrangements is not counted.
void cgalArrangement(benchmark::State& state) {
  const Tiles& input = tiles(state.range(0));
  const Arrangement part = arrangement(input.part.embedding);
  const Arrangement base = arrangement(input.base.embedding);
  double vertices = 0;
  double bytes = 0;
  for (auto _ : state) {
    const double before = heapInUse();
    Arrangement result;
    CGAL::overlay(part, base, result);
    bytes = heapInUse() - before;
    vertices = static_cast<double>(result.number_of_vertices());
  }
  state.counters["vertices"] = vertices;
  state.counters["bytes"] = bytes;
}

}  // namespace

BENCHMARK(ours)->Name("overlay/ours/5k")->Arg(5'000)->Unit(benchmark::kMillisecond);
BENCHMARK(ours)->Name("overlay/ours/50k")->Arg(50'000)->Unit(benchmark::kMillisecond);
BENCHMARK(ours)->Name("overlay/ours/500k")->Arg(500'000)->Unit(benchmark::kMillisecond);
BENCHMARK(cgalArrangement)
    ->Name("overlay/cgal_arrangement/5k")
    ->Arg(5'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(cgalArrangement)
    ->Name("overlay/cgal_arrangement/50k")
    ->Arg(50'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

BENCHMARK_MAIN();
