#pragma once

#include <vector>

#include "core/fusion/cut.h"
#include "core/mesh/index_set.h"

namespace graftsman {

/// A mesh with its cut applied, as a view: who is beside whom among undivided faces and pieces, without a
/// copy of the mesh. With F faces and V vertices in the mesh, face f < F is the mesh's (only undivided ones
/// occur) and face F + p is piece p of the cut; vertex V + i is the cut's point i. Halfedges as in
/// TriangleMesh. Keeps references to both.
class DividedMesh {
 public:
  /// Cost: the cut's, and a bit per face of the mesh.
  DividedMesh(const TriangleMesh& mesh, const Cut& cut);

  [[nodiscard]] Index vertexCount() const {
    return mesh_.vertexCount() + static_cast<Index>(cut_.points.size());
  }
  [[nodiscard]] Index faceCount() const { return mesh_.faceCount() + static_cast<Index>(cut_.faces.size()); }

  /// True for a face of the mesh that the cut replaces by pieces.
  [[nodiscard]] bool divided(Index face) const { return divided_.contains(face); }

  [[nodiscard]] const Face& face(Index f) const {
    return f < mesh_.faceCount() ? mesh_.face(f)
                                 : cut_.faces[static_cast<std::size_t>(f - mesh_.faceCount())];
  }
  [[nodiscard]] const Point& point(Index v) const {
    return v < mesh_.vertexCount() ? mesh_.point(v)
                                   : cut_.points[static_cast<std::size_t>(v - mesh_.vertexCount())];
  }
  [[nodiscard]] Index from(Index h) const { return face(h / 3)[static_cast<std::size_t>(h % 3)]; }
  [[nodiscard]] Index to(Index h) const { return from(TriangleMesh::next(h)); }

  /// The other halfedge along the same edge, or −1. Precondition: h is of a piece or an undivided face.
  [[nodiscard]] Index twin(Index h) const {
    if (h >= mesh_.halfedgeCount()) {
      return pieceTwins_[static_cast<std::size_t>(h - mesh_.halfedgeCount())];
    }
    const Index t = mesh_.twin(h);
    return t < 0 || !divided(t / 3) ? t : pieceAlong(t);
  }

  /// The halfedge from a to b, or −1. Precondition: neither is a singular vertex of the mesh.
  [[nodiscard]] Index halfedgeBetween(Index a, Index b) const;

 private:
  struct PieceEdge {
    Index low;  // the edge's smaller vertex
    Index high;
    Index halfedge;
  };

  void pairPieces();
  [[nodiscard]] Index twinOfPiece(Index h) const;
  [[nodiscard]] Index pieceAlong(Index meshHalfedge) const;
  [[nodiscard]] Index pieceHalfedge(Index a, Index b, Index parentFace) const;
  [[nodiscard]] Index parent(Index h) const {
    return cut_.parents[static_cast<std::size_t>(h / 3 - mesh_.faceCount())];
  }

  const TriangleMesh& mesh_;
  const Cut& cut_;
  IndexSet divided_;
  std::vector<PieceEdge> pieceEdges_;  // of every halfedge of a piece; by low, high, halfedge
  std::vector<Index> pieceTwins_;
};

}  // namespace graftsman
