#include "core/picture/film.h"

#include <algorithm>
#include <atomic>
#include <optional>

#include "core/base/parallel.h"
#include "core/base/write_file.h"
#include "core/io/result_file.h"
#include "core/picture/fusion_view.h"

namespace graftsman {

std::string frameName(int frame, int count) {
  const std::size_t digits = std::max<std::size_t>(std::to_string(count).size(), 3);
  const std::string number = std::to_string(frame + 1);
  return "frame-" + std::string(digits - number.size(), '0') + number + ".png";
}

Picture drawFrame(const FusionResults& results, const Film& film, int frame) {
  PictureShading shading;
  shading.supersampling = 3;
  const std::vector<Face>& faces = results.fused->faces();
  if (film.kind == Film::Kind::Turntable) {
    return draw(results.fused->points, faces, film.cameras[static_cast<std::size_t>(frame)], film.size,
                shading);
  }
  return draw(morphed(results, static_cast<double>(frame) / (film.count - 1)), faces, film.cameras.front(),
              film.size, shading);
}

Result<void> writeFrames(const std::filesystem::path& folder, const FusionResults& results, const Film& film,
                         const Progress& progress) {
  if (Result<void> made = makeFolder(folder); !made) {
    return made;
  }
  // Each thread draws and writes frames of its own; the first in order that failed is told.
  std::vector<std::optional<Error>> failures(static_cast<std::size_t>(film.count));
  std::atomic<int> done = 0;
  parallelFor(failures.size(), [&](std::size_t i) {
    if (!progress.keepGoing(static_cast<double>(done) / film.count)) {
      failures[i] = Error{ErrorCode::Cancelled, "Cancelled."};
      return;
    }
    const auto frame = static_cast<int>(i);
    const Result<void> written =
        formatPng(drawFrame(results, film, frame)).and_then([&](const std::string& bytes) {
          return writeFile(folder / frameName(frame, film.count), bytes);
        });
    if (!written) {
      failures[i] = written.error();
    }
    ++done;
  });
  for (std::optional<Error>& failure : failures) {
    if (failure) {
      return fail(std::move(*failure));
    }
  }
  return {};
}

}  // namespace graftsman
