#pragma once

#include <memory>
#include <optional>

#include "widgets/theme/theme.h"
#include "widgets/viewport/colouring_surface.h"
#include "widgets/viewport/morph_actor.h"
#include "widgets/viewport/morph_lines.h"
#include "widgets/viewport/morph_still.h"
#include "widgets/viewport/ring_line.h"

namespace graftsman {

/// How a result is shown.
struct MorphLook {
  Colouring colouring = Colouring::Plain;
  bool edges = false;
  bool wireframe = false;
  bool seam = true;
  Theme theme;
  double ratio = 1;  // device pixels per device-independent one
};

/// The result of a fusion in a scene: its sheets, the seam, a ring, and the part's tile in place. Renders
/// nothing by itself.
class MorphScene {
 public:
  explicit MorphScene(vtkRenderer& renderer);

  /// Shows a surface, or nothing (null). Precondition: the surface stays until the next call.
  void show(MorphSurface* surface);
  void setCurve(const FCF& curve);
  void setLook(const MorphLook& look);
  [[nodiscard]] const MorphLook& look() const { return look_; }
  /// The ring at this distance from the seam, or none.
  void setRing(std::optional<double> s);
  /// Shows a tile of the part over the result's, which becomes faint; nothing: as usual.
  void setPart(std::optional<StillSheet> part);
  /// Before each frame: lines lie in front of the surface as seen from `eye`.
  void prepare(const Point& eye);
  /// Of the sheets that may have many faces.
  [[nodiscard]] std::vector<StandIn*> standIns() { return {&rest_.standIn(), &tile_.standIn()}; }
  /// Nothing is shown: null.
  [[nodiscard]] const SurfaceColours* colours() const { return colours_ ? &*colours_ : nullptr; }

 private:
  void colour();
  void showColours();
  void showSeam();
  void showRing();
  void applyLook();

  MorphSurface* surface_ = nullptr;
  MorphLook look_;
  std::optional<SurfaceColours> colours_;
  std::optional<double> ring_;
  RingLine ringLine_;
  std::vector<Index> ringEnds_;
  std::optional<StillSheet> part_;
  SheetActor rest_;
  SheetActor rim_;
  SheetActor tile_;
  SheetActor partSheet_;
  LineActor seamLine_;
  LineActor ringActor_;
};

}  // namespace graftsman
