#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// One vector for every vertex of a disk, given those of its boundary: the discrete harmonic extension
/// (cotangent weights), the smoothest there is in the sense of Dirichlet's energy. `points`: V×3, `faces`: a
/// disk whose boundary are the vertices 0 … B − 1, counter-clockwise; `boundary`: B×3, in any unit. The
/// boundary's values come back to the last bit, the others within 1e-7 of the greatest. Errors:
/// EmbeddingFailed (a point that is no number), Cancelled.
[[nodiscard]] Result<std::vector<Eigen::Vector3d>> extendHarmonically(
    std::span<const Point> points, std::span<const Face> faces, std::span<const Eigen::Vector3d> boundary,
    const Progress& progress);

}  // namespace graftsman
