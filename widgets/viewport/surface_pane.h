#pragma once

#include <memory>
#include <span>

#include "core/mesh/triangle_mesh.h"
#include "widgets/viewport/colouring_legend.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {

/// A surface made ready for SurfacePane: shaded and, by distances, coloured. Immutable.
struct DrawnSurface;

/// What lies between two such surfaces, made ready likewise.
struct DrawnBetween;

/// On any thread. `distances`: of each vertex, drawn in the colours of divergingColour(distance / range);
/// empty: in the mesh's colour. `range` > 0.
[[nodiscard]] std::shared_ptr<const DrawnSurface> drawSurface(std::shared_ptr<const TriangleMesh> mesh,
                                                              std::span<const double> distances = {},
                                                              double range = 1);

/// On any thread. Precondition: both have the same faces and as many vertices.
[[nodiscard]] std::shared_ptr<const DrawnBetween> drawBetween(std::shared_ptr<const DrawnSurface> a,
                                                              std::shared_ptr<const DrawnSurface> b);

/// The legend of such distances from −range to range, with numbers in the model's unit. `beyond`: some are
/// greater and have the colours of the ends.
[[nodiscard]] Legend distanceLegend(const QString& title, double range, bool beyond, const QString& note);

/// A pane that only shows a surface, or what lies between two.
class SurfacePane : public Viewport {
  Q_OBJECT

 public:
  explicit SurfacePane(QWidget* parent = nullptr);
  ~SurfacePane() override;

  /// Null: nothing. The camera stays.
  void showSurface(std::shared_ptr<const DrawnSurface> surface);
  /// The surface whose vertices lie at (1 − t) a + t b; at the ends the very surfaces. t in [0, 1].
  void showBetween(const std::shared_ptr<const DrawnBetween>& between, double t);
  /// Explains the colours, in the pane's corner; without a title nothing.
  void setLegend(Legend legend);

  /// The vertices of what is shown, as it is drawn; empty: nothing is shown.
  [[nodiscard]] std::vector<Point> shownPoints() const;

 protected:
  [[nodiscard]] std::vector<StandIn*> standIns() const override;
  void paintOver(QPainter& painter, const CameraView& view) override;
  void applyTheme(const Theme& theme) override;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace graftsman
