#pragma once

#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// How far one surface lies from another, in the model's unit. Positive: on the side to which the other's
/// faces look, outside of a closed one.
struct SurfaceDifference {
  std::vector<double> distances;  // of each vertex; exactly 0 for one that is a vertex of the other surface
  double greatest = 0;      // of the vertices that faces use: the farthest outside, or else least inside
  double least = 0;         // the farthest inside, or else least outside
  double meanAbsolute = 0;  // of the distances without sign, weighted by the area round each vertex
  // Without sign, what 95 % of the area that differs at all stays below: a scale on which single spikes do
  // not hide the rest. 0 where nothing differs.
  double usual = 0;
};

/// The distances of the vertices of `surface` to the nearest point of `from`. The sign is that of the
/// angle-weighted pseudonormal of the nearest face, edge or vertex (Bærentzen & Aanæs 2005, "Signed distance
/// computation using the angle weighted pseudonormal", §3): right everywhere round a closed surface; round an
/// open one it has a jump beyond the border. The same bits on any number of threads. Cost O((V + F) log F).
/// Errors: Cancelled. Precondition: `from` has a face.
[[nodiscard]] Result<SurfaceDifference> differenceOf(const TriangleMesh& surface,
                                                     std::shared_ptr<const TriangleMesh> from,
                                                     const Progress& progress);

}  // namespace graftsman
