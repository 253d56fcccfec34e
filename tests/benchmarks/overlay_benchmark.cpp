#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <fstream>
#include <memory>
#include <set>
#include <string>

#include "core/base/parallel.h"
#include "core/fusion/combined_tile.h"
#include "tests/benchmarks/benchmark_main.h"
#include "tests/support/embeddings.h"

// The overlay of two embedded tiles against CGAL's overlay of the same two planar subdivisions. The argument
// is the number of faces of each tile. `bytes` is what the process holds more when the overlay is done;
// `peak` the most that it held more at once.

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

/// How much memory the process holds, in bytes: now, and the most since reset().
class Memory {
 public:
  // Gives freed memory back first, so that what is used again counts again.
  static void reset() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
  }
  static double now() { return field("VmRSS:"); }
  static double most() { return field("VmHWM:"); }

 private:
  static double field(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
      double kilobytes = 0;
      if (word == name && status >> kilobytes) {
        return 1024 * kilobytes;
      }
    }
    return 0;
  }
};

/// What one run of `overlayOnce` adds to the process: what its result holds, and the most at once.
template <class OverlayOnce>
void countMemory(benchmark::State& state, OverlayOnce overlayOnce) {
  Memory::reset();
  const double before = Memory::now();
  const auto result = overlayOnce();
  benchmark::DoNotOptimize(&result);
  const double peak = Memory::most() - before;
  malloc_trim(0);
  state.counters["bytes"] = Memory::now() - before;
  state.counters["peak"] = peak;
}

void ours(benchmark::State& state) {
  const Tiles& input = tiles(state.range(0));
  setThreadCount(1);
  double vertices = 0;
  for (auto _ : state) {
    const auto combined = overlay(input.part.view(), input.base.view(), {});
    if (!combined) {
      state.SkipWithError(combined.error().message.c_str());
      break;
    }
    vertices = static_cast<double>(combined->uv.size());
    benchmark::DoNotOptimize(combined->uv.data());
  }
  countMemory(state, [&] { return overlay(input.part.view(), input.base.view(), {}); });
  state.counters["vertices"] = vertices;
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
  for (auto _ : state) {
    Arrangement result;
    CGAL::overlay(part, base, result);
    vertices = static_cast<double>(result.number_of_vertices());
  }
  countMemory(state, [&] {
    auto result = std::make_unique<Arrangement>();
    CGAL::overlay(part, base, *result);
    return result;
  });
  state.counters["vertices"] = vertices;
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

GRAFTSMAN_BENCHMARK_MAIN();
