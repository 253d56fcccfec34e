#pragma once

#include <memory>
#include <vector>

#include "widgets/theme/theme.h"
#include "widgets/viewport/colouring_scale.h"
#include "widgets/viewport/colouring_seam.h"

namespace graftsman {

/// The colours of one sheet.
struct SheetColours {
  enum class Per { WholeSheet, EachVertex, EachFace } per = Per::WholeSheet;
  Rgba uniform;            // Per::WholeSheet
  std::vector<Rgba> each;  // otherwise, of each vertex or face
};

/// What there is to say about the colours in numbers; meaningful for the colouring that shows it.
struct ColouringNumbers {
  double meanSeamAngle = 0;  // degrees
  double greatestSeamAngle = 0;
  double smallestAngle = 0;  // of all triangles, degrees
  Index baseVertices = 0;    // of the combined tile: those of the base alone …
  Index partVertices = 0;    // … of the part alone …
  Index commonVertices = 0;  // … and those where both meet: crossing edges, shared vertices
};

/// The colours of a result. Keeps up with its curve without allocating.
class SurfaceColours {
 public:
  /// Precondition: `surface` outlives this.
  SurfaceColours(const MorphSurface& surface, Colouring colouring, const Theme& theme);

  /// Computes anew what depends on the curve. seamMoved: what MorphSurface::setCurve() said.
  void follow(bool seamMoved);

  [[nodiscard]] Colouring colouring() const { return colouring_; }
  [[nodiscard]] const SheetColours& rest() const { return rest_; }
  [[nodiscard]] const SheetColours& rim() const { return rim_; }
  [[nodiscard]] const SheetColours& tile() const { return tile_; }
  /// Of each edge of the seam; only for SeamAngle, otherwise empty.
  [[nodiscard]] const std::vector<Rgba>& seam() const { return seam_; }
  [[nodiscard]] const ColouringNumbers& numbers() const { return numbers_; }

  /// The scales' colours. Angles in degrees.
  [[nodiscard]] static Rgba ofSeamAngle(double degrees);
  [[nodiscard]] static Rgba ofSmallestAngle(double degrees);
  static constexpr double kGreatestSeamAngle = 90;  // the scale ends here
  static constexpr double kGreatestSmallestAngle = 60;

  /// Where a vertex of the combined tile comes from.
  enum class Origin : std::uint8_t { Base, Part, Both };
  [[nodiscard]] static Origin originOf(const CombinedTile& combined, Index vertex);
  /// Its colour in this theme.
  [[nodiscard]] static Rgba ofOrigin(Origin origin, const Theme& theme);

 private:
  void colourWeights();
  void colourOrigins();
  void colourSeam();

  const MorphSurface& surface_;
  Colouring colouring_;
  Theme theme_;
  SheetColours rest_;
  SheetColours rim_;
  SheetColours tile_;
  std::vector<Rgba> seam_;
  SeamAngles angles_;
  std::vector<std::size_t> byAngle_;  // the seam's edges
  ColouringNumbers numbers_;
  double restSine_ = 0;  // of the rest's smallest angle
  double rimSine_ = 0;
};

}  // namespace graftsman
