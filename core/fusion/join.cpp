#include "core/fusion/join.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <tuple>

#include "core/mesh/polygon_triangulation.h"

namespace graftsman {
namespace {

/// A side of a remainder triangle that runs along the seam, against its direction.
struct SideOnSeam {
  Index triangle;      // a face of the base, or the base's faces + a piece of the cut
  Index side;          // from corner `side` to the next
  Index boundaryEdge;  // of the tile
  bool operator<(const SideOnSeam& other) const {
    return std::tie(triangle, side) < std::tie(other.triangle, other.side);
  }
};

/// A directed side of a remaining piece of the cut.
struct PieceSide {
  Index from;
  Index to;
  Index piece;
  Index side;
  bool operator<(const PieceSide& other) const { return std::tie(from, to) < std::tie(other.from, other.to); }
};

/// Joins one tile; the functions are called in this order. Vertices of the cut: those of the base, then the
/// new points.
class Joiner {
 public:
  Joiner(const TriangleMesh& base, const Cut& cut, const Tile& tile, const CombinedTile& combined)
      : base_(base), cut_(cut), tile_(tile), combined_(combined), leaves_(base.faces().size(), false) {}

  Join run() {
    numberVertices();
    markFaces();
    findSidesOnSeam();
    addWholeFaces();
    addPieces();
    addTile();
    return std::move(join_);
  }

 private:
  void numberVertices() {
    constexpr Index kInside = -1;
    ofCut_.assign(static_cast<std::size_t>(base_.vertexCount()) + cut_.points.size(), 0);
    for (std::size_t v = static_cast<std::size_t>(tile_.boundarySize); v < tile_.vertices.size(); ++v) {
      ofCut_[static_cast<std::size_t>(tile_.vertices[v])] = kInside;
    }
    const std::size_t kept =
        base_.points().size() + static_cast<std::size_t>(tile_.boundarySize) - tile_.vertices.size();
    join_.baseVertices.reserve(kept);
    join_.points.reserve(kept + combined_.base.size());
    for (Index v = 0; v < base_.vertexCount(); ++v) {
      Index& number = ofCut_[static_cast<std::size_t>(v)];
      if (number != kInside) {
        number = static_cast<Index>(join_.points.size());
        join_.baseVertices.push_back(v);
        join_.points.push_back(base_.point(v));
      }
    }
    join_.tileVertices.reserve(combined_.base.size());
    firstSeam_.assign(static_cast<std::size_t>(tile_.boundarySize) + 1, combined_.seamSize);
    for (std::size_t k = 0; k < combined_.base.size(); ++k) {
      join_.tileVertices.push_back(static_cast<Index>(join_.points.size()));
      if (k < static_cast<std::size_t>(combined_.seamSize) && combined_.seamOnBase[k].t == 0) {
        const auto edge = static_cast<std::size_t>(combined_.seamOnBase[k].edge);
        const Index v = tile_.vertices[edge];
        firstSeam_[edge] = static_cast<Index>(k);
        if (v < base_.vertexCount()) {
          join_.tileVertices.back() = ofCut_[static_cast<std::size_t>(v)];
          continue;
        }
        ofCut_[static_cast<std::size_t>(v)] = join_.tileVertices.back();
      }
      join_.points.push_back(combined_.base[k]);
    }
  }

  void markFaces() {
    for (const Index f : tile_.wholeFaces) {
      leaves_[static_cast<std::size_t>(f)] = true;
    }
    for (const Index f : cut_.parents) {
      leaves_[static_cast<std::size_t>(f)] = true;
    }
    auto inTile = tile_.pieces.begin();
    for (Index p = 0; p < static_cast<Index>(cut_.faces.size()); ++p) {
      if (inTile != tile_.pieces.end() && *inTile == p) {
        ++inTile;
      } else {
        remaining_.push_back(p);
      }
    }
  }

  // Only where the part brought vertices: elsewhere nothing is divided.
  void findSidesOnSeam() {
    std::vector<PieceSide> sides;
    for (const Index p : remaining_) {
      const Face& face = cut_.faces[static_cast<std::size_t>(p)];
      for (Index k = 0; k < 3; ++k) {
        sides.push_back(
            {face[static_cast<std::size_t>(k)], face[static_cast<std::size_t>((k + 1) % 3)], p, k});
      }
    }
    std::sort(sides.begin(), sides.end());
    for (Index i = 0; i < tile_.boundarySize; ++i) {
      if (broughtBegin(i) == broughtEnd(i)) {
        continue;
      }
      const Index from = tile_.vertices[static_cast<std::size_t>((i + 1) % tile_.boundarySize)];
      const Index to = tile_.vertices[static_cast<std::size_t>(i)];
      const PieceSide wanted{from, to, 0, 0};
      const auto found = std::lower_bound(sides.begin(), sides.end(), wanted);
      if (found != sides.end() && !(wanted < *found)) {
        onSeam_.push_back({base_.faceCount() + found->piece, found->side, i});
      } else if (from < base_.vertexCount() && to < base_.vertexCount()) {
        const Index h = base_.halfedgeBetween(from, to);
        if (h >= 0 && !leaves_[static_cast<std::size_t>(TriangleMesh::faceOf(h))]) {
          onSeam_.push_back({TriangleMesh::faceOf(h), h % 3, i});
        }
      }
    }
    std::sort(onSeam_.begin(), onSeam_.end());
  }

