#include "core/fusion/overlay_cells.h"

#include <array>
#include <cassert>

#include "core/fusion/cell_triangulation.h"

namespace graftsman::overlay_detail {
namespace {

constexpr Index kProgressStride = 512;  // base faces between two looks at the clock

/// A piece of an edge of either layer, directed: it starts at a crossing, or at the halfedge's start.
struct Piece {
  Index halfedge;
  Index crossing;  // −1: starts at the halfedge's start
  bool ofPart;
  friend bool operator==(const Piece&, const Piece&) = default;
};

/// Walks round the cells, interior on the left.
class CellWalker {
 public:
  CellWalker(const Layers& layers, const Trace& trace, const VertexNumbers& numbers, CombinedTile& combined)
      : layers_(layers),
        part_(layers.part),
        base_(layers.base),
        trace_(trace),
        numbers_(numbers),
        combined_(combined),
        seenHalfedges_(static_cast<std::size_t>(base_.halfedgeCount()), false),
        seenCrossings_(2 * trace.crossings.size(), false),
        seenPartFaces_(static_cast<std::size_t>(part_.faceCount()), false) {
    // A disk of V vertices, S of them on its border, has 2 V − S − 2 triangles.
    faceCount_ = 2 * static_cast<std::size_t>(numbers.count) - static_cast<std::size_t>(base_.seamSize()) - 2;
    combined_.faces.reserve(faceCount_);
    combined_.partFaces.reserve(faceCount_);
    combined_.baseFaces.reserve(faceCount_);
  }

  /// The cells of one base face that have some of its edges. False: the layers do not fit.
  bool walkBaseFace(Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      for (Piece piece{h, -1, false};;) {
        if (!seen(piece) && !walkCell(piece)) {
          return false;
        }
        piece.crossing = endOf(piece);
        if (piece.crossing < 0) {
          break;
        }
      }
    }
    return true;
  }

  /// The part's faces that lie inside one base face.
  void addWholePartFaces() {
    for (Index f = 0; f < part_.faceCount(); ++f) {
      if (seenPartFaces_[static_cast<std::size_t>(f)]) {
        continue;
      }
      Index baseFace = -1;
      corners_.clear();
      for (const Index w : part_.faces[static_cast<std::size_t>(f)]) {
        corners_.push_back(numbers_.ofPart[static_cast<std::size_t>(w)]);
        baseFace = std::max(baseFace, trace_.partInBase[static_cast<std::size_t>(w)]);
      }
      addCell(f, baseFace);
    }
  }

  [[nodiscard]] bool isComplete() const { return combined_.faces.size() == faceCount_; }

 private:
  bool seen(const Piece& piece) const {
    return piece.crossing < 0 ? seenHalfedges_[static_cast<std::size_t>(piece.halfedge)]
                              : seenCrossings_[slot(piece)];
  }

  void setSeen(const Piece& piece) {
    if (piece.crossing < 0) {
      seenHalfedges_[static_cast<std::size_t>(piece.halfedge)] = true;
    } else {
      seenCrossings_[slot(piece)] = true;
    }
  }

  [[nodiscard]] std::size_t slot(const Piece& piece) const {
    const auto c = static_cast<std::size_t>(piece.crossing);
    return 2 * c + (trace_.crossings[c].base == piece.halfedge ? 1 : 0);
  }

  // The crossing at which the piece ends, or −1 if it ends at the halfedge's end.
  [[nodiscard]] Index endOf(const Piece& piece) const {
    if (piece.crossing < 0) {
      return (piece.ofPart ? trace_.firstOnPart
                           : trace_.firstOnBase)[static_cast<std::size_t>(piece.halfedge)];
    }
    const auto count = static_cast<Index>(trace_.crossings.size());
    const Crossing& crossing = trace_.crossings[static_cast<std::size_t>(piece.crossing)];
    if (!piece.ofPart) {
      const Index next = piece.crossing + (crossing.base == piece.halfedge ? 1 : -1);
      return next >= 0 && next < count &&
                     trace_.crossings[static_cast<std::size_t>(next)].base == crossing.base
                 ? next
                 : -1;
    }
    const Index twin = part_.twin(piece.halfedge);
    const Index place =
        trace_.partSlot[static_cast<std::size_t>(piece.crossing)] + (piece.halfedge < twin ? 1 : -1);
    if (place < 0 || place >= count) {
      return -1;
    }
    const Index next = trace_.partOrder[static_cast<std::size_t>(place)];
    const Index h = trace_.crossings[static_cast<std::size_t>(next)].part;
    return h == piece.halfedge || h == twin ? next : -1;
  }

