#pragma once

#include <span>
#include <vector>

#include "core/fusion/combined_tile.h"
#include "core/fusion/fcf.h"

namespace graftsman {

/// Writes v = f(s) v¹ + (1 − f(s)) v² (Kanai et al. 1999, Eq. 1) for every vertex of the combined tile into
/// out[target[i]]. Exactly v² where f is 0 and v¹ where it is 1. Cannot fail; memory-bound; allocates nothing
/// for up to 2¹⁸ vertices (more are shared among threads, which must be started). Precondition: `target` has
/// one entry for each vertex of the combined tile, all different.
void blend(const CombinedTile& combined, const FCF& fcf, std::span<const Index> target, std::span<Point> out);

}  // namespace graftsman
