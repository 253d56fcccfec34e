#include <benchmark/benchmark.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <Eigen/SparseCholesky>
#include <map>

#include "core/base/large_array.h"
#include "core/base/parallel.h"
#include "core/fusion/embedding.h"
#include "core/fusion/embedding_boundary.h"
#include "core/fusion/laplace_system.h"
#include "tests/support/tiles.h"

using namespace graftsman;

namespace {

/// A bumpy disc with irregular triangles, of about the given number of faces.
const shapes::DiscTile& tileOf(Index faces) {
  static std::map<Index, shapes::DiscTile> tiles;
  const auto [it, isNew] = tiles.try_emplace(faces);
  if (isNew) {
    it->second = shapes::bumpyDisc(static_cast<Index>(std::sqrt(faces / 6.0)), 6, 0.1, 1);
  }
  return it->second;
}

void ours(benchmark::State& state, Index faces) {
  const shapes::DiscTile& tile = tileOf(faces);
  setThreadCount(1);
  for (auto _ : state) {
    const auto embedding = embed(tile.points, tile.faces, tile.boundarySize, tile.corners, {}, {});
    if (!embedding || embedding->weights != EmbeddingWeights::Cotangent) {
      state.SkipWithError("not embedded by cotangent weights");
    }
    benchmark::DoNotOptimize(embedding);
  }
  setThreadCount(0);
}

void cgalConformal(benchmark::State& state, Index faces) {
  namespace SMP = CGAL::Surface_mesh_parameterization;
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Border = SMP::Circular_border_arc_length_parameterizer_3<Mesh>;
  using Parameterizer = SMP::Discrete_conformal_map_parameterizer_3<Mesh, Border>;
  const shapes::DiscTile& tile = tileOf(faces);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Point& p : tile.points) {
    vertices.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  }
  const auto at = [&](Index v) { return vertices[static_cast<std::size_t>(v)]; };
  for (const auto& [a, b, c] : tile.faces) {
    mesh.add_face(at(a), at(b), at(c));
  }
  Mesh::Halfedge_index border = mesh.halfedge(at(1), at(0));
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  for (auto _ : state) {
    if (SMP::parameterize(mesh, Parameterizer(), border, uv) != SMP::OK) {
      state.SkipWithError("CGAL found no parameterization");
    }
  }
}

void eigenLDLT(benchmark::State& state, Index faces) {
  const shapes::DiscTile& shape = tileOf(faces);
  const EmbeddingTile tile = prepareTile(shape.points, shape.faces, shape.boundarySize);
  const Stars stars = gatherStars(tile);
  std::vector<Point2> boundary;
  for (const auto& position : layOutBoundary(tile.points, shape.boundarySize, shape.corners)) {
    boundary.push_back(boundaryPoint(6, position));
  }
  const LaplaceSystem system =
      laplaceSystem(stars, cotangentWeights(tile, stars), boundary, MatrixKind::Symmetric);
  std::vector<Eigen::Triplet<double>> entries;
  const auto n = static_cast<Index>(system.matrix.rows());
  Eigen::Matrix<double, Eigen::Dynamic, 2> rhs(n, 2);
  for (Index r = 0; r < n; ++r) {
    const auto row = static_cast<std::size_t>(r);
    rhs.row(r) = system.rhs[row];
    entries.emplace_back(r, r, system.matrix.diagonal[row]);
    for (Index k = system.matrix.offsets[row]; k < system.matrix.offsets[row + 1]; ++k) {
      const auto entry = static_cast<std::size_t>(k);
      entries.emplace_back(r, system.matrix.columns[entry], system.matrix.values[entry]);
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for (auto _ : state) {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    Eigen::Matrix<double, Eigen::Dynamic, 2> solution = solver.solve(rhs);
    benchmark::DoNotOptimize(solution);
  }
}

}  // namespace

int main(int argc, char** argv) {
  graftsman::keepFreedMemory();
  const std::pair<const char*, Index> sizes[] = {{"5k", 5'000}, {"50k", 50'000}, {"500k", 500'000}};
  for (const auto& [name, faces] : sizes) {
    const std::string suffix = std::string("/") + name;
    const auto add = [&, count = faces](const std::string& what, auto function) {
      benchmark::RegisterBenchmark((what + suffix).c_str(), function, count)->Unit(benchmark::kMillisecond);
    };
    add("embed/ours", ours);
    add("embed/eigen_ldlt", eigenLDLT);
    if (faces < 500'000) {  // CGAL needs minutes there
      add("embed/cgal_conformal", cgalConformal);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