  // The next piece round the cell on the left of `piece`.
  [[nodiscard]] Piece following(const Piece& piece) const {
    const Index end = endOf(piece);
    if (end >= 0) {
      // Turn left. The base's halfedge crosses the part's from left to right.
      const Crossing& crossing = trace_.crossings[static_cast<std::size_t>(end)];
      if (piece.ofPart) {
        return {crossing.part == piece.halfedge ? base_.twin(crossing.base) : crossing.base, end, false};
      }
      return {crossing.base == piece.halfedge ? crossing.part : part_.twin(crossing.part), end, true};
    }
    const Layer& layer = piece.ofPart ? part_ : base_;
    const Index vertex = layer.to(piece.halfedge);
    if (vertex >= layer.seamSize()) {
      return {Layer::next(piece.halfedge), -1, piece.ofPart};
    }
    return followingAtSeam(piece, vertex);
  }

  // The spoke clockwise of the one on which the walk comes; clockwise of the first is the boundary.
  [[nodiscard]] Piece followingAtSeam(const Piece& piece, Index vertex) const {
    const SeamFans& fans = trace_.fans;
    const Index twin = (piece.ofPart ? part_ : base_).twin(piece.halfedge);
    const Index spoke =
        twin < 0 ? fans.start[static_cast<std::size_t>(vertex) + 1]
                 : (piece.ofPart ? fans.partSpoke : fans.baseSpoke)[static_cast<std::size_t>(twin)];
    if (spoke == fans.start[static_cast<std::size_t>(vertex)]) {
      return {base_.boundaryHalfedges[static_cast<std::size_t>(vertex)], -1, false};
    }
    const SeamFans::Spoke& previous = fans.spokes[static_cast<std::size_t>(spoke) - 1];
    return {previous.halfedge, -1, previous.ofPart};
  }

  [[nodiscard]] Index startVertex(const Piece& piece) const {
    if (piece.crossing >= 0) {
      return numbers_.ofCrossings[static_cast<std::size_t>(piece.crossing)];
    }
    return piece.ofPart ? numbers_.ofPart[static_cast<std::size_t>(part_.from(piece.halfedge))]
                        : base_.from(piece.halfedge);
  }

  bool walkCell(const Piece& start) {
    corners_.clear();
    Index partFace = -1;
    Piece piece = start;
    do {
      corners_.push_back(startVertex(piece));
      if (corners_.size() > kMostCorners) {
        return false;
      }
      if (piece.ofPart) {
        partFace = piece.halfedge / 3;
      } else {
        setSeen(piece);
        if (base_.twin(piece.halfedge) < 0) {
          const Index vertex = base_.from(piece.halfedge);
          partFace = part_.boundaryHalfedges[static_cast<std::size_t>(vertex)] / 3;
        }
      }
      piece = following(piece);
    } while (piece != start);
    const Index baseFace = start.halfedge / 3;
    if (partFace < 0) {
      for (const Index v : base_.faces[static_cast<std::size_t>(baseFace)]) {
        partFace = std::max(partFace, trace_.baseInPart[static_cast<std::size_t>(v)]);
      }
    }
    seenPartFaces_[static_cast<std::size_t>(partFace)] = true;
    addCell(partFace, baseFace);
    return true;
  }

  // Adds the cell whose corners are in corners_, neighbours of which may be one vertex.
  void addCell(Index partFace, Index baseFace) {
    std::array<Index, kMostCorners> distinct = {};
    std::size_t count = 0;
    for (const Index corner : corners_) {
      if (count == 0 || distinct[count - 1] != corner) {
        distinct[count++] = corner;
      }
    }
    while (count > 1 && distinct[count - 1] == distinct[0]) {
      --count;
    }
    if (count < 3) {
      return;
    }
    triangulateCell(std::span(distinct).first(count), combined_.part, combined_.base, combined_.faces);
    combined_.partFaces.resize(combined_.faces.size(), part_.origins[static_cast<std::size_t>(partFace)]);
    combined_.baseFaces.resize(combined_.faces.size(), base_.origins[static_cast<std::size_t>(baseFace)]);
  }

  const Layers& layers_;
  const Layer& part_;
  const Layer& base_;
  const Trace& trace_;
  const VertexNumbers& numbers_;
  CombinedTile& combined_;
  std::vector<bool> seenHalfedges_;  // of the base: pieces that start at their start
  std::vector<bool> seenCrossings_;  // two a crossing: pieces of the base that start there
  std::vector<bool> seenPartFaces_;
  std::vector<Index> corners_;
  std::size_t faceCount_ = 0;
};

}  // namespace

Result<void> fillCells(const Layers& layers, const Trace& trace, const VertexNumbers& numbers,
                       CombinedTile& combined, const Progress& progress) {
  CellWalker walker(layers, trace, numbers, combined);
  bool fits = true;
  for (Index f = 0; f < layers.base.faceCount() && fits; ++f) {
    if (f % kProgressStride == 0 &&
        !progress.keepGoing(static_cast<double>(f) / static_cast<double>(layers.base.faceCount()))) {
      return fail(ErrorCode::Cancelled, "Cancelled.");
    }
    fits = walker.walkBaseFace(f);
  }
  if (fits) {
    walker.addWholePartFaces();
  }
  if (!fits || !walker.isComplete()) {
    return fail(tooFine());
  }
  return {};
}

}  // namespace graftsman::overlay_detail
