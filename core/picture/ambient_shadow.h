#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/picture/raster.h"

namespace graftsman::picture_detail {

/// A pixel's surface: its depth in camera space (0: background) and its normal, towards the camera.
struct PixelSurface {
  float depth = 0;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
};

/// How open each pixel's surface is to light from all around: 1 on a plane, less in hollows and beside what
/// rises over it (McGuire et al. 2011, "The Alchemy screen-space ambient obscurance algorithm", Eq. 10, over
/// a disc of a tenth of the picture's height). pixels: height × width; `lens` for whole pixels. Cost: a few
/// dozen looks a pixel.
[[nodiscard]] std::vector<float> openness(const std::vector<PixelSurface>& pixels, int width, int height,
                                          const Lens& lens);

}  // namespace graftsman::picture_detail
