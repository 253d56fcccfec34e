#pragma once

#include <memory>
#include <optional>

#include "core/fusion/update.h"
#include "widgets/viewport/colouring_scale.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {

/// The result in Fusion mode. Shows the fused mesh, and follows the fusion curve by itself: setCurve() blends
/// and shows within the next frame, without a worker.
class ResultPane : public Viewport {
  Q_OBJECT

 public:
  explicit ResultPane(QWidget* parent = nullptr);
  ~ResultPane() override;

  /// Shows a finished fusion (`fused` present) along its own curve, or nothing (null). The camera stays
  /// unless nothing was shown before. A large result is made ready on a worker thread, while the pane shows
  /// what it had; of results that come meanwhile the newest is next.
  void setResults(std::shared_ptr<const FusionResults> results);
  /// Shows the combined tile blended along another curve. Nothing is computed beyond what is seen.
  void setCurve(const FCF& curve);

  void setColouring(Colouring colouring);
  void setEdgesShown(bool shown);
  void setWireframe(bool wireframe);
  void setSeamShown(bool shown);
  /// The ring of the surface at this distance from the seam, or none.
  void setRing(std::optional<double> s);
  /// Shows the part's tile in place, over the base's, which becomes faint: none, as it was given, or as the
  /// adjustment left it.
  enum class PartInPlace { Hidden, Before, After };
  void setPartInPlace(PartInPlace shown);

 Q_SIGNALS:
  /// The results last set are on the screen with the next frame.
  void resultsShown();
  /// s of the combined tile under the pointer; negative: the pointer is elsewhere.
  void sHovered(double s);

 protected:
  [[nodiscard]] std::optional<Point> surfaceAt(const QPointF& position) const override;
  [[nodiscard]] std::vector<StandIn*> standIns() const override;
  void prepareFrame(const CameraView& view) override;
  void paintOver(QPainter& painter, const CameraView& view) override;
  void applyTheme(const Theme& theme) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeGL(int width, int height) override;

 private:
  struct Content;
  struct Shown;

  void prepareNext();
  void present(std::shared_ptr<Shown> shown);
  void followCurve();
  void showPart();
  void hover();
  void tellHovered(double s);
  template <class Change>
  void changeLook(const Change& change);

  std::unique_ptr<Content> content_;
};

}  // namespace graftsman
