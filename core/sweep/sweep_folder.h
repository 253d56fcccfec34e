#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/sweep/sweep_table.h"

namespace graftsman {

/// The folder that a sweep's results go into: for each that fused a mesh and a picture, as the sweep's output
/// says, both named after the combination, and one table.
class SweepFolder {
 public:
  /// Makes the folder, if there is none, and the pictures' camera, for which the sweep's base is fused: the
  /// same for every share. Errors: FileUnwritable, Cancelled.
  [[nodiscard]] static Result<SweepFolder> open(const std::filesystem::path& folder,
                                                std::shared_ptr<const LoadedSweep> sweep,
                                                const Progress& progress);

  /// Writes the result's files and notes its row. Atomic file by file. Errors: those of writeResult();
  /// FileUnwritable also where the file is one that the sweep was read from.
  [[nodiscard]] Result<void> add(const SweepResult& result, const Progress& progress);

  /// Writes the table of what was added, under the share's name.
  [[nodiscard]] Result<void> writeTable(const SweepShare& share = {}) const;

 private:
  SweepFolder(std::filesystem::path folder, std::shared_ptr<const LoadedSweep> sweep);

  [[nodiscard]] Result<void> refuseSource(const std::filesystem::path& file) const;

  std::filesystem::path folder_;
  std::shared_ptr<const LoadedSweep> sweep_;
  PictureCamera camera_;
  SweepTable table_;
};

}  // namespace graftsman
