#include "core/sweep/sweep_folder.h"

#include "core/base/write_file.h"
#include "core/io/printable.h"
#include "core/io/result_file.h"
#include "core/picture/draw.h"

namespace graftsman {

SweepFolder::SweepFolder(std::filesystem::path folder, std::shared_ptr<const LoadedSweep> sweep)
    : folder_(std::move(folder)), sweep_(std::move(sweep)), table_(*sweep_) {}

Result<SweepFolder> SweepFolder::open(const std::filesystem::path& folder,
                                      std::shared_ptr<const LoadedSweep> sweep, const Progress& progress) {
  if (Result<void> made = makeFolder(folder); !made) {
    return fail(std::move(made.error()));
  }
  SweepFolder result(folder, std::move(sweep));
  const LoadedSweep& loaded = *result.sweep_;
  if (loaded.output.picture) {
    const FusionResults base = update(loaded.sweep.base, {}, progress);
    if (base.error && base.error->code == ErrorCode::Cancelled) {
      return fail(*base.error);
    }
    const SweepPicture& picture = *loaded.output.picture;
    const double aspect = static_cast<double>(picture.size.width) / picture.size.height;
    result.camera_ = cameraFor(base, picture.view, loaded.direction, aspect);
  }
  return result;
}

Result<void> SweepFolder::refuseSource(const std::filesystem::path& file) const {
  for (const std::filesystem::path& source : sweep_->sources) {
    std::error_code ignored;
    if (std::filesystem::equivalent(file, source, ignored)) {
      return fail(ErrorCode::FileUnwritable, printable(file.string(), 400) +
                                                 ": is one of the files that the sweep is made of. Give the "
                                                 "results a folder of their own.");
    }
  }
  return {};
}

Result<void> SweepFolder::add(const SweepResult& result, const Progress& progress) {
  std::string meshFile;
  std::string pictureFile;
  if (result.measures) {
    const std::string name = sweep_->sweep.name(result.combination);
    const FusedMesh& fused = *result.results.fused;
    if (!sweep_->output.mesh.empty()) {
      meshFile = name + "." + sweep_->output.mesh;
      Result<void> written = refuseSource(folder_ / meshFile).and_then([&] {
        return writeResult(folder_ / meshFile, result.results, progress);
      });
      if (!written) {
        return written;
      }
    }
    if (const auto& picture = sweep_->output.picture) {
      pictureFile = name + ".png";
      PictureShading shading;
      shading.supersampling = 3;
      Result<void> written =
          refuseSource(folder_ / pictureFile)
              .and_then([&] {
                return formatPng(draw(fused.points, fused.faces(), camera_, picture->size, shading));
              })
              .and_then([&](const std::string& bytes) { return writeFile(folder_ / pictureFile, bytes); });
      if (!written) {
        return written;
      }
    }
  }
  table_.add(result, meshFile, pictureFile);
  return {};
}

Result<void> SweepFolder::writeTable(const SweepShare& share) const {
  const std::filesystem::path file = folder_ / tableName(share);
  Result<void> allowed = refuseSource(file);
  return allowed ? writeFile(file, table_.text()) : allowed;
}

}  // namespace graftsman
