#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/project/document.h"

namespace graftsman {

/// What is known of the fusions of a document, by id: results to go on from, and the meshes made of them. One
/// evaluation fills it for the next.
struct Evaluated {
  struct One {
    FusionResults results;
    std::shared_ptr<const MeshAsset> asset;  // the result as a mesh, made where another fusion asks for it
    std::shared_ptr<const FusedMesh> of;     // what the asset's mesh was made of
  };
  std::map<FusionId, One> fusions;

  /// Without the fusions that the list no longer has.
  void prune(const FusionList& list);
};

/// Meshes of results, by the id of the fusion. Null: it has none.
using ResultAssets = std::map<FusionId, std::shared_ptr<const MeshAsset>>;

/// The fusion with the present meshes of the results that it is made of, and the CVs on them found again at
/// their places; a result that `assets` lacks leaves that side without a mesh. One that is resolved already
/// is returned as it is.
[[nodiscard]] Fusion resolve(Fusion fusion, const ResultAssets& assets);

/// The CVs that were found again farther from their places than 1 % of the mesh's diagonal: one Error for
/// each side, which names them and says how far at most.
[[nodiscard]] std::vector<Error> movedCVs(const Fusion& resolved);

/// Computes all that fusion `id` is made of, not itself, each by update() from what is `known`, which it
/// brings up to date: only what depends on a change is computed again. Returns the results that `id` names
/// and those further upstream. Errors: SourceUnfused, Cancelled: one of them has no result. Precondition:
/// `id` is there.
struct Upstream {
  ResultAssets assets;
  std::optional<Error> error;
};
[[nodiscard]] Upstream evaluateUpstream(const FusionList& fusions, FusionId id, Evaluated& known,
                                        const Progress& progress, const StageStarted& started = {});

/// A fusion of a document with what it was computed from.
struct Evaluation {
  Fusion fusion;          // resolved
  ResultAssets assets;    // of the fusions upstream
  FusionResults results;  // with the upstream's error where it has one
};

/// Computes fusion `id` after all that it is made of. One whose loop is open or whose meshes are not loaded
/// has no results, without an error. Pure but for `known`. Precondition: `id` is there.
[[nodiscard]] Evaluation evaluate(const FusionList& fusions, FusionId id, Evaluated& known,
                                  const Progress& progress, const StageStarted& started = {});

}  // namespace graftsman
