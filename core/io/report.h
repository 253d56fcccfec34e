#pragma once

#include <string>

#include "core/fusion/update.h"
#include "core/fusion/verify.h"
#include "core/io/mesh_file.h"

namespace graftsman {

/// What a report tells besides the results themselves.
struct ReportContext {
  std::string name;   // of the scenario
  std::string input;  // file names, as given
  std::string output;
  std::string version;  // of the program
  ReadReport partReport;
  ReadReport baseReport;
  double readMilliseconds = 0;
  double writeMilliseconds = 0;
  double totalMilliseconds = 0;  // from the start of reading to the end of writing
};

/// The report of a finished fusion as JSON text (DESIGN.md §6): milliseconds of each stage, vertex and face
/// counts in the form of the paper's Table 2, each path's length, the adjustment's steps, the embeddings'
/// weights, the seam's normal angles, and the checks of DESIGN.md §4. `paths` includes the anchoring of CVs,
/// `cut` the tile.
[[nodiscard]] std::string formatReport(const FusionResults& results, const Verification& verification,
                                       const ReportContext& context);

/// The check of a mesh file as JSON text.
[[nodiscard]] std::string formatCheck(const MeshCheck& check, const ReadReport& read,
                                      const std::string& file);

/// What reading did, as lines of text for a person.
[[nodiscard]] std::string describe(const ReadReport& report);

}  // namespace graftsman
