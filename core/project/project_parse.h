#pragma once

#include <span>

#include "core/project/project_file.h"

namespace graftsman {

/// readProject() of bytes in memory; `path` stands in messages only.
[[nodiscard]] Result<LoadedProject> parseProject(std::span<const char> bytes,
                                                 const std::filesystem::path& path, const Progress& progress,
                                                 Wanted wanted = Wanted::Everything);

}  // namespace graftsman
