// The whole fusion, from two files to the fused mesh in memory, beside what a designer has today: CGAL's
// corefinement union of the same two files. One thread.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "core/base/parallel.h"
#include "core/fusion/update.h"
#include "core/io/mesh_file.h"
#include "tests/benchmarks/benchmark_main.h"
#include "tests/support/shapes.h"

namespace {

using namespace graftsman;

/// Two overlapping tori of about `faces` faces each, as binary PLY files that go with this object.
class TorusPair {
 public:
  explicit TorusPair(Index faces)
      : folder_(std::filesystem::temp_directory_path() / ("graftsman-" + std::to_string(::getpid()))),
        n_(static_cast<Index>(std::lround(std::sqrt(faces / 2.0)))) {
    std::filesystem::create_directories(folder_);
    const shapes::MeshPtr torus = shapes::torus(n_, n_);
    std::vector<Point> moved = torus->points();
    const Eigen::AngleAxisd turn(0.7, Point(1, 2, 3).normalized());
    for (Point& p : moved) {
      p = turn * p + Point(0.31, 0.17, 0.23);
    }
    write(base(), torus->points(), torus->faces());
    write(part(), moved, torus->faces());
  }
  TorusPair(const TorusPair&) = delete;
  TorusPair& operator=(const TorusPair&) = delete;
  ~TorusPair() { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path part() const { return folder_ / "part.ply"; }
  [[nodiscard]] std::filesystem::path base() const { return folder_ / "base.ply"; }

  /// Eight pairs round a patch that is a fifth of the torus wide, both ways.
  [[nodiscard]] Loop loop() const {
    Loop loop;
    for (int k = 0; k < 8; ++k) {
      const double angle = 2 * std::numbers::pi * k / 8;
      const auto i = static_cast<Index>(n_ * (0.5 + 0.1 * std::cos(angle)));
      const auto j = static_cast<Index>(n_ * (0.5 + 0.1 * std::sin(angle)));
      const SurfacePoint point = SurfacePoint::atVertex(i * n_ + j);
      loop.push_back({point, point});
    }
    return loop;
  }

 private:
  static void write(const std::filesystem::path& path, const std::vector<Point>& points,
                    const std::vector<Face>& faces) {
    if (const Result<void> written = writeMesh(path, points, faces, {}, {}); !written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      std::exit(1);
    }
  }

  std::filesystem::path folder_;
  Index n_;
};

void ours(benchmark::State& state, Index faces) {
  setThreadCount(1);
  const TorusPair pair(faces);
  for (auto _ : state) {
    FusionInputs inputs;
    inputs.part = readMesh(pair.part(), {}).value().mesh;
    inputs.base = readMesh(pair.base(), {}).value().mesh;
    inputs.loop = pair.loop();
    const FusionResults results = update(inputs, {}, {});
    if (results.error) {
      state.SkipWithError(results.error->message.c_str());
      return;
    }
    benchmark::DoNotOptimize(results.fused->points.data());
  }
}

void cgalUnion(benchmark::State& state, Index faces) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  const TorusPair pair(faces);
  for (auto _ : state) {
    Mesh a;
    Mesh b;
    Mesh result;
    std::ifstream fileA(pair.part(), std::ios::binary);
    std::ifstream fileB(pair.base(), std::ios::binary);
    if (!CGAL::IO::read_PLY(fileA, a) || !CGAL::IO::read_PLY(fileB, b) ||
        !CGAL::Polygon_mesh_processing::corefine_and_compute_union(a, b, result)) {
      state.SkipWithError("the union failed");
      return;
    }
    benchmark::DoNotOptimize(result.number_of_faces());
  }
}

BENCHMARK_CAPTURE(ours, 5k, 5000)->Name("fusion/ours/5k")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cgalUnion, 5k, 5000)->Name("fusion/cgal_union/5k")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, 50k, 50000)->Name("fusion/ours/50k")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cgalUnion, 50k, 50000)->Name("fusion/cgal_union/50k")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, 500k, 500000)->Name("fusion/ours/500k")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cgalUnion, 500k, 500000)->Name("fusion/cgal_union/500k")->Unit(benchmark::kMillisecond);

}  // namespace

GRAFTSMAN_BENCHMARK_MAIN();
