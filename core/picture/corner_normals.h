#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman::picture_detail {

/// The normals that smooth shading needs at the corners of faces.
struct CornerNormals {
  std::vector<Eigen::Vector3f> normals;  // of length 1, or 0 where no face has an area
  std::vector<Face> corners;             // F×3: the normal of each face's corners
};

/// Each corner's normal is the mean, weighted by area, of the faces at its vertex: of all of them where none
/// turns away from that mean by more than half of `creaseAngle` (radians), otherwise of those that turn by
/// less than creaseAngle from the corner's own (and of none else at a vertex of more than 256 faces). Any
/// connectivity. Linear cost.
[[nodiscard]] CornerNormals cornerNormals(std::span<const Point> points, std::span<const Face> faces,
                                          double creaseAngle);

}  // namespace graftsman::picture_detail
