#include <fstream>
#include <string>
#include <utility>

#include "core/io/printable.h"
#include "core/io/scenario.h"

namespace graftsman {
namespace {

// A scenario is typed or saved by a person: a file beyond this is something else, given by mistake.
constexpr std::uintmax_t kGreatestFile = std::uintmax_t{64} << 20;

std::string pathInMessage(const std::filesystem::path& path) {
  return printable(path.string(), kLongestPathShown);
}

bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  return a == b || std::filesystem::equivalent(a, b, error);
}

}  // namespace

Result<std::string> readJsonText(const std::filesystem::path& path, const char* what) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) {
    return fail(ErrorCode::FileUnreadable,
                pathInMessage(path) + ": cannot be read (" + error.message() + ").");
  }
  if (size > kGreatestFile) {
    return fail(ErrorCode::ScenarioMalformed,
                pathInMessage(path) + ": too large for a " + what + " (" + std::to_string(size) + " bytes).");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) {
    return fail(ErrorCode::FileUnreadable, pathInMessage(path) + ": cannot be read.");
  }
  return text;
}

Result<void> useMeshNumbers(Loop& loop, Side side, const TriangleMesh& mesh, const std::vector<Index>& map,
                            const std::filesystem::path& path) {
  const std::size_t vertices = map.empty() ? static_cast<std::size_t>(mesh.vertexCount()) : map.size();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    SurfacePoint& point = side == Side::Part ? loop[i].part : loop[i].base;
    const bool isVertex = point.vertex >= 0;
    const auto number = static_cast<std::size_t>(isVertex ? point.vertex : point.face);
    const std::size_t count = isVertex ? vertices : static_cast<std::size_t>(mesh.faceCount());
    if (number >= count) {
      const std::string kind = isVertex ? "vertex" : "face";
      return fail({ErrorCode::LoopIndexOutOfRange,
                   "CV " + std::to_string(i) + " of the " + name(side) + " is " + kind + " " +
                       std::to_string(number) + ", but " + pathInMessage(path) + " has " +
                       std::to_string(count) + (isVertex ? " vertices" : " faces") +
                       "; give a number from 0 to " + std::to_string(count - 1) + ".",
                   side,
                   {static_cast<int>(i)}});
    }
    if (isVertex && !map.empty()) {
      point.vertex = map[number];
    }
  }
  return {};
}

Result<LoadedScenario> readScenario(const std::filesystem::path& path, const Progress& progress) {
  const Result<std::string> text = readJsonText(path, "scenario");
  if (!text) {
    return fail(text.error());
  }
  Result<Scenario> scenario = parseScenario(*text, path);
  if (!scenario) {
    return fail(std::move(scenario.error()));
  }
  const Result<MeshFile> part = readMesh(scenario->part, progress.span(0, 0.5));
  if (!part) {
    Error error = part.error();
    error.side = Side::Part;
    return fail(std::move(error));
  }
  const bool shared = sameFile(scenario->part, scenario->base);
  const Result<MeshFile> base = shared ? part : readMesh(scenario->base, progress.span(0.5, 1));
  if (!base) {
    Error error = base.error();
    error.side = Side::Base;
    return fail(std::move(error));
  }
  FusionInputs& inputs = scenario->inputs;
  for (const Side side : {Side::Part, Side::Base}) {
    const bool isPart = side == Side::Part;
    const MeshFile& file = isPart ? *part : *base;
    const Result<void> mapped = useMeshNumbers(inputs.loop, side, *file.mesh, file.vertexOfFileVertex,
                                               isPart ? scenario->part : scenario->base);
    if (!mapped) {
      return fail(mapped.error());
    }
  }
  inputs.part = part->mesh;
  inputs.base = base->mesh;
  return LoadedScenario{std::move(*scenario), part->report, base->report, part->vertexOfFileVertex,
                        base->vertexOfFileVertex};
}

}  // namespace graftsman
