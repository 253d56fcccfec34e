#include "core/project/read_fusion.h"

#include <cctype>
#include <string>
#include <utility>

#include "core/project/project_file.h"

namespace graftsman {
namespace {

// The fusion of a project as if a scenario had said it.
Result<LoadedScenario> fusionOf(const LoadedProject& loaded) {
  const Document& document = loaded.project.document;
  if (!loaded.fusionIntact) {
    return fail(loaded.damage.front());
  }
  for (const Side side : {Side::Part, Side::Base}) {
    if (!document.of(side)) {
      return fail({ErrorCode::MeshEmpty,
                   std::string("the project has no ") + name(side) + " yet. Load one in the workbench.",
                   side});
    }
  }
  if (!document.closed) {
    return fail(ErrorCode::LoopTooShort, "the project's loop is not closed yet. Close it in the workbench.");
  }
  LoadedScenario fusion;
  fusion.scenario.part = document.part->source;
  fusion.scenario.base = document.base->source;
  fusion.scenario.inputs = document.inputs;
  fusion.partReport = document.part->report;
  fusion.baseReport = document.base->report;
  return fusion;
}

// The error with the file at the front of its message, where it is not there already.
Error naming(const std::filesystem::path& file, Error error) {
  if (!error.message.starts_with(file.string())) {
    error.message = file.string() + ": " + error.message;
  }
  return error;
}

}  // namespace

bool isProjectName(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return ending == ".graft";
}

Result<LoadedScenario> readFusion(const std::filesystem::path& path, const Progress& progress) {
  if (!isProjectName(path)) {
    return readScenario(path, progress).map_error([&](Error error) {
      return naming(path, std::move(error));
    });
  }
  const Result<LoadedProject> loaded = readProject(path, progress);
  if (!loaded) {
    return fail(naming(path, loaded.error()));
  }
  Result<LoadedScenario> fusion = fusionOf(*loaded);
  if (!fusion) {
    return fail(naming(path, std::move(fusion.error())));
  }
  fusion->scenario.name = path.stem().string();
  return fusion;
}

}  // namespace graftsman
