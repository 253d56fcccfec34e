#pragma once

#include <memory>
#include <span>
#include <vector>

#include "widgets/viewport/colouring_scale.h"
#include "widgets/viewport/morph_surface.h"

class vtkRenderer;

namespace graftsman {

/// Shows segments in a scene, lying on a surface, from buffers of someone else.
class LineActor {
 public:
  explicit LineActor(vtkRenderer& renderer);
  ~LineActor();
  LineActor(const LineActor&) = delete;
  LineActor& operator=(const LineActor&) = delete;

  /// positions: 3 × vertexCount, relative to `centre`; ends: two vertices a segment, copied. `box` holds the
  /// lines, relative to `centre`. Precondition: the positions stay until hide() or the next show().
  void show(const float* positions, Index vertexCount, std::span<const Index> ends,
            const Eigen::AlignedBox3d& box, const Point& centre);
  void hide();
  /// What the buffer holds has changed.
  void moved();

  void setColour(const Rgba& colour);
  /// A colour for each segment instead, copied; empty: none.
  void setColours(std::span<const Rgba> colours);
  /// Lies a little nearer to this eye than the surface, so that it is seen whole.
  void liftTowards(const Point& eye);
  /// In device pixels.
  void setWidth(double width);
  void setVisible(bool visible);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace graftsman
