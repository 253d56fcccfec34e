#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A line L_i between CV i and CV i+1 on both meshes, and the map that Eqs. 4–6 make of it.
struct BoundaryLine {
  Point origin;            // p_i on the part
  Eigen::Vector3d edge;    // p_{i+1} − p_i on the part; its length is l_i^1 > 0
  Eigen::Matrix3d linear;  // (l_i^2 / l_i^1) · (frame on the base) · (frame on the part)ᵀ
  Point image;             // p_i on the base: v ↦ linear · (v − origin) + image
};

/// The lines of a loop (Kanai et al. 1999, §3.3), from the CVs' positions on both meshes (n×3, each relative
/// to the same origin). A line of no length on either mesh is left out, so there may be fewer than n, even
/// none. `turn` is the rotation from the part's directions to the base's that the frames are compared in:
/// the identity once the part is aligned.
///
/// Differs: z is of unit length, so that the frame is orthonormal as the paper means it. Where the centroid
/// lies near the line, whose z then has no direction, the normal of the whole loop takes its place, the two
/// blended in between. Where z of the two meshes point apart (the centroid lies on the other side of the line
/// on one of them, as beside a concave corner), the base's is turned round: otherwise the line would turn its
/// surroundings by half a turn.
[[nodiscard]] std::vector<BoundaryLine> boundaryLines(std::span<const Point> partCvs,
                                                      std::span<const Point> baseCvs,
                                                      const Eigen::Matrix3d& turn);

}  // namespace graftsman
