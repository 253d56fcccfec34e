#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/fusion/update.h"
#include "core/io/mesh_file.h"

namespace graftsman {

/// A fusion as plain text (DESIGN.md §5), before its meshes are read.
struct Scenario {
  std::string name;
  std::filesystem::path part;  // m1, resolved against the scenario's folder
  std::filesystem::path base;  // m2
  FusionInputs inputs;         // meshes empty; CVs in the files' own vertex and face numbers
};

/// A scenario with its meshes read and its CVs in the meshes' numbers.
struct LoadedScenario {
  Scenario scenario;
  ReadReport partReport;
  ReadReport baseReport;
};

/// Parses the JSON text of a scenario. Keys: name, m1, m2, cvp, fcf (a list of [s, f], or a preset's name),
/// monotone, deform_exponent; optional settings: paths ("straightened" | "paper"), allow_large_tile,
/// adjustment {rigid, scale, line_field, epsilon, max_iterations}, embedding ("automatic" | "cotangent" |
/// "mean-value" | "low-stretch"); note and unknown keys are ignored. Error: ScenarioMalformed with the key
/// (and for broken JSON the line), or the curve's own errors.
[[nodiscard]] Result<Scenario> parseScenario(std::string_view text, const std::filesystem::path& path);

/// Reads a scenario and its two meshes (each file once). Errors: also those of readMesh, and
/// LoopIndexOutOfRange.
[[nodiscard]] Result<LoadedScenario> readScenario(const std::filesystem::path& path,
                                                  const Progress& progress);

}  // namespace graftsman
