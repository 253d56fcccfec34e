#pragma once

#include <span>

#include "core/picture/picture.h"
#include "core/picture/picture_camera.h"

namespace graftsman {

/// How a picture looks (INTERFACE.md: neutral grey under two soft lights before a quiet gradient).
struct PictureShading {
  Colour mesh = {199, 199, 199};
  Colour backgroundTop = {0xF4, 0xF6, 0xF8};
  Colour backgroundBottom = {0xD9, 0xDE, 0xE3};
  std::span<const Colour> vertexColours = {};  // V, instead of `mesh`; or empty
  double creaseAngle = 0.8;                    // radians; edges that turn further are sharp
  bool shadows = true;                         // soft ones, in hollows
  int supersampling = 2;                       // samples a pixel in each direction, 1 to 4
};

/// A picture of a mesh, made without display or graphics card. points: V×3, finite; faces: F×3, every corner
/// in [0, V); any connectivity, both sides are drawn alike. Two lights and a soft glow from above go with the
/// camera. Pure: equal arguments give equal pixels, on any thread. Cost: linear in vertices, faces and
/// samples; 100k faces at 256×192 take about 19 ms of a 2.1 GHz core. Precondition: the size within 1 …
/// kGreatestPictureSide.
[[nodiscard]] Picture draw(std::span<const Point> points, std::span<const Face> faces,
                           const PictureCamera& camera, PictureSize size, const PictureShading& shading = {});

}  // namespace graftsman
