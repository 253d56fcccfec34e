#pragma once

#include <memory>

#include "widgets/viewport/colouring_surface.h"
#include "widgets/viewport/morph_surface.h"
#include "widgets/viewport/stand_in.h"

class vtkRenderer;

namespace graftsman {

/// Shows a sheet in a scene, from the sheet's own buffers.
class SheetActor {
 public:
  explicit SheetActor(vtkRenderer& renderer);
  ~SheetActor();
  SheetActor(const SheetActor&) = delete;
  SheetActor& operator=(const SheetActor&) = delete;

  /// Precondition: the sheet's buffers stay until hide() or the next show().
  void show(const MorphSheet& sheet, const Point& centre);
  void hide();
  /// What the buffers hold has changed.
  void moved();
  void normalsChanged();

  /// Precondition: `colours` stays as long as it is shown. Also to be called when it has changed.
  void setColours(const SheetColours& colours);
  [[nodiscard]] StandIn& standIn();
  void setVisible(bool visible);
  void setOpacity(double opacity);
  void setWireframe(bool wireframe);
  /// Draws the edges of the faces, `width` device pixels wide; 0: none.
  void setEdges(double width, const Rgba& colour);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace graftsman
