#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// Chains of neighbouring vertices from `from` to `to`, each close to a way that may be the shortest on the
/// surface, best first; empty if the vertices are not connected over non-singular vertices, or cancelled.
///
/// Fast marching from both ends until the fronts have met: a vertex's distance comes from a triangle's other
/// two by unfolding their (virtual) source into its plane, which is exact where the surface is flat. Where
/// the fronts meet, every local minimum of the sum of both distances that is close to the least starts a
/// chain: ways on either side of a bump. Cost: a search of about half the distance round either end. Source:
/// Kimmel & Sethian 1998, with the circular update of Novotni & Klein 2002.
[[nodiscard]] std::vector<std::vector<EdgePoint>> waysByWavefront(const TriangleMesh& mesh, Index from,
                                                                  Index to, const Progress& progress);

}  // namespace graftsman
