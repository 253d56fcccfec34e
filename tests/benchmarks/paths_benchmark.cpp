#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <random>

#include "core/base/large_array.h"
#include "core/base/parallel.h"
#include "core/fusion/min_heap.h"
#include "core/fusion/paths.h"
#include "core/io/mesh_file.h"
#include "tests/support/places.h"
#include "tests/support/shapes.h"

namespace {

using namespace graftsman;
using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ExactPaths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>>;

constexpr int kSources = 4;   // exact lengths need one CGAL tree a source
constexpr int kTargets = 25;  // so the share is over 100 pairs

shapes::MeshPtr sample(const std::string& name) {
  const auto file = readMesh(places::samples() / "models" / name, {});
  if (!file) {
    std::cerr << file.error().message << '\n';
    std::exit(1);
  }
  return file->mesh;
}

shapes::MeshPtr subdivided(const TriangleMesh& mesh) {
  auto [points, faces] = shapes::subdivided(mesh.points(), mesh.faces());
  return std::make_shared<TriangleMesh>(std::move(points), std::move(faces));
}

/// About 5k, 50k, 500k faces of scanned and modelled surfaces, and one of a million.
shapes::MeshPtr meshOf(const std::string& size) {
  static std::map<std::string, shapes::MeshPtr> meshes;
  auto& mesh = meshes[size];
  if (!mesh) {
    mesh = size == "5k"     ? sample("spot.obj")
           : size == "50k"  ? sample("nefertiti.ply")
           : size == "500k" ? subdivided(*subdivided(*sample("head.obj")))
                            : subdivided(*subdivided(*sample("nefertiti.ply")));
  }
  return mesh;
}

std::vector<std::vector<Index>> sourcesAndTargets(const TriangleMesh& mesh) {
  std::mt19937 random(2);
  std::vector<std::vector<Index>> result(kSources);
  for (auto& ends : result) {
    while (ends.size() <= kTargets) {
      const auto v = static_cast<Index>(random() % static_cast<std::uint32_t>(mesh.vertexCount()));
      if (!mesh.singular(v) && std::find(ends.begin(), ends.end(), v) == ends.end()) {
        ends.push_back(v);
      }
    }
  }
  return result;
}

/// One full run over the edge graph from one vertex: adjacency and lengths prepared beforehand, not timed.
class Dijkstra {
 public:
  explicit Dijkstra(const TriangleMesh& mesh) : starts_(static_cast<std::size_t>(mesh.vertexCount()) + 1, 0) {
    std::vector<std::pair<Index, Index>> edges;
    for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
      edges.emplace_back(mesh.from(h), mesh.to(h));
      if (mesh.twin(h) < 0) {
        edges.emplace_back(mesh.to(h), mesh.from(h));
      }
    }
    for (const auto& [from, to] : edges) {
      ++starts_[static_cast<std::size_t>(from) + 1];
    }
    for (std::size_t v = 1; v < starts_.size(); ++v) {
      starts_[v] += starts_[v - 1];
    }
    links_.resize(edges.size());
    std::vector<std::size_t> fill(starts_.begin(), starts_.end() - 1);
    for (const auto& [from, to] : edges) {
      links_[fill[static_cast<std::size_t>(from)]++] = {(mesh.point(to) - mesh.point(from)).norm(), to};
    }
  }

  double run(Index from) const {
    std::vector<double> distances(starts_.size() - 1, std::numeric_limits<double>::infinity());
    MinHeap heap;
    distances[static_cast<std::size_t>(from)] = 0;
    heap.push(0, from);
    double farthest = 0;
    while (!heap.empty()) {
      const auto [distance, value] = heap.pop();
      const auto v = static_cast<std::size_t>(value);
      if (distance > distances[v]) {
        continue;
      }
      farthest = distance;
      for (std::size_t k = starts_[v]; k < starts_[v + 1]; ++k) {
        const auto& [length, to] = links_[k];
        if (distance + length < distances[static_cast<std::size_t>(to)]) {
          distances[static_cast<std::size_t>(to)] = distance + length;
          heap.push(distance + length, to);
        }
      }
    }
    return farthest;
  }

 private:
  struct Link {
    double length;
    Index to;
  };
  std::vector<std::size_t> starts_;
  std::vector<Link> links_;
};

