// Reading a mesh file: CGAL's readers into points and polygons, and ours. Both start from the file's name.
//   read_FORMAT/cgal/N           CGAL::IO::read_FORMAT: points and polygons
//   read_FORMAT/ours/N           the same result: points and triangles, nothing about neighbours
//   read_FORMAT/ours+topology/N  readMesh(): with connectivity, duplicates dropped
//   topology/ours/N              TriangleMesh's constructor alone
//   write_FORMAT/ours/N          writeMesh(), with its flush to the disk
// The files hold the first N faces of nefertiti.ply, subdivided where it has fewer. OBJ, ASCII PLY and OFF
// have six decimals, as most programs write them; obj17 has all digits of a double. PLY and STL are binary.

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/large_array.h"
#include "core/io/mesh_file.h"
#include "core/io/mesh_parse.h"
#include "core/io/read_file.h"
#include "tests/support/places.h"
#include "tests/support/shapes.h"

namespace graftsman {
namespace {

using PeerPoints = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
using PeerPolygons = std::vector<std::vector<std::size_t>>;

struct Soup {
  std::vector<Point> points;
  std::vector<Face> faces;
};

// The first `count` faces, with their vertices numbered by first use.
Soup firstFaces(const Soup& soup, std::size_t count) {
  Soup part;
  std::vector<Index> newOf(soup.points.size(), -1);
  for (std::size_t f = 0; f < count; ++f) {
    Face face = soup.faces[f];
    for (Index& v : face) {
      Index& number = newOf[static_cast<std::size_t>(v)];
      if (number < 0) {
        number = static_cast<Index>(part.points.size());
        part.points.push_back(soup.points[static_cast<std::size_t>(v)]);
      }
      v = number;
    }
    part.faces.push_back(face);
  }
  return part;
}

Soup nefertiti() {
  const auto file = readMesh(places::samples() / "models/nefertiti.ply", {});
  Soup soup = {file.value().mesh->points(), file.value().mesh->faces()};
  for (int level = 0; level < 2; ++level) {
    auto [points, faces] = shapes::subdivided(std::move(soup.points), soup.faces);
    soup = {std::move(points), std::move(faces)};
  }
  return soup;
}

std::vector<Point> sixDecimals(std::vector<Point> points) {
  for (Point& p : points) {
    p = (p * 1e6).array().round() / 1e6;
  }
  return points;
}

template <class ReadPeer>
void benchmarkPeer(const std::string& name, const std::filesystem::path& path, ReadPeer read) {
  benchmark::RegisterBenchmark(
      name.c_str(),
      [=](benchmark::State& state) {
        for (auto _ : state) {
          if (!read(path.string())) {
            state.SkipWithError("the peer cannot read the file");
          }
        }
        state.SetBytesProcessed(state.iterations() *
                                static_cast<std::int64_t>(std::filesystem::file_size(path)));
      })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

template <class Polygons, class Read>
auto peer(Read read) {
  return [=](const std::string& name) {
    PeerPoints points;
    Polygons polygons;
    const bool done = read(name, points, polygons);
    benchmark::DoNotOptimize(points.data());
    benchmark::DoNotOptimize(polygons.data());
    return done;
  };
}

bool readOurs(const std::string& name) {
  const auto file = readFile(name, {});
  const auto soup = parseTriangles(file.value().bytes(), formatOf(name).value(), name, {});
  benchmark::DoNotOptimize(soup.value().faces.data());
  return soup.has_value();
}

bool readOursWithTopology(const std::string& name) {
  const auto mesh = readMesh(name, {});
  benchmark::DoNotOptimize(mesh.value().mesh.get());
  return mesh.has_value();
}

void mustWrite(const std::filesystem::path& path, const std::vector<Point>& points,
               const std::vector<Face>& faces, bool binary) {
  const Result<void> written = writeMesh(path, points, faces, {binary}, {});
  if (!written) {
    throw std::runtime_error(written.error().message);
  }
}

void benchmarkSize(const std::filesystem::path& folder, const Soup& soup, const std::string& size) {
  const std::vector<Point> rounded = sixDecimals(soup.points);
  const auto write = [&](const std::string& name, const std::vector<Point>& points, bool binary) {
    const std::filesystem::path path = folder / name;
    mustWrite(path, points, soup.faces, binary);
    return path;
  };
  const auto ours = [&](const std::string& format, const std::filesystem::path& path) {
    benchmarkPeer("read_" + format + "/ours/" + size, path, readOurs);
    benchmarkPeer("read_" + format + "/ours+topology/" + size, path, readOursWithTopology);
  };
  const auto obj = [](const std::string& n, auto& p, auto& f) { return CGAL::IO::read_OBJ(n, p, f); };
  const auto ply = [](const std::string& n, auto& p, auto& f) { return CGAL::IO::read_PLY(n, p, f); };
  const auto stl = [](const std::string& n, auto& p, auto& f) { return CGAL::IO::read_STL(n, p, f); };
  const auto off = [](const std::string& n, auto& p, auto& f) { return CGAL::IO::read_OFF(n, p, f); };
  for (const bool binary : {true, false}) {
    const std::string suffix = binary ? "" : "_ascii";
    const auto& points = binary ? soup.points : rounded;
    const auto plyFile = write(size + suffix + ".ply", points, binary);
    benchmarkPeer("read_ply" + suffix + "/cgal/" + size, plyFile, peer<PeerPolygons>(ply));
    ours("ply" + suffix, plyFile);
    const auto stlFile = write(size + suffix + ".stl", points, binary);
    benchmarkPeer("read_stl" + suffix + "/cgal/" + size, stlFile,
                  peer<std::vector<std::array<std::size_t, 3>>>(stl));
    ours("stl" + suffix, stlFile);
  }
  for (const bool allDigits : {false, true}) {
    const std::string format = allDigits ? "obj17" : "obj";
    const auto objFile = write(size + format + ".obj", allDigits ? soup.points : rounded, false);
    benchmarkPeer("read_" + format + "/cgal/" + size, objFile, peer<PeerPolygons>(obj));
    ours(format, objFile);
  }
  const auto offFile = write(size + ".off", rounded, false);
  benchmarkPeer("read_off/cgal/" + size, offFile, peer<PeerPolygons>(off));
  ours("off", offFile);
  benchmark::RegisterBenchmark(("topology/ours/" + size).c_str(),
                               [soup](benchmark::State& state) {
                                 for (auto _ : state) {
                                   state.PauseTiming();
                                   Soup copy = soup;
                                   state.ResumeTiming();
                                   const TriangleMesh mesh(std::move(copy.points), std::move(copy.faces));
                                   benchmark::DoNotOptimize(mesh.diagonal());
                                 }
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  for (const char* const ending : {".obj", ".ply", ".stl", ".off"}) {
    benchmark::RegisterBenchmark(
        ("write_" + std::string(ending + 1) + "/ours/" + size).c_str(),
        [soup, path = folder / ("written" + std::string(ending))](benchmark::State& state) {
          for (auto _ : state) {
            mustWrite(path, soup.points, soup.faces, true);
          }
        })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace
}  // namespace graftsman

int main(int argc, char** argv) {
  graftsman::keepFreedMemory();
  benchmark::Initialize(&argc, argv);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("graftsman_io_benchmark_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const graftsman::Soup all = graftsman::nefertiti();
  graftsman::benchmarkSize(folder, graftsman::firstFaces(all, 5000), "5k");
  graftsman::benchmarkSize(folder, graftsman::firstFaces(all, 50000), "50k");
  graftsman::benchmarkSize(folder, graftsman::firstFaces(all, 500000), "500k");
  benchmark::RunSpecifiedBenchmarks();
  std::filesystem::remove_all(folder);
  return 0;
}
