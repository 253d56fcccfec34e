#pragma once

#include <vector>

#include "core/fusion/overlay_trace.h"

namespace graftsman::overlay_detail {

/// Where an interior vertex of one layer lies in the other.
struct Place {
  enum class Kind : std::uint8_t { InFace, OnEdge, OnVertex } kind = Kind::InFace;
  Index index = -1;  // the other layer's face, halfedge or vertex
};

/// The combined tile's vertices: first the base's layer's, in its order (so the seam's first), then the
/// part's interior ones that lie on none of the base's, then the crossings that lie on no vertex. Without the
/// shift: vertices and crossings at one position are one vertex. Exact: the shift's combinatorics say where
/// to look, equal coordinates and exact zeros decide.
struct VertexNumbers {
  std::vector<Index> ofPart;      // of each vertex of the part's layer, the combined vertex
  std::vector<Place> baseOnPart;  // of each vertex of the base's layer; unused for the seam's
  std::vector<Place> partOnBase;  // likewise
  Index count = 0;
  Index firstCrossing = 0;  // the first combined vertex that is a crossing
};

/// Also puts the combined vertex into each crossing.
[[nodiscard]] VertexNumbers numberVertices(const Layers& layers, Trace& trace);

/// Fills everything of `combined` that concerns vertices, s apart.
void placeVertices(const EmbeddedTile& part, const EmbeddedTile& base, const Layers& layers,
                   const Trace& trace, const VertexNumbers& numbers, CombinedTile& combined);

}  // namespace graftsman::overlay_detail
