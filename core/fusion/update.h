#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "core/fusion/adjustment.h"
#include "core/fusion/cut.h"
#include "core/fusion/embedding.h"
#include "core/fusion/fcf.h"
#include "core/fusion/join.h"
#include "core/fusion/loop.h"
#include "core/fusion/paths.h"
#include "core/fusion/seam_fit.h"
#include "core/fusion/tile.h"

namespace graftsman {

/// Everything that a person can change about a fusion. A value; the meshes are shared.
struct FusionInputs {
  std::shared_ptr<const TriangleMesh> part;
  std::shared_ptr<const TriangleMesh> base;
  Loop loop;
  PathMode paths = PathMode::Straightened;
  TileOptions tile;
  AdjustmentSettings adjustment;
  EmbeddingSettings embedding;
  FCF fcf;
};

/// The result's mesh: positions of their own, faces shared with the join.
struct FusedMesh {
  std::vector<Point> points;
  std::shared_ptr<const Join> join;

  [[nodiscard]] const std::vector<Face>& faces() const { return join->faces; }
};

/// The stages in the order in which they run.
enum class Stage { Anchor, Paths, Cut, Tile, Adjust, Fit, Embed, Overlay, Join, Blend };
inline constexpr int kStageCount = 10;

/// Called as a stage begins to run, on the thread that runs update(); without a side where it concerns both
/// meshes.
using StageStarted = std::function<void(Stage, std::optional<Side>)>;

/// How one stage went in one update.
struct StageRun {
  bool ran = false;             // false: its result was taken over, or it was not reached
  double milliseconds = 0;      // of both meshes together
  double partMilliseconds = 0;  // of these, the part's share; 0 where a stage concerns both
};

/// What one mesh's own stages made.
struct SideResults {
  std::shared_ptr<const AnchoredLoop> anchored;
  std::shared_ptr<const LoopPaths> paths;
  std::shared_ptr<const graftsman::Cut> cut;
  std::shared_ptr<const graftsman::Tile> tile;
  std::shared_ptr<const Embedding> embedding;
};

/// Everything computed of a fusion. Immutable objects, shared from one update to the next where nothing
/// changed.
struct FusionResults {
  FusionInputs inputs;  // of this run
  SideResults part;
  SideResults base;
  std::shared_ptr<const Adjustment> adjustment;
  std::shared_ptr<const FittedTile> fitted;  // the part's tile as it is embedded
  std::shared_ptr<const CombinedTile> combined;
  std::shared_ptr<const graftsman::Join> join;
  std::shared_ptr<const FusedMesh> fused;
  std::optional<Error> error;                   // why `fused` is missing, and at which stage
  Stage failedAt = Stage::Anchor;               // meaningful with `error`
  std::array<StageRun, kStageCount> runs = {};  // by Stage

  [[nodiscard]] const StageRun& run(Stage stage) const { return runs[static_cast<std::size_t>(stage)]; }
};

/// Runs the stages that the inputs need (DESIGN.md §3): a stage runs only when one of its inputs is not the
/// very object (or, for settings, not equal to the value) that it had in `previous`. On an error or a cancel
/// the stages that did finish are returned, so that the next update goes on from there. Pure: depends on
/// nothing else, changes nothing. Exceptions of libraries and bad_alloc come back as Unexpected and
/// OutOfMemory.
[[nodiscard]] FusionResults update(const FusionInputs& inputs, const FusionResults& previous,
                                   const Progress& progress, const StageStarted& started = {});

/// "paths", "cut", …: the stage's name in reports and messages.
[[nodiscard]] const char* name(Stage stage);

}  // namespace graftsman
