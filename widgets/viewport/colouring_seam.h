#pragma once

#include <vector>

#include "widgets/viewport/morph_surface.h"

namespace graftsman {

/// The jump of the normals across the seam, in degrees.
struct SeamAngles {
  std::vector<double> degrees;  // of each seam edge; negative where there is none: a border, or a face
                                // without area
  double mean = 0;              // weighted by the edges' lengths
  double greatest = 0;
};

/// Measures along the surface's present curve, in double precision; keeps the memory of `angles`. Cost: in
/// proportion to the seam.
void measureSeamAngles(const MorphSurface& surface, SeamAngles& angles);

}  // namespace graftsman
