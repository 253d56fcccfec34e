#include <benchmark/benchmark.h>

#include <map>

#include "core/fusion/cut.h"
#include "core/fusion/tile.h"
#include "core/io/mesh_file.h"
#include "tests/benchmarks/benchmark_main.h"
#include "tests/support/loops.h"
#include "tests/support/places.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

/// The head of nefertiti.ply, subdivided: the loop is where a sphere about its highest vertex meets it.
const loops::AnchoredLoopPaths& head(int level) {
  static std::map<int, loops::AnchoredLoopPaths> made;
  if (const auto at = made.find(level); at != made.end()) {
    return at->second;
  }
  auto mesh = readMesh(places::samples() / "models/nefertiti.ply", {})->mesh;
  std::vector<Point> points = mesh->points();
  std::vector<Face> faces = mesh->faces();
  for (int i = 0; i < level; ++i) {
    std::tie(points, faces) = shapes::subdivided(std::move(points), faces);
  }
  mesh = std::make_shared<TriangleMesh>(std::move(points), std::move(faces));
  for (unsigned seed = 0;; ++seed) {
    loops::AnchoredLoopPaths loop = loops::randomLoop(mesh, seed);
    if (!loop.paths.paths.empty() &&
        gatherTile(*loop.mesh, cutMesh(*loop.mesh, loop.paths), Side::Base, {}, {})) {
      return made.emplace(level, std::move(loop)).first->second;
    }
  }
}

void cut(benchmark::State& state) {
  const auto& [mesh, paths] = head(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(cutMesh(*mesh, paths));
  }
  state.counters["faces"] = mesh->faceCount();
  state.counters["points"] = static_cast<double>(cutMesh(*mesh, paths).points.size());
}
BENCHMARK(cut)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

void tile(benchmark::State& state) {
  const auto& [mesh, paths] = head(static_cast<int>(state.range(0)));
  const Cut made = cutMesh(*mesh, paths);
  for (auto _ : state) {
    benchmark::DoNotOptimize(gatherTile(*mesh, made, Side::Base, {}, {}));
  }
  state.counters["faces"] = mesh->faceCount();
  state.counters["tile"] = static_cast<double>(gatherTile(*mesh, made, Side::Base, {}, {})->faces.size());
}
BENCHMARK(tile)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

/// One CV inside a face: the mesh is made anew.
void anchor(benchmark::State& state) {
  const auto& mesh = head(static_cast<int>(state.range(0))).mesh;
  const SurfacePoint inside = {-1, 0, Eigen::Vector3d(0.25, 0.25, 0.5)};
  const auto at = [](Index v) { return CVP{SurfacePoint::atVertex(v), SurfacePoint::atVertex(v)}; };
  const Loop loop = {{inside, inside}, at(mesh->face(9)[0]), at(mesh->face(mesh->faceCount() / 2)[1])};
  for (auto _ : state) {
    benchmark::DoNotOptimize(anchorLoop(mesh, loop, Side::Base));
  }
  state.counters["faces"] = mesh->faceCount();
}
BENCHMARK(anchor)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace

GRAFTSMAN_BENCHMARK_MAIN();
