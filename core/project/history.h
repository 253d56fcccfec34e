#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/project/document.h"

namespace graftsman {

/// One step of the undo history: what leads from one state of a document to the next.
struct HistoryStep {
  std::string text;          // what was done, for a person; UTF-8
  FusionId shownBefore = 1;  // the fusion that is shown once the step is undone
  FusionId shownAfter = 1;   // and once it is done
  std::optional<int> cv;     // what it touched, so that undo and redo can show it
  std::optional<int> curvePoint;

  friend bool operator==(const HistoryStep&, const HistoryStep&) = default;
};

/// The undo history of a document. A value; states share what did not change from one to the next.
struct History {
  std::vector<HistoryStep> steps;
  std::vector<Document>
      states;     // steps.size() + 1: step i leads from state i to state i + 1; none without steps
  int index = 0;  // the state that the document is in
};

/// What a project file keeps of a history; the oldest steps that do not fit are left out, with all before
/// them. (If the steps that can be redone do not fit by themselves, the farthest of them are left out too.)
namespace history_bounds {
/// More steps than anyone goes back one by one; a day's work is a few hundred.
inline constexpr std::size_t kMostSteps = 1000;
/// Of history.json, in bytes: a state of a loop of 20 pairs takes about 2 kB, so that a thousand fit, and
/// reading them takes a tenth of a second.
inline constexpr std::size_t kMostBytes = std::size_t{4} << 20;
/// Of meshes that the document has no more and only the history needs, in bytes as they lie in the file (a
/// million faces are 24 MB): without a bound, each mesh that was tried once would stay for ever.
inline constexpr std::size_t kMostMeshBytes = std::size_t{64} << 20;
/// Fusions and variants that all states together list. What a state shares with its neighbour costs nothing
/// in the file but 16 bytes in memory: 32 MB at most.
inline constexpr std::size_t kMostListed = std::size_t{2} << 20;
}  // namespace history_bounds

}  // namespace graftsman
