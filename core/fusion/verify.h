#pragma once

#include <string>

#include "core/fusion/update.h"
#include "core/mesh/mesh_check.h"

namespace graftsman {

/// What must always hold of a fusion (DESIGN.md §4), measured on one result.
struct Verification {
  MeshCheck base;
  MeshCheck result;

  /// Greatest distance of a combined tile's vertex, at f = 0, from the base triangle that each of its faces
  /// lies in; and at f = 1 from the adjusted part's triangle. Fractions of the base's diagonal.
  double baseDistance = 0;
  double partDistance = 0;
  /// |area of the combined tile at f = 0 − area of the base's tile|, as a fraction of the latter: nothing
  /// lost or folded.
  double baseAreaError = 0;
  /// |Σ area of H^c − area of the n-gon|, as a fraction of the latter.
  double embeddedAreaError = 0;
  Index invertedFaces = 0;  // faces of H^c that are clockwise by more than the rounding of their corners
  Index changedBaseVertices = 0;  // kept vertices of the base, off the seam, whose bits differ

  double meanSeamAngle = 0;      // degrees, between the normals beside a seam edge, weighted by its length
  double greatestSeamAngle = 0;  // degrees

  [[nodiscard]] bool baseUnchanged() const { return changedBaseVertices == 0; }
  /// The result is as manifold, oriented and closed as the base, with its Euler characteristic and border
  /// loops.
  [[nodiscard]] bool topologyKept() const;
  /// All of it, with distances within 1e-12 of the diagonal (or the rounding of coordinates far from the
  /// origin).
  [[nodiscard]] bool holds() const { return broken().empty(); }
  /// What does not hold, with its numbers, as a list for one sentence; empty if all does.
  [[nodiscard]] std::string broken() const;
  double tolerance = 1e-12;  // of the distances, as a fraction of the base's diagonal
};

/// Measures a finished fusion (`results.fused` present). Linear cost, a multiple of the blend's: not for
/// every frame.
[[nodiscard]] Verification verify(const FusionResults& results);

}  // namespace graftsman