  // The seam vertices that the part brought to boundary edge i.
  [[nodiscard]] Index broughtBegin(Index i) const { return firstSeam_[static_cast<std::size_t>(i)] + 1; }
  [[nodiscard]] Index broughtEnd(Index i) const { return firstSeam_[static_cast<std::size_t>(i) + 1]; }

  void addWholeFaces() {
    for (const SideOnSeam& side : onSeam_) {
      if (side.triangle < base_.faceCount()) {
        leaves_[static_cast<std::size_t>(side.triangle)] = true;
      }
    }
    const auto leaving = static_cast<std::size_t>(std::count(leaves_.begin(), leaves_.end(), true));
    const std::size_t whole = base_.faces().size() - leaving;
    join_.faces.reserve(whole + 4 * cut_.faces.size() + combined_.faces.size() + combined_.uv.size());
    join_.baseFaces.reserve(whole + 4 * cut_.faces.size());
    for (Index f = 0; f < base_.faceCount(); ++f) {
      if (!leaves_[static_cast<std::size_t>(f)]) {
        join_.faces.push_back(renumbered(base_.face(f)));
        join_.baseFaces.push_back(f);
      }
    }
    join_.wholeFaces = static_cast<Index>(join_.faces.size());
  }

  void addPieces() {
    auto side = onSeam_.begin();
    while (side != onSeam_.end() && side->triangle < base_.faceCount()) {
      side = divide(side, base_.face(side->triangle), side->triangle);
    }
    for (const Index p : remaining_) {
      const Face& face = cut_.faces[static_cast<std::size_t>(p)];
      const Index parent = cut_.parents[static_cast<std::size_t>(p)];
      if (side != onSeam_.end() && side->triangle == base_.faceCount() + p) {
        side = divide(side, face, parent);
      } else {
        join_.faces.push_back(renumbered(face));
        join_.baseFaces.push_back(parent);
      }
    }
    assert(side == onSeam_.end());
    join_.restFaces = static_cast<Index>(join_.faces.size());
  }

  // Divides the triangle of `first` for the vertices on all its sides on the seam; returns what follows them.
  std::vector<SideOnSeam>::iterator divide(std::vector<SideOnSeam>::iterator first, const Face& corners,
                                           Index parent) {
    auto side = first;
    ids_.clear();
    masks_.clear();
    for (Index k = 0; k < 3; ++k) {
      ids_.push_back(ofCut_[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])]);
      masks_.push_back(static_cast<std::uint8_t>(1 << k | 1 << (k + 2) % 3));
      if (side != onSeam_.end() && side->triangle == first->triangle && side->side == k) {
        for (Index s = broughtEnd(side->boundaryEdge); s-- > broughtBegin(side->boundaryEdge);) {
          ids_.push_back(join_.tileVertices[static_cast<std::size_t>(s)]);
          masks_.push_back(static_cast<std::uint8_t>(1 << k));
        }
        ++side;
      }
    }
    points_.clear();
    for (const Index v : ids_) {
      points_.push_back(join_.points[static_cast<std::size_t>(v)]);
    }
    triangulatePolygon(ids_, points_, masks_, join_.faces);
    join_.baseFaces.resize(join_.faces.size(), parent);
    return side;
  }

  void addTile() {
    for (const auto& [a, b, c] : combined_.faces) {
      join_.faces.push_back({join_.tileVertices[static_cast<std::size_t>(a)],
                             join_.tileVertices[static_cast<std::size_t>(b)],
                             join_.tileVertices[static_cast<std::size_t>(c)]});
    }
  }

  [[nodiscard]] Face renumbered(const Face& face) const {
    return {ofCut_[static_cast<std::size_t>(face[0])], ofCut_[static_cast<std::size_t>(face[1])],
            ofCut_[static_cast<std::size_t>(face[2])]};
  }

  const TriangleMesh& base_;
  const Cut& cut_;
  const Tile& tile_;
  const CombinedTile& combined_;
  Join join_;
  std::vector<Index> ofCut_;  // of each vertex of the cut outside the tile, the result's
  std::vector<Index>
      firstSeam_;             // of each boundary vertex of the tile, its seam vertex; then the seam's size
  std::vector<bool> leaves_;  // of each base face: in the tile, or divided
  std::vector<Index> remaining_;  // the cut's pieces outside the tile
  std::vector<SideOnSeam> onSeam_;
  std::vector<Index> ids_;  // the polygon that divide() has in hand
  std::vector<std::uint8_t> masks_;
  std::vector<Point> points_;
};

}  // namespace

Join join(const TriangleMesh& base, const Cut& cut, const Tile& tile, const CombinedTile& combined) {
  return Joiner(base, cut, tile, combined).run();
}

}  // namespace graftsman
