#include "core/fusion/divided_mesh.h"

#include <algorithm>
#include <tuple>

namespace graftsman {

DividedMesh::DividedMesh(const TriangleMesh& mesh, const Cut& cut)
    : mesh_(mesh), cut_(cut), divided_(mesh.faceCount()) {
  for (const Index f : cut.parents) {
    divided_.insert(f);
  }
  pairPieces();
}

void DividedMesh::pairPieces() {
  const Index first = mesh_.halfedgeCount();
  const Index end = first + 3 * static_cast<Index>(cut_.faces.size());
  pieceEdges_.reserve(static_cast<std::size_t>(end - first));
  for (Index h = first; h < end; ++h) {
    const auto [low, high] = std::minmax({from(h), to(h)});
    pieceEdges_.push_back({low, high, h});
  }
  std::sort(pieceEdges_.begin(), pieceEdges_.end(), [](const PieceEdge& a, const PieceEdge& b) {
    return std::tie(a.low, a.high, a.halfedge) < std::tie(b.low, b.high, b.halfedge);
  });
  pieceTwins_.reserve(pieceEdges_.size());
  for (Index h = first; h < end; ++h) {
    pieceTwins_.push_back(twinOfPiece(h));
  }
}

// An edge between two vertices of the mesh is one of the mesh's, as no piece has three vertices on one edge
// of its parent; so the mesh knows its twin, also where three faces meet.
Index DividedMesh::twinOfPiece(Index h) const {
  const Index a = from(h);
  const Index b = to(h);
  if (a >= mesh_.vertexCount() || b >= mesh_.vertexCount()) {
    return pieceHalfedge(b, a, -1);
  }
  Index inParent = 3 * parent(h);
  while (mesh_.from(inParent) != a) {
    ++inParent;
  }
  const Index t = mesh_.twin(inParent);
  return t < 0 || !divided(t / 3) ? t : pieceAlong(t);
}

Index DividedMesh::pieceAlong(Index meshHalfedge) const {
  return pieceHalfedge(mesh_.from(meshHalfedge), mesh_.to(meshHalfedge), meshHalfedge / 3);
}

// Among the pieces of `parentFace`; −1: of all faces.
Index DividedMesh::pieceHalfedge(Index a, Index b, Index parentFace) const {
  const auto [low, high] = std::minmax({a, b});
  auto at = std::lower_bound(pieceEdges_.begin(), pieceEdges_.end(), std::pair(low, high),
                             [](const PieceEdge& e, const auto& key) {
                               return std::tie(e.low, e.high) < std::tie(key.first, key.second);
                             });
  for (; at != pieceEdges_.end() && at->low == low && at->high == high; ++at) {
    if (from(at->halfedge) == a && (parentFace < 0 || parent(at->halfedge) == parentFace)) {
      return at->halfedge;
    }
  }
  return -1;
}

Index DividedMesh::halfedgeBetween(Index a, Index b) const {
  if (a >= mesh_.vertexCount() || b >= mesh_.vertexCount()) {
    return pieceHalfedge(a, b, -1);
  }
  const Index h = mesh_.halfedgeBetween(a, b);
  return h < 0 || !divided(h / 3) ? h : pieceAlong(h);
}

}  // namespace graftsman
