#pragma once

#include <array>
#include <vector>

#include "core/fusion/combined_tile.h"

/// Parts of overlay(), one step a file; nothing outside the overlay uses them.
namespace graftsman::overlay_detail {

/// One embedding as a triangulation of the polygon that both share: its boundary has the other's vertices,
/// too. Vertices: first the seam's S, then the embedding's interior ones in their order. Halfedges as in
/// TriangleMesh. Every triangle is counter-clockwise by orient2d(); every interior edge has an interior
/// vertex at one end.
struct Layer {
  const Embedding* embedding = nullptr;
  std::vector<Point2> uv;
  std::vector<Face> faces;
  std::vector<Index> origins;            // of each face, the embedding's face that it lies in
  std::vector<Index> twins;              // of each halfedge; −1 on the boundary
  std::vector<SeamPosition> seam;        // S
  std::vector<Index> boundaryHalfedges;  // S; halfedge k leads from seam vertex k to k + 1

  [[nodiscard]] Index seamSize() const { return static_cast<Index>(seam.size()); }
  [[nodiscard]] Index vertexCount() const { return static_cast<Index>(uv.size()); }
  [[nodiscard]] Index faceCount() const { return static_cast<Index>(faces.size()); }
  [[nodiscard]] Index halfedgeCount() const { return 3 * faceCount(); }
  [[nodiscard]] const Point2& at(Index v) const { return uv[static_cast<std::size_t>(v)]; }
  [[nodiscard]] Index from(Index h) const { return (&faces[0][0])[h]; }
  [[nodiscard]] Index to(Index h) const { return from(next(h)); }
  [[nodiscard]] Index twin(Index h) const { return twins[static_cast<std::size_t>(h)]; }
  [[nodiscard]] static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  /// The embedding's vertex for an interior vertex of the layer.
  [[nodiscard]] Index embeddingVertex(Index v) const {
    return v - seamSize() + static_cast<Index>(embedding->boundary.size());
  }
};

/// The part's and the base's layer; the seam vertices' positions have the same bits in both.
struct Layers {
  Layer part;
  Layer base;
};

/// Merges the two boundaries by side and parameter, and divides the boundary triangles of each embedding for
/// the other's boundary vertices. Errors: CombinedTileTooFine.
[[nodiscard]] Result<Layers> mergeSeams(const Embedding& part, const Embedding& base);

}  // namespace graftsman::overlay_detail