class Exact {
 public:
  explicit Exact(const TriangleMesh& mesh) {
    for (const Point& p : mesh.points()) {
      mesh_.add_vertex({p.x(), p.y(), p.z()});
    }
    for (const Face& f : mesh.faces()) {
      mesh_.add_face(at(f[0]), at(f[1]), at(f[2]));
    }
  }
  std::vector<double> distances(const std::vector<Index>& ends) {
    ExactPaths paths(mesh_);
    paths.add_source_point(at(ends[0]));
    std::vector<double> result;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      result.push_back(paths.shortest_distance_to_source_points(at(ends[i])).first);
    }
    return result;
  }

 private:
  static SurfaceMesh::Vertex_index at(Index v) {
    return SurfaceMesh::Vertex_index(static_cast<SurfaceMesh::size_type>(v));
  }
  SurfaceMesh mesh_;
};

/// The share of pairs whose path is at most 0.1 % longer than the exact one.
double overExactShare(const TriangleMesh& mesh, PathMode mode) {
  Exact exact(mesh);
  int good = 0;
  for (const auto& ends : sourcesAndTargets(mesh)) {
    const auto distances = exact.distances(ends);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      good += (*findPath(mesh, ends[0], ends[i], mode, {}))->length <= 1.001 * distances[i - 1] ? 1 : 0;
    }
  }
  return good / static_cast<double>(kSources * kTargets);
}

/// One iteration is one path; over all pairs in turn, so run it for some hundred iterations.
void pathBenchmark(benchmark::State& state, const std::string& size, PathMode mode) {
  setThreadCount(1);
  const auto mesh = meshOf(size);
  const auto ends = sourcesAndTargets(*mesh);
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& group = ends[next % kSources];
    const auto path = findPath(*mesh, group[0], group[1 + next / kSources % kTargets], mode, {});
    benchmark::DoNotOptimize((*path)->length);
    ++next;
  }
  if (size == "5k") {
    static std::map<PathMode, double> shares;
    if (!shares.contains(mode)) {
      shares[mode] = overExactShare(*mesh, mode);
    }
    state.counters["over_exact_share"] = shares[mode];
  }
  setThreadCount(0);
}

void dijkstraBenchmark(benchmark::State& state, const std::string& size) {
  const auto mesh = meshOf(size);
  const Dijkstra dijkstra(*mesh);
  const auto ends = sourcesAndTargets(*mesh);
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(dijkstra.run(ends[next++ % kSources][0]));
  }
}

void exactBenchmark(benchmark::State& state) {
  const auto mesh = meshOf("5k");
  Exact exact(*mesh);
  const auto ends = sourcesAndTargets(*mesh);
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& group = ends[next++ % kSources];
    benchmark::DoNotOptimize(exact.distances({group[0], group[1]}));
  }
}

/// A loop of eight pairs round a random place; with a previous result, of which one CV has moved.
void loopBenchmark(benchmark::State& state, const std::string& size, bool drag) {
  setThreadCount(1);
  const auto mesh = meshOf(size);
  std::vector<Index> cvs = sourcesAndTargets(*mesh)[0];
  cvs.resize(8);
  const auto first = findPaths(*mesh, cvs, PathMode::Straightened, Side::Base, nullptr, {}, {});
  std::vector<Index> moved = cvs;
  moved[3] = mesh->to(mesh->outgoing(cvs[3]));
  for (auto _ : state) {
    const auto loop =
        findPaths(*mesh, moved, PathMode::Straightened, Side::Base, drag ? first->get() : nullptr, cvs, {});
    benchmark::DoNotOptimize(loop.has_value());
  }
  setThreadCount(0);
}

}  // namespace

int main(int argc, char** argv) {
  graftsman::keepFreedMemory();
  for (const std::string size : {"5k", "50k", "500k", "1M"}) {
    const auto unit = benchmark::kMillisecond;
    benchmark::RegisterBenchmark(("path/dijkstra/" + size).c_str(), [=](auto& state) {
      dijkstraBenchmark(state, size);
    })->Unit(unit);
    benchmark::RegisterBenchmark(("path/ours/" + size).c_str(),
                                 [=](auto& state) { pathBenchmark(state, size, PathMode::Straightened); })
        ->Iterations(kSources * kTargets)
        ->Unit(unit);
    benchmark::RegisterBenchmark(("loop/ours/" + size).c_str(), [=](auto& state) {
      loopBenchmark(state, size, false);
    })->Unit(unit);
    benchmark::RegisterBenchmark(("loop/drag/" + size).c_str(), [=](auto& state) {
      loopBenchmark(state, size, true);
    })->Unit(unit);
  }
  for (const std::string size : {"5k", "50k"}) {
    benchmark::RegisterBenchmark(("path/paper/" + size).c_str(),
                                 [=](auto& state) { pathBenchmark(state, size, PathMode::Paper); })
        ->Iterations(kSources * kTargets)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("path/cgal_exact/5k", [](auto& state) {
    exactBenchmark(state);
  })->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
