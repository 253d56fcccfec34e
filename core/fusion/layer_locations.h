#pragma once

#include <span>
#include <vector>

#include "core/fusion/seam_merge.h"

namespace graftsman::overlay_detail {

/// Turns places on a layer into locations on its embedding and positions on its tile.
class LayerLocations {
 public:
  /// points: V×3, the tile's.
  LayerLocations(const Layer& layer, std::span<const Point> points);

  [[nodiscard]] TileLocation atVertex(Index v) const;
  /// On the edge of halfedge h, at the fraction t of it.
  [[nodiscard]] TileLocation onEdge(Index h, double t) const;
  /// The point `uv` of face f, or the one near it that rounding leaves.
  [[nodiscard]] TileLocation inFace(Index f, const Point2& uv) const;
  /// The fraction of halfedge h at which the point `uv` on it lies.
  [[nodiscard]] double fraction(Index h, const Point2& uv) const;
  /// On the tile: exactly the vertex's point at a vertex; otherwise from the differences to the first corner,
  /// so that small tiles far from the origin lose nothing.
  [[nodiscard]] Point position(const TileLocation& location) const;

 private:
  [[nodiscard]] bool isEmbeddingVertex(Index v) const;
  [[nodiscard]] Index embeddingVertex(Index v) const;
  [[nodiscard]] TileLocation inDividedFace(Index f, const Eigen::Vector3d& weights) const;

  const Layer& layer_;
  std::vector<Point> points_;  // of the embedding's vertices
};

}  // namespace graftsman::overlay_detail
