#pragma once

#include <filesystem>

#include "core/io/scenario.h"

namespace graftsman {

/// Whether the name is a project's: it ends in .graft, in any case.
[[nodiscard]] bool isProjectName(const std::filesystem::path& path);

/// Reads the fusion that a project (isProjectName()) or a scenario (any other) holds, with
/// its meshes. A project's fusion is given as if a scenario had said it, named after the file. Errors: those
/// of readScenario() and readProject(); of a project also MeshEmpty and LoopTooShort (it is not finished),
/// what is damaged in it, and SourceUnfused. Messages begin with the file's name, or with that of one that it
/// names.
[[nodiscard]] Result<LoadedScenario> readFusion(const std::filesystem::path& path, const Progress& progress);

}  // namespace graftsman
