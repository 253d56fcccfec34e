#include "core/project/read_fusion.h"

#include <cctype>
#include <string>
#include <utility>

#include "core/project/evaluate.h"
#include "core/project/project_file.h"

namespace graftsman {
namespace {

// The fusion that a project shows, as if a scenario had said it; what it is made of is computed.
Result<LoadedScenario> fusionOf(const LoadedProject& loaded, const Progress& progress) {
  if (!loaded.fusionIntact) {
    return fail(loaded.damage.front());
  }
  const FusionList& fusions = loaded.project.document.fusions;
  const FusionId shown = loaded.project.shown;
  for (const Side side : {Side::Part, Side::Base}) {
    if (!find(fusions, shown)->of(side)) {
      return fail({ErrorCode::MeshEmpty,
                   std::string("the project has no ") + name(side) + " yet. Load one in the workbench.",
                   side});
    }
  }
  if (!find(fusions, shown)->closed) {
    return fail(ErrorCode::LoopTooShort, "the project's loop is not closed yet. Close it in the workbench.");
  }
  Evaluated known;
  Upstream upstream = evaluateUpstream(fusions, shown, known, progress);
  if (upstream.error) {
    return fail(std::move(*upstream.error));
  }
  const Fusion resolved = resolve(*find(fusions, shown), upstream.assets);
  LoadedScenario fusion;
  fusion.scenario.part = resolved.part->source;
  fusion.scenario.base = resolved.base->source;
  fusion.scenario.inputs = resolved.inputs;
  fusion.partReport = resolved.part->report;
  fusion.baseReport = resolved.base->report;
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
  const Result<LoadedProject> loaded = readProject(path, progress.span(0, 0.5), Wanted::Results);
  if (!loaded) {
    return fail(naming(path, loaded.error()));
  }
  Result<LoadedScenario> fusion = fusionOf(*loaded, progress.span(0.5, 1));
  if (!fusion) {
    return fail(naming(path, std::move(fusion.error())));
  }
  fusion->scenario.name = path.stem().string();
  return fusion;
}

}  // namespace graftsman
