#include "core/fusion/overlay_cells.h"

#include <array>
#include <cassert>

#include "core/fusion/cell_triangulation.h"

namespace graftsman::overlay_detail {
namespace {

constexpr Index kProgressStride = 512;  // base faces between two looks at the clock

/// A piece of an edge of either layer, directed.
struct Piece {
  Index start;  // the halfedge at whose start it starts, or −1 − the crossing at which it starts
  bool ofPart;
  bool forward;  // if it starts at a crossing: along the crossing's halfedge of this layer, or against it
  friend bool operator==(const Piece&, const Piece&) = default;

  static Piece atVertex(Index halfedge, bool ofPart) { return {halfedge, ofPart, true}; }
  static Piece atCrossing(Index c, bool ofPart, bool forward) { return {-1 - c, ofPart, forward}; }
  [[nodiscard]] bool startsAtCrossing() const { return start < 0; }
  [[nodiscard]] Index crossing() const { return -1 - start; }
  [[nodiscard]] Index halfedge() const { return start; }
};

/// Walks round the cells, interior on the left.
class CellWalker {
 public:
  CellWalker(const Layers& layers, const Trace& trace, const VertexNumbers& numbers, CombinedTile& combined)
      : part_(layers.part),
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
      Piece piece = Piece::atVertex(h, false);
      for (;;) {
        if (!seen(piece) && !walkCell(piece, face)) {
          return false;
        }
        const Index end = endOf(piece);
        if (end < 0) {
          break;
        }
        piece = Piece::atCrossing(end, false, continuesForward(piece, end));
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
  [[nodiscard]] const Crossing& at(Index c) const { return trace_.crossings[static_cast<std::size_t>(c)]; }

  [[nodiscard]] static std::size_t slot(const Piece& piece) {
    return 2 * static_cast<std::size_t>(piece.crossing()) + (piece.forward ? 1 : 0);
  }

  [[nodiscard]] bool seen(const Piece& piece) const {
    return piece.startsAtCrossing() ? seenCrossings_[slot(piece)]
                                    : seenHalfedges_[static_cast<std::size_t>(piece.halfedge())];
  }

  void setSeen(const Piece& piece) {
    if (piece.startsAtCrossing()) {
      seenCrossings_[slot(piece)] = true;
    } else {
      seenHalfedges_[static_cast<std::size_t>(piece.halfedge())] = true;
    }
  }

  // The crossing at which the piece ends, or −1 if it ends at a vertex.
  [[nodiscard]] Index endOf(const Piece& piece) const {
    if (!piece.startsAtCrossing()) {
      const auto h = static_cast<std::size_t>(piece.halfedge());
      return piece.ofPart ? trace_.firstOnPart[h] : trace_.firstOnBase[h];
    }
    const Index c = piece.crossing();
    if (piece.ofPart) {
      return piece.forward ? at(c).partNext : at(c).partPrev;
    }
    const Index next = piece.forward ? c + 1 : c - 1;
    return next >= 0 && next < static_cast<Index>(trace_.crossings.size()) && at(next).base == at(c).base
               ? next
               : -1;
  }

  // Whether the walk along the piece comes to its end, a crossing, along this one's halfedge.
  [[nodiscard]] bool continuesForward(const Piece& piece, Index end) const {
    if (!piece.startsAtCrossing()) {
      return (piece.ofPart ? at(end).part : at(end).base) == piece.halfedge();
    }
    return !piece.ofPart || at(end).part == at(piece.crossing()).part ? piece.forward : !piece.forward;
  }

  // The halfedge that the piece lies on.
  [[nodiscard]] Index halfedgeOf(const Piece& piece) const {
    if (!piece.startsAtCrossing()) {
      return piece.halfedge();
    }
    const Layer& layer = piece.ofPart ? part_ : base_;
    const Index h = piece.ofPart ? at(piece.crossing()).part : at(piece.crossing()).base;
    return piece.forward ? h : layer.twin(h);
  }

  // The next piece round the cell on the left of `piece`.
  [[nodiscard]] Piece following(const Piece& piece) const {
    const Index end = endOf(piece);
    if (end >= 0) {
      // Turn left. The base's halfedge crosses the part's from left to right: left of the part's is against
      // the base's, left of the base's along the part's.
      return Piece::atCrossing(end, !piece.ofPart, piece.ofPart != continuesForward(piece, end));
    }
    const Layer& layer = piece.ofPart ? part_ : base_;
    const Index h = halfedgeOf(piece);
    const Index onwards = Layer::next(h);
    const Index vertex = layer.from(onwards);
    return vertex >= layer.seamSize() ? Piece::atVertex(onwards, piece.ofPart)
                                      : followingAtSeam(h, piece.ofPart, vertex);
  }

  // The spoke clockwise of the one on which the walk comes; clockwise of the first is the boundary.
  [[nodiscard]] Piece followingAtSeam(Index h, bool ofPart, Index vertex) const {
    const SeamFans& fans = trace_.fans;
    const Index twin = (ofPart ? part_ : base_).twin(h);
    const Index spoke = twin < 0 ? fans.start[static_cast<std::size_t>(vertex) + 1]
                                 : (ofPart ? fans.partSpoke : fans.baseSpoke)[static_cast<std::size_t>(twin)];
    if (spoke == fans.start[static_cast<std::size_t>(vertex)]) {
      return Piece::atVertex(base_.boundaryHalfedges[static_cast<std::size_t>(vertex)], false);
    }
    const SeamFans::Spoke& previous = fans.spokes[static_cast<std::size_t>(spoke) - 1];
    return Piece::atVertex(previous.halfedge, previous.ofPart);
  }

  [[nodiscard]] Index startVertex(const Piece& piece) const {
    if (piece.startsAtCrossing()) {
      return at(piece.crossing()).vertex;
    }
    return piece.ofPart ? numbers_.ofPart[static_cast<std::size_t>(part_.from(piece.halfedge()))]
                        : base_.from(piece.halfedge());
  }

  // `start`: a piece of an edge of baseFace.
  bool walkCell(const Piece& start, Index baseFace) {
    corners_.clear();
    Index partFace = -1;
    Piece piece = start;
    do {
      if (corners_.size() == kMostCorners) {
        return false;
      }
      corners_.push_back(startVertex(piece));
      if (!piece.ofPart) {
        setSeen(piece);
      }
      if (partFace < 0) {
        partFace = partFaceBeside(piece);
      }
      piece = following(piece);
    } while (piece != start);
    for (std::size_t k = 0; partFace < 0 && k < 3; ++k) {  // the whole base face, within a face of the part
      const Index v = base_.faces[static_cast<std::size_t>(baseFace)][k];
      partFace = trace_.baseInPart[static_cast<std::size_t>(v)];
    }
    seenPartFaces_[static_cast<std::size_t>(partFace)] = true;
    addCell(partFace, baseFace);
    return true;
  }

  // The part's face on the left of the piece, if the piece itself tells.
  [[nodiscard]] Index partFaceBeside(const Piece& piece) const {
    if (piece.ofPart) {
      return halfedgeOf(piece) / 3;
    }
    if (!piece.startsAtCrossing() && base_.twin(piece.halfedge()) < 0) {
      return part_.boundaryHalfedges[static_cast<std::size_t>(base_.from(piece.halfedge()))] / 3;
    }
    return -1;
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
