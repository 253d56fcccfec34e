#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "core/base/error.h"

namespace graftsman {

/// Writes `bytes` as the whole content of the file. Atomic: writes beside it, flushes to the disk, renames;
/// on failure the old file stands as it was and nothing is left beside it. A symbolic link is followed; a
/// device or a pipe is written to directly. Error: FileUnwritable, with the system's reason.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

/// The same with the content block by block: `next` gives the following block, valid until it is called
/// again, and an empty one at the end. An Error of it is returned, the old file stands.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path,
                                     const std::function<Result<std::string_view>()>& next);

}  // namespace graftsman
