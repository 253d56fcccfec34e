#pragma once

#include <span>
#include <vector>

#include "core/fusion/combined_tile.h"

namespace graftsman {

/// A place on an edge of the combined tile.
struct RingCrossing {
  Index from = 0;
  Index to = 0;
  double t = 0;  // 0 at `from`, 1 at `to`
};

/// The ring of the combined tile at one distance from the seam, as segments: each two crossings in turn are
/// the ends of one.
class RingLine {
 public:
  /// Finds the ring, in one pass over the faces; keeps its memory from one call to the next. s ≤ 0 gives the
  /// seam; nothing if no face reaches from below s to it.
  void find(const CombinedTile& combined, double s);
  /// Puts the crossings on the tile's vertices as they are now. tilePositions: 3 × V.
  void place(const float* tilePositions);
  void clear();

  [[nodiscard]] const std::vector<RingCrossing>& crossings() const { return crossings_; }
  /// 3 floats for each crossing, where place() put them.
  [[nodiscard]] const std::vector<float>& positions() const { return positions_; }

 private:
  std::vector<RingCrossing> crossings_;
  std::vector<float> positions_;
};

}  // namespace graftsman
