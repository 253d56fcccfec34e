#pragma once

#include <optional>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/fusion/update.h"
#include "core/mesh/nearest_surface.h"

namespace graftsman {

/// Numbers by which results are compared. Model unit of the base.
struct Measures {
  double meanSeamAngle = 0;      // radians; between the normals beside a seam edge, weighted by its length
  double greatestSeamAngle = 0;  // radians
  double area = 0;               // of the whole result
  std::optional<double> volume;  // that it encloses; where it is closed and oriented
  /// Of the combined tile's vertices to the base's surface, wherever that is nearest: how far the shape was
  /// changed.
  double greatestDistance = 0;
  double meanDistance = 0;  // weighted by each vertex's share of the tile's area
  /// Of the combined tile's triangles, as 4 √3 area / (a² + b² + c²) with the sides a, b, c: 1 for an
  /// equilateral one, 0 for one without area (the mean ratio).
  double worstQuality = 0;
  double lowQuality = 0;  // a twentieth of the triangles has at most this (the 5th percentile)
  double meanQuality = 0;
  Index vertices = 0;  // of the result
  Index faces = 0;
  friend bool operator==(const Measures&, const Measures&) = default;
};

/// Measures a finished fusion (`results.fused` present); `base`: a tree over its base, to be made once for
/// many results. The same bits on any number of threads. Cost: linear, and a look into the tree for each
/// vertex of the combined tile. Errors: Cancelled.
[[nodiscard]] Result<Measures> measure(const FusionResults& results, const NearestSurface& base,
                                       const Progress& progress);

/// The same with a tree of its own; nothing stops it.
[[nodiscard]] Measures measure(const FusionResults& results);

}  // namespace graftsman
