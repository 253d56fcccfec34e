#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

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
  FusionInputs inputs;         // meshes empty; CVs in the files' own vertex numbers, faces as read
};

/// A scenario with its meshes read and its CVs in the meshes' numbers.
struct LoadedScenario {
  Scenario scenario;
  ReadReport partReport;
  ReadReport baseReport;
  /// As MeshFile::vertexOfFileVertex; also empty where unknown.
  std::vector<Index> partVertexOfFileVertex;
  std::vector<Index> baseVertexOfFileVertex;
};

/// Parses the JSON text of a scenario. Keys: name (the file's name without it), m1, m2, cvp (a list of
/// [m1's, m2's], each a vertex number or {"face": i, "bary": [a, b, c]}), fcf (a list of [s, f], or a
/// preset's name; "linear" without it), monotone (true without it), deform_exponent; optional settings: paths
/// ("straightened" | "paper"), allow_large_tile, adjustment {rigid, scale, line_field, exact_fit, epsilon,
/// max_iterations}, embedding ("automatic" | "cotangent" | "mean-value" | "low-stretch"); note and unknown
/// keys are ignored, but none inside adjustment, and none given twice. A face number counts the triangles as
/// read, which are the file's faces where all of them are triangles and none is dropped. `path` gives the
/// folder, and stands in messages. Error: ScenarioMalformed with the key (and for broken JSON the line), or
/// the curve's own errors.
[[nodiscard]] Result<Scenario> parseScenario(std::string_view text, const std::filesystem::path& path);

/// The JSON text of a scenario that would be saved at `path`: parseScenario() of it with the same path gives
/// an equal scenario, numbers bit for bit. Ends with a newline.
[[nodiscard]] std::string formatScenario(const Scenario& scenario, const std::filesystem::path& path);

/// Turns one side's CVs from a file's numbers into the mesh's that was read from it: `vertexOfFileVertex` is
/// MeshFile's. Error: LoopIndexOutOfRange (names the CV, the file and what it has).
[[nodiscard]] Result<void> useMeshNumbers(Loop& loop, Side side, const TriangleMesh& mesh,
                                          const std::vector<Index>& vertexOfFileVertex,
                                          const std::filesystem::path& path);

/// The content of a JSON file that a person wrote or saved, `what` ("scenario"). Errors: FileUnreadable,
/// ScenarioMalformed (too large to be one).
[[nodiscard]] Result<std::string> readJsonText(const std::filesystem::path& path, const char* what);

/// Reads a scenario and its two meshes (each file once: m1 and m2 alike share one mesh). Errors:
/// FileUnreadable, those of parseScenario and readMesh, and LoopIndexOutOfRange (names the CV, the file and
/// what it has).
[[nodiscard]] Result<LoadedScenario> readScenario(const std::filesystem::path& path,
                                                  const Progress& progress);

}  // namespace graftsman
