#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/fusion/update.h"
#include "core/picture/draw.h"

namespace graftsman {

/// Pictures of a fusion's result that make a film: a turntable, a camera for each, or the morph from the
/// base's shape to the part's, by one camera.
struct Film {
  enum class Kind { Turntable, Morph } kind = Kind::Turntable;
  int count = 2;                       // frames; of a morph at least 2, of a turntable at least 1
  std::vector<PictureCamera> cameras;  // `count` of a turntable, one of a morph
  PictureSize size;
};

/// "frame-007.png" of 250: at least three digits, so that names are in the frames' order. `frame`: from 0 on.
[[nodiscard]] std::string frameName(int frame, int count);

/// Precondition: `results.fused`, 0 ≤ frame < film.count.
[[nodiscard]] Picture drawFrame(const FusionResults& results, const Film& film, int frame);

/// Draws all frames and writes them into the folder, which is made if there is none, as PNG files of their
/// frameName(). Atomic file by file; what was written stays when it is cancelled or fails. Errors:
/// FileUnwritable (of the first frame that cannot be), OutOfMemory, Cancelled. Precondition:
/// `results.fused`.
[[nodiscard]] Result<void> writeFrames(const std::filesystem::path& folder, const FusionResults& results,
                                       const Film& film, const Progress& progress);

}  // namespace graftsman
