#pragma once

#include <filesystem>

#include "core/fusion/update.h"

namespace graftsman {

/// True for the names that writeResult() knows: .obj, .ply, .stl, .off, and .glb, in any case.
[[nodiscard]] bool isResultName(const std::filesystem::path& path);

/// Writes a finished fusion (`results.fused` present) in the format that the name's ending says. GLB holds
/// the morph from the base's shape (weight 0) to the part's (weight 1). Errors: those of writeMesh() and
/// writeGlb().
[[nodiscard]] Result<void> writeResult(const std::filesystem::path& path, const FusionResults& results,
                                       const Progress& progress);

/// Makes the folder, and those above it, where it is none yet. Error: FileUnwritable, with the system's
/// reason.
[[nodiscard]] Result<void> makeFolder(const std::filesystem::path& folder);

}  // namespace graftsman
