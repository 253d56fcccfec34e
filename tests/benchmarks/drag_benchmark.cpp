// A CV dragged on the base: from one place of the hand to the fused mesh, starting from the results of the
// place before, as the workbench's stage runner does it. All cores.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "core/fusion/update.h"
#include "core/io/scenario.h"
#include "tests/benchmarks/benchmark_main.h"
#include "tests/support/places.h"
#include "tests/support/shapes.h"

namespace {

using namespace graftsman;

// The result of one move after another of CV 2 on the base among `places`.
void drag(benchmark::State& state, FusionInputs inputs, const std::vector<Index>& places) {
  FusionResults results = update(inputs, {}, {});
  std::size_t place = 0;
  for (auto _ : state) {
    inputs.loop[2].base = SurfacePoint::atVertex(places[++place % places.size()]);
    results = update(inputs, results, {});
    if (!results.fused) {
      state.SkipWithError(results.error->message.c_str());
      return;
    }
  }
  state.counters["tile faces"] =
      static_cast<double>(results.part.tile->faces.size() + results.base.tile->faces.size());
  state.counters["frames per second"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

// The vertex and its neighbours.
std::vector<Index> around(const TriangleMesh& mesh, Index vertex) {
  std::vector<Index> places = {vertex};
  const Index first = mesh.outgoing(vertex);
  Index h = first;
  do {
    places.push_back(mesh.to(h));
    h = mesh.twin(TriangleMesh::prev(h));
  } while (h >= 0 && h != first);
  return places;
}

void scenario(benchmark::State& state, const char* name) {
  const Result<LoadedScenario> loaded =
      readScenario(places::samples() / "scenarios" / (std::string(name) + ".json"), {});
  const FusionInputs& inputs = loaded->scenario.inputs;
  drag(state, inputs, around(*inputs.base, inputs.loop[2].base.vertex));
}

// Two tori of different fineness, with a tile of about `faces` faces on each.
void tori(benchmark::State& state, int faces) {
  constexpr double kRadius = 0.3;  // of the loop, as a fraction of the way round
  const auto fineness = [&](double factor) {
    return static_cast<Index>(
        std::lround(factor * std::sqrt(faces / 2.0 / (std::numbers::pi * kRadius * kRadius))));
  };
  const Index n = fineness(1);
  const Index m = fineness(0.93);
  FusionInputs inputs;
  inputs.base = shapes::torus(n, n);
  inputs.part = shapes::torus(m, m);
  for (int k = 0; k < 8; ++k) {
    const double angle = 2 * std::numbers::pi * k / 8;
    const auto at = [&](Index size) {
      const auto i = static_cast<Index>(size * (0.5 + kRadius * std::cos(angle)));
      const auto j = static_cast<Index>(size * (0.5 + kRadius * std::sin(angle)));
      return SurfacePoint::atVertex(i * size + j);
    };
    inputs.loop.push_back({at(m), at(n)});
  }
  drag(state, inputs, around(*inputs.base, inputs.loop[2].base.vertex));
}

BENCHMARK_CAPTURE(scenario, fig8b, "fig8b_cone_nose")
    ->Name("CV drag/ours/fig8b")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(scenario, fig9b, "fig9b_bird_plane")
    ->Name("CV drag/ours/fig9b")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(tori, tiles50k, 50'000)
    ->Name("CV drag/ours/50k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

GRAFTSMAN_BENCHMARK_MAIN();
