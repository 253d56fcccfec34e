#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/fusion/loop.h"
#include "core/fusion/paths.h"

namespace graftsman {

/// One mesh's paths between the pairs of a loop, each as if it were alone: what a person sees while picking,
/// and of a loop whose paths cross.
struct OpenPaths {
  std::shared_ptr<const TriangleMesh> source;  // the mesh that was asked for
  PathMode mode = PathMode::Straightened;
  std::shared_ptr<const AnchoredLoop> anchored;  // null where anchoring failed
  std::vector<std::shared_ptr<const Path>>
      paths;                   // path i leads from CV i to CV i+1; null where there is none
  std::optional<Error> error;  // the first one met
};

/// The paths between consecutive pairs, and if `closed` from the last to the first. Paths between the same
/// two vertices of the same mesh are taken over from `previous`. On an error or a cancel it returns what it
/// has, with the error: those of anchorPoints, PathImpossible (naming its path; the others are still found),
/// Cancelled, OutOfMemory, Unexpected.
[[nodiscard]] OpenPaths findOpenPaths(const std::shared_ptr<const TriangleMesh>& mesh, const Loop& pairs,
                                      bool closed, Side side, PathMode mode, const OpenPaths& previous,
                                      const Progress& progress);

}  // namespace graftsman
