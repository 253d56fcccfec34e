#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// x ↦ rotation · x + translation; det rotation = +1.
struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// Settings of the adjustment (Kanai et al. 1999, §3.4).
struct AdjustmentSettings {
  bool rigid = true;      // STEP 1, and the rigid part of STEP 2
  bool scale = true;      // STEP 2
  bool lineField = true;  // STEP 3
  bool exactFit =
      true;  // beyond the paper, after the steps: the whole boundary onto the base's; see seam_fit.h
  double epsilon =
      1e-3;  // ε: mean CV distance at which to stop, as a fraction of the base loop's diameter; ≥ 0
  double falloff = 5;      // n of Eq. 8; > 0
  int maxIterations = 20;  // of STEP 2; ≥ 1
  friend bool operator==(const AdjustmentSettings&, const AdjustmentSettings&) = default;
};

/// The step that ended the adjustment.
enum class AdjustmentStep { None, Rigid, Scale, LineField };

/// What the adjustment did. Distances are means over the CVs, in the base's unit.
struct AdjustmentReport {
  AdjustmentStep reached = AdjustmentStep::None;
  int iterations = 0;  // of STEP 2
  double scale = 1;    // k: product of all scalings
  RigidTransform
      transform;  // with k: the part's point x went to k · rotation · x + translation before STEP 3
  double distanceBefore = 0;
  double distanceAfterRigid = 0;  // equal to the one before where the step did not run; likewise below
  double distanceAfterScale = 0;
  double distanceAfterLineField = 0;
  double loopDiameter = 0;  // greatest distance of two base CVs
};

/// The part's tile brought to the base's loop.
struct Adjustment {
  std::vector<Point> points;  // V×3, as given, moved
  AdjustmentReport report;
};

/// Brings `points` (V×3, the part's tile) to the base by STEPs 1–3, from the CVs' positions on both meshes
/// (n×3 each, n ≥ 3). Cost of STEP 3: one pass over the points for each line. Same bits on any number of
/// threads. Errors: LoopDegenerate (all CVs of a mesh coincide; no scale greater than 0 fits; no two
/// neighbouring CVs lie apart on both meshes), SettingOutOfRange, Cancelled.
///
/// Differs: k of Eq. 3 is taken with both loops about their centroids, since as printed it depends on where
/// the origin lies; without the rigid step the part grows about its own loop's centroid. A step that is
/// switched off is passed over, and nothing moves, to the last bit, if the CVs coincide at the start. More
/// beside boundaryLines() and LineField.
[[nodiscard]] Result<Adjustment> adjust(std::span<const Point> points, std::span<const Point> partCvs,
                                        std::span<const Point> baseCvs, const AdjustmentSettings& settings,
                                        const Progress& progress);

}  // namespace graftsman
