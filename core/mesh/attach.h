#pragma once

#include "core/mesh/surface_point.h"

namespace graftsman {

/// The point of the mesh nearest to the point's place: a vertex if it was picked as one (of those that faces
/// use), else any point of a face; with the same place. Of equally near ones the first. Cost: one pass over
/// the mesh. Preconditions: the point has a place, the mesh a face.
[[nodiscard]] SurfacePoint attach(const TriangleMesh& mesh, const SurfacePoint& point);

}  // namespace graftsman
