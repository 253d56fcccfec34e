#pragma once

#include <memory>
#include <optional>

#include "core/fusion/update.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {

/// What the colours of the result mean.
enum class Colouring {
  Plain,
  FusionCurve,  // f at each vertex: from the base's colour to the part's
  Origin,       // rest of the base, tile by the base's vertices, by the part's, by both
  SeamAngle,    // the jump of the normals across the seam
  Quality,      // smallest angle of each triangle
};

/// The result in Fusion mode. Shows the fused mesh, and follows the fusion curve by itself: setCurve() blends
/// and shows within the next frame, without a worker.
class ResultPane : public Viewport {
  Q_OBJECT

 public:
  explicit ResultPane(QWidget* parent = nullptr);
  ~ResultPane() override;

  /// Shows a finished fusion (`fused` present), or nothing (null). The camera stays unless nothing was shown
  /// before.
  void setResults(std::shared_ptr<const FusionResults> results);
  /// Shows the present combined tile blended along another curve. Nothing is computed beyond what is seen.
  void setCurve(const FCF& curve);

  void setColouring(Colouring colouring);
  void setEdgesShown(bool shown);
  void setWireframe(bool wireframe);
  void setSeamShown(bool shown);
  /// The ring of the surface at this distance from the seam, or none.
  void setRing(std::optional<double> s);
  /// Shows the part's tile in place beside the base: none, as it was given, or as the adjustment left it.
  enum class PartInPlace { Hidden, Before, After };
  void setPartInPlace(PartInPlace shown);

 Q_SIGNALS:
  /// s of the combined tile under the pointer; negative: the pointer is elsewhere.
  void sHovered(double s);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace graftsman
