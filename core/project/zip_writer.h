#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace graftsman {

/// A zip in the making. The same entries give the same bytes: no time of day goes into it.
class ZipWriter {
 public:
  enum class Packing { Stored, Deflated };

  /// Throws std::bad_alloc.
  ZipWriter();

  /// Adds an entry: the blocks, one after the other. They are not copied, and must stay until write() has
  /// returned. Error: FileUnwritable (a second entry of that name).
  [[nodiscard]] Result<void> add(const std::string& name, const std::vector<std::string_view>& blocks,
                                 Packing packing);

  /// Packs everything and writes the file, atomically (writeFile()). The last call. Errors: FileUnwritable,
  /// Cancelled, OutOfMemory.
  [[nodiscard]] Result<void> write(const std::filesystem::path& path, const Progress& progress);

 private:
  struct Archive;
  std::shared_ptr<Archive> archive_;
};

}  // namespace graftsman
