#pragma once

#include "core/project/document.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {

/// Where to look at a mesh of the document (also one that is not computed yet) from at first: at its region
/// of the loop, from a little beside and above; without a loop from the front. What is up is guessed: y for
/// OBJ files unless that is the loop's normal, z for others. To be framed.
[[nodiscard]] Camera firstView(const Fusion& fusion, Side side);

/// The camera with y as the upright axis instead of z, or z instead of y; the shape turns with it, so that
/// what was on top is in front or the other way round.
[[nodiscard]] Camera withOtherUp(const Camera& camera);

}  // namespace graftsman
