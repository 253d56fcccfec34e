#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// What the wavefront found.
struct WavefrontWays {
  std::vector<std::vector<EdgePoint>> ways;  // best first; free of nothing: see withoutDetours()
  bool elongated = false;  // many triangles are long and thin, where the distances are not to be trusted
};

/// Ways from `from` to `to` over non-singular vertices, each close to one that may be the shortest on the
/// surface and not longer than about `bound`; none if cancelled.
///
/// Fast marching from both ends until the fronts have met: a vertex's distance comes from a triangle's other
/// two by unfolding their (virtual) source into its plane, which is exact where the surface is flat. Vertices
/// too far from either end for a way within the bound are left out. Where the fronts meet, every local
/// minimum of the sum of both distances that is close to the least starts a way, back to both ends along the
/// rays: so there are ways on either side of a bump. Cost: a search of half the distance round either end,
/// less what the bound spares. Source: Kimmel & Sethian 1998, with the circular update of Novotni & Klein
/// 2002.
[[nodiscard]] WavefrontWays waysByWavefront(const TriangleMesh& mesh, Index from, Index to, double bound,
                                            const Progress& progress);

}  // namespace graftsman
