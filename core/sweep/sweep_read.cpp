#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>

#include "core/io/fusion_json.h"
#include "core/io/mesh_file.h"
#include "core/project/read_fusion.h"
#include "core/sweep/sweep_file.h"

namespace graftsman {
namespace {

// FNV-1a, 64 bits: tells one sweep from another, and is no protection against anybody.
class Fingerprint {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) {
      state_ = (state_ ^ bytes[i]) * 0x100000001b3U;
    }
  }
  void add(const std::string& text) { add(text.data(), text.size()); }
  void add(const TriangleMesh& mesh) {
    for (const Point& p : mesh.points()) {
      add(p.data(), 3 * sizeof(double));
    }
    add(mesh.faces().data(), mesh.faces().size() * sizeof(Face));
  }

  [[nodiscard]] std::string text() const {
    constexpr std::array<char, 17> kDigits = {"0123456789abcdef"};
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) {
      digits += kDigits[state_ >> shift & 15U];
    }
    return digits;
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325U;
};

// Everything that the results depend on, but where the files are.
std::string fingerprintOf(const Sweep& sweep) {
  SweepFile values = {{}, sweep, {}};
  for (SweepPart& part : values.sweep.parts) {
    part.source = part.mesh ? "part" : "";
  }
  fusion_json::Ordered inputs;
  fusion_json::writeInputs(inputs, sweep.base);
  Fingerprint fingerprint;
  fingerprint.add(formatSweep(values, {}));
  fingerprint.add(inputs.dump());
  fingerprint.add(*sweep.base.part);
  fingerprint.add(*sweep.base.base);
  for (const SweepPart& part : sweep.parts) {
    if (part.mesh) {
      fingerprint.add(*part.mesh);
    }
  }
  return fingerprint.text();
}

// Meshes by the file that they are in.
class Meshes {
 public:
  // Knows those of a fusion that was read from `file`, unless that is a project, which holds its meshes: the
  // files that they once came from may have changed since.
  Meshes(const LoadedScenario& fusion, const std::filesystem::path& file) {
    if (!isProjectName(file)) {
      known_[key(fusion.scenario.part)] = {fusion.scenario.inputs.part, fusion.partVertexOfFileVertex, {}};
      known_[key(fusion.scenario.base)] = {fusion.scenario.inputs.base, fusion.baseVertexOfFileVertex, {}};
    }
  }

  Result<MeshFile> read(const std::filesystem::path& path, const Progress& progress) {
    const auto found = known_.find(key(path));
    if (found != known_.end()) {
      return found->second;
    }
    Result<MeshFile> file = readMesh(path, progress);
    if (file) {
      known_[key(path)] = *file;
    }
    return file;
  }

 private:
  static std::filesystem::path key(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(path, ignored);
  }
  std::map<std::filesystem::path, MeshFile> known_;
};

Error inPart(const SweepPart& part, Error error) {
  error.message = "Part \"" + part.name + "\": " + error.message;
  return error;
}

// The pairs' numbers become the meshes'.
Result<void> finish(SweepPart& part, const MeshFile& mesh, const LoadedScenario& fusion) {
  part.mesh = mesh.mesh;
  Result<void> ofPart =
      useMeshNumbers(part.loop, Side::Part, *mesh.mesh, mesh.vertexOfFileVertex, part.source);
  if (!ofPart) {
    return ofPart;
  }
  return useMeshNumbers(part.loop, Side::Base, *fusion.scenario.inputs.base, fusion.baseVertexOfFileVertex,
                        fusion.scenario.base);
}

}  // namespace

Result<LoadedSweep> loadSweep(Sweep sweep, SweepOutput output, bool isObj) {
  if (Result<void> checked = check(sweep); !checked) {
    return fail(std::move(checked.error()));
  }
  LoadedSweep loaded;
  loaded.fingerprint = fingerprintOf(sweep);
  loaded.sweep = std::move(sweep);
  loaded.output = std::move(output);
  const SweepPicture picture = loaded.output.picture.value_or(SweepPicture());
  const FusionInputs& base = loaded.sweep.base;
  loaded.direction = firstDirection(base, picture.yUp ? *picture.yUp : guessYUp(base, isObj));
  if (picture.towards) {
    loaded.direction.towards = *picture.towards;
  }
  return loaded;
}

Result<LoadedSweep> readSweep(const std::filesystem::path& path, const Progress& progress) {
  const Result<std::string> text = readJsonText(path, "sweep");
  if (!text) {
    return fail(text.error());
  }
  Result<SweepFile> file = parseSweep(*text, path);
  if (!file) {
    return fail(std::move(file.error()));
  }
  constexpr double kFusionShare = 0.5;
  const Result<LoadedScenario> fusion = readFusion(file->fusion, progress.span(0, kFusionShare));
  if (!fusion) {
    return fail(fusion.error());
  }
  std::vector<std::filesystem::path> sources = {path, file->fusion, fusion->scenario.part,
                                                fusion->scenario.base};
  Meshes meshes(*fusion, file->fusion);
  Sweep& sweep = file->sweep;
  for (std::size_t i = 0; i < sweep.parts.size(); ++i) {
    SweepPart& part = sweep.parts[i];
    if (part.source.empty()) {
      continue;
    }
    const auto fraction = [&](std::size_t done) {
      return kFusionShare +
             (1 - kFusionShare) * static_cast<double>(done) / static_cast<double>(sweep.parts.size());
    };
    const Result<MeshFile> mesh = meshes.read(part.source, progress.span(fraction(i), fraction(i + 1)));
    if (!mesh) {
      return fail(inPart(part, mesh.error()));
    }
    if (Result<void> finished = finish(part, *mesh, *fusion); !finished) {
      return fail(inPart(part, std::move(finished.error())));
    }
    sources.push_back(part.source);
  }
  sweep.base = fusion->scenario.inputs;
  Result<LoadedSweep> loaded =
      loadSweep(std::move(sweep), std::move(file->output), fusion->baseReport.format == MeshFormat::Obj);
  if (loaded) {
    loaded->sources = std::move(sources);
  }
  return loaded;
}

}  // namespace graftsman
