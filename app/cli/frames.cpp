#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/parallel.h"
#include "core/base/write_file.h"
#include "core/io/printable.h"
#include "core/picture/draw.h"
#include "core/picture/fusion_view.h"
#include "core/project/read_fusion.h"

using namespace graftsman;

namespace {

// "frame-007.png" of 250.
std::string frameName(int frame, int frames) {
  const std::size_t digits = std::max<std::size_t>(std::to_string(frames).size(), 3);
  const std::string number = std::to_string(frame + 1);
  return "frame-" + std::string(digits - number.size(), '0') + number + ".png";
}

/// The frames of one command: each can be drawn for itself.
class Film {
 public:
  Film(const FramesOptions& options, const LoadedScenario& fusion, const FusionResults& results)
      : options_(options), results_(results) {
    const SizeNumbers size = parseSize(options.size).value_or(SizeNumbers());
    size_ = {size.width, size.height};
    shading_.supersampling = 3;
    const FusionInputs& inputs = fusion.scenario.inputs;
    const bool yUp = options.up.empty() ? guessYUp(inputs, fusion.baseReport.format == MeshFormat::Obj)
                                        : options.up == "y";
    const ViewDirection direction = firstDirection(inputs, yUp);
    const double aspect = static_cast<double>(size_.width) / size_.height;
    const bool whole = options.view.empty() ? options.turntable > 0 : options.view == "whole";
    const FusionView view = whole ? FusionView::Whole : FusionView::Tile;
    if (options.turntable > 0) {
      cameras_ = turntable(shownPoints(results, view), direction, aspect, options.turntable);
    } else {
      cameras_ = {cameraFor(results, view, direction, aspect)};
    }
  }

  [[nodiscard]] int count() const { return std::max(options_.turntable, options_.morph); }

  [[nodiscard]] Picture frame(int number) const {
    const std::vector<Face>& faces = results_.fused->faces();
    if (options_.turntable > 0) {
      return draw(results_.fused->points, faces, cameras_[static_cast<std::size_t>(number)], size_, shading_);
    }
    return draw(morphed(results_, static_cast<double>(number) / (options_.morph - 1)), faces, cameras_[0],
                size_, shading_);
  }

 private:
  const FramesOptions& options_;
  const FusionResults& results_;
  PictureSize size_;
  PictureShading shading_;
  std::vector<PictureCamera> cameras_;  // one a frame, or one for all
};

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
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if (error) {
    return fail(ErrorCode::FileUnwritable,
                printable(options.folder, 400) + ": cannot be made a folder: " + error.message());
  }
  const Film film(options, *fusion, results);
  // Each thread draws and writes frames of its own; the first in order that failed is told.
  std::vector<std::optional<Error>> failures(static_cast<std::size_t>(film.count()));
  std::atomic<int> done = 0;
  const Progress progress = terminalProgress("Drawing");
  parallelFor(failures.size(), [&](std::size_t i) {
    const auto number = static_cast<int>(i);
    const Result<void> written = formatPng(film.frame(number)).and_then([&](const std::string& bytes) {
      return writeFile(std::filesystem::path(options.folder) / frameName(number, film.count()), bytes);
    });
    if (!written) {
      failures[i] = written.error();
    }
    static_cast<void>(progress.keepGoing(static_cast<double>(++done) / film.count()));
  });
  for (std::optional<Error>& failure : failures) {
    if (failure) {
      return fail(std::move(*failure));
    }
  }
  return {};
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
