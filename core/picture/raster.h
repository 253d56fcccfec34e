#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/picture/picture_camera.h"

namespace graftsman::picture_detail {

/// How the samples of a raster see the scene: sample (x, y) looks along ((x − centreX) step, (centreY − y)
/// step, 1) in camera space: x to the right, y up, z into the picture, in units of the distance from the
/// camera to its pivot.
struct Lens {
  float centreX = 0;
  float centreY = 0;
  float step = 1;

  [[nodiscard]] Eigen::Vector3f ray(int x, int y) const {
    return {(static_cast<float>(x) - centreX) * step, (centreY - static_cast<float>(y)) * step, 1};
  }
};

/// What one sample sees: 1 / depth and a face, or 0 and −1.
struct Sample {
  float nearness = 0;
  Index face = -1;
};

/// The nearest face at each sample of a picture.
struct Raster {
  int width = 0;  // in samples
  int height = 0;
  Lens lens;
  std::vector<Eigen::Vector3f> points;  // V×3; camera space
  std::vector<Sample> samples;          // height × width

  [[nodiscard]] const Sample& at(int x, int y) const {
    return samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
};

/// Draws the faces, both sides of each, into a raster of width × height samples. What is nearer to the camera
/// than a thousandth of the pivot's distance is cut off. Corners are rounded to 1/256 of a sample and edges
/// decided in integers, so that neighbours leave no gap. Of faces equally near the first is seen.
[[nodiscard]] Raster rasterise(std::span<const Point> points, std::span<const Face> faces,
                               const PictureCamera& camera, int width, int height);

}  // namespace graftsman::picture_detail
