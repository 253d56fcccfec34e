#pragma once

#include <vector>

#include "core/fusion/embedding_tile.h"

namespace graftsman {

/// How good a layout of a tile is.
struct LayoutCheck {
  std::vector<Index> badFaces;   // not counter-clockwise, or too flat at the boundary; ascending
  Index flippedFaces = 0;        // not counter-clockwise
  double smallestAreaRatio = 0;  // least over the faces of uv-area / (n-gon's area · share of 3D area)
  double squeezedShare = 0;      // share of the 3D area in faces whose ratio is below kSqueezed

  [[nodiscard]] bool valid() const { return badFaces.empty(); }

  /// True if a protrusion is squeezed towards a point: one face in a bad triangulation does not count.
  [[nodiscard]] bool squeezes() const { return squeezedShare > kSqueezedShare; }

  /// A face has shrunk to a 300th of its length, below what a person can tell apart on the fusion curve's
  /// axis. On a tube that begins beyond 7 radii.
  static constexpr double kSqueezed = 1e-5;
  static constexpr double kSqueezedShare = 0.02;
};

/// True if a, b, c turn counter-clockwise, exactly, and, where ab lies on the boundary, keep doing so when
/// the overlay puts further points on ab, which lie beside it by their rounding.
[[nodiscard]] bool isGoodTriangle(const Point2& a, const Point2& b, const Point2& c, bool onBoundary);

/// True if face f of the layout is good.
[[nodiscard]] bool isGoodFace(const EmbeddingTile& tile, const std::vector<Point2>& uv, Index f);

/// Checks every face. uv: V'×2.
[[nodiscard]] LayoutCheck checkLayout(const EmbeddingTile& tile, const std::vector<Point2>& uv, Index sides);

}  // namespace graftsman
