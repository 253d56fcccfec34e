#include <string>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/io/printable.h"
#include "core/picture/film.h"
#include "core/picture/fusion_view.h"
#include "core/project/read_fusion.h"

using namespace graftsman;

namespace {

Film filmOf(const FramesOptions& options, const LoadedScenario& fusion, const FusionResults& results) {
  Film film;
  const SizeNumbers size = parseSize(options.size).value_or(SizeNumbers());
  film.size = {size.width, size.height};
  const FusionInputs& inputs = fusion.scenario.inputs;
  const bool yUp =
      options.up.empty() ? guessYUp(inputs, fusion.baseReport.format == MeshFormat::Obj) : options.up == "y";
  const ViewDirection direction = firstDirection(inputs, yUp);
  const double aspect = static_cast<double>(size.width) / size.height;
  const bool whole = options.view.empty() ? options.turntable > 0 : options.view == "whole";
  const FusionView view = whole ? FusionView::Whole : FusionView::Tile;
  if (options.turntable > 0) {
    film.kind = Film::Kind::Turntable;
    film.count = options.turntable;
    film.cameras = turntable(shownPoints(results, view), direction, aspect, film.count);
  } else {
    film.kind = Film::Kind::Morph;
    film.count = options.morph;
    film.cameras = {cameraFor(results, view, direction, aspect)};
  }
  return film;
}

Result<void> run(const FramesOptions& options) {
  for (const auto& [name, what] :
       {std::pair(options.input, "input"), std::pair(options.folder, "output folder")}) {
    if (name.empty()) {
      return fail(ErrorCode::FileUnreadable, std::string("The ") + what + "'s file name is empty; give one.");
    }
  }
  const Result<LoadedScenario> fusion = readFusion(options.input, terminalProgress("Reading"));
  if (!fusion) {
    return fail(fusion.error());
  }
  const FusionResults results = update(fusion->scenario.inputs, {}, terminalProgress("Fusing"));
  if (results.error) {
    return fail(results.error->code, printable(options.input, 400) + ": " + results.error->message);
  }
  return writeFrames(options.folder, results, filmOf(options, *fusion, results), terminalProgress("Drawing"));
}

}  // namespace

int frames(const FramesOptions& options) {
  const Result<void> done = run(options);
  if (!done) {
    return reportError(done.error());
  }
  clearProgress();
  return 0;
}
