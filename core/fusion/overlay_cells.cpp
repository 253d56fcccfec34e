#include "core/fusion/overlay_cells.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <span>

#include "core/base/large_array.h"
#include "core/base/parallel.h"
#include "core/fusion/cell_triangulation.h"

namespace graftsman::overlay_detail {
namespace {

constexpr std::size_t kCellsPerLook = 512;  // base faces between two looks at the clock
constexpr std::size_t kCellGrain = 8192;    // base faces that a thread takes at a time

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

/// What the walks have passed. Bytes, because threads that have different base faces write at once.
struct Seen {
  std::vector<std::uint8_t> halfedges;  // of the base: pieces that start at their start
  std::vector<std::uint8_t> crossings;  // two a crossing: pieces of the base that start there
  std::vector<std::uint8_t> partFaces;

  Seen(const Layers& layers, const Trace& trace)
      : halfedges(static_cast<std::size_t>(layers.base.halfedgeCount()), 0),
        crossings(2 * trace.crossings.size(), 0),
        partFaces(static_cast<std::size_t>(layers.part.faceCount()), 0) {}
};

/// Faces of the combined tile, and which faces of the embeddings each lies in.
struct CellFaces {
  std::vector<Face> faces;
  std::vector<Index> partFaces;
  std::vector<Index> baseFaces;

  void reserve(std::size_t count) {
    reserveLarge(faces, count);
    reserveLarge(partFaces, count);
    reserveLarge(baseFaces, count);
  }
  void append(const CellFaces& other) {
    faces.insert(faces.end(), other.faces.begin(), other.faces.end());
    partFaces.insert(partFaces.end(), other.partFaces.begin(), other.partFaces.end());
    baseFaces.insert(baseFaces.end(), other.baseFaces.begin(), other.baseFaces.end());
  }
};

/// Walks round the cells, interior on the left.
class CellWalker {
 public:
  CellWalker(const Layers& layers, const Trace& trace, const VertexNumbers& numbers,
             const CombinedTile& combined, Seen& seen, CellFaces& out)
      : part_(layers.part),
        base_(layers.base),
        trace_(trace),
        numbers_(numbers),
        combined_(combined),
        seen_(seen),
        out_(out) {}

  /// The cells of one base face that have some of its edges. False: the layers do not fit.
  bool walkBaseFace(Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      Piece piece = Piece::atVertex(h, false);
      for (;;) {
        if (seenOf(piece) == 0 && !walkCell(piece, face)) {
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
      if (seen_.partFaces[static_cast<std::size_t>(f)] != 0) {
        continue;
      }
      Index baseFace = -1;
      cornerCount_ = 0;
      for (const Index w : part_.faces[static_cast<std::size_t>(f)]) {
        corners_[cornerCount_++] = numbers_.ofPart[static_cast<std::size_t>(w)];
        baseFace = std::max(baseFace, trace_.partInBase[static_cast<std::size_t>(w)]);
      }
      addCell(f, baseFace);
    }
  }

 private:
  [[nodiscard]] const Crossing& at(Index c) const { return trace_.crossings[static_cast<std::size_t>(c)]; }

  // Whether a piece of the base was passed. Each belongs to one base face, so that no two threads meet here.
  [[nodiscard]] std::uint8_t& seenOf(const Piece& piece) {
    if (!piece.startsAtCrossing()) {
      return seen_.halfedges[static_cast<std::size_t>(piece.halfedge())];
    }
    return seen_.crossings[2 * static_cast<std::size_t>(piece.crossing()) + (piece.forward ? 1 : 0)];
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
    cornerCount_ = 0;
    Index partFace = -1;
    Piece piece = start;
    do {
      if (cornerCount_ == kMostCorners) {
        return false;
      }
      corners_[cornerCount_++] = startVertex(piece);
      if (!piece.ofPart) {
        seenOf(piece) = 1;
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
    std::atomic_ref(seen_.partFaces[static_cast<std::size_t>(partFace)]).store(1, std::memory_order_relaxed);
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

  // Adds the cell whose corners are the first of corners_, neighbours of which may be one vertex.
  void addCell(Index partFace, Index baseFace) {
    std::size_t count = 0;
    for (const Index corner : std::span(corners_).first(cornerCount_)) {
      if (count == 0 || corners_[count - 1] != corner) {
        corners_[count++] = corner;
      }
    }
    while (count > 1 && corners_[count - 1] == corners_[0]) {
      --count;
    }
    if (count < 3) {
      return;
    }
    triangulateCell(std::span(corners_).first(count), combined_.part, combined_.base, out_.faces);
    const Index partOrigin = part_.origins[static_cast<std::size_t>(partFace)];
    const Index baseOrigin = base_.origins[static_cast<std::size_t>(baseFace)];
    while (out_.partFaces.size() < out_.faces.size()) {
      out_.partFaces.push_back(partOrigin);
      out_.baseFaces.push_back(baseOrigin);
    }
  }

  const Layer& part_;
  const Layer& base_;
  const Trace& trace_;
  const VertexNumbers& numbers_;
  const CombinedTile& combined_;
  Seen& seen_;
  CellFaces& out_;
  std::array<Index, kMostCorners> corners_ = {};
  std::size_t cornerCount_ = 0;
};

}  // namespace

Result<void> fillCells(const Layers& layers, const Trace& trace, const VertexNumbers& numbers,
                       CombinedTile& combined, const Progress& progress) {
  // A disk of V vertices, S of them on its border, has 2 V − S − 2 triangles.
  const auto faceCount =
      2 * static_cast<std::size_t>(numbers.count) - static_cast<std::size_t>(layers.base.seamSize()) - 2;
  const auto baseFaces = static_cast<std::size_t>(layers.base.faceCount());
  // The order of the faces is the same whatever the ranges.
  const std::size_t grain = threadCount() > 1 ? kCellGrain : baseFaces;
  std::vector<CellFaces> ranges((baseFaces + grain - 1) / grain);
  Seen seen(layers, trace);
  std::atomic<bool> fits = true;
  std::atomic<std::size_t> done = 0;
  ranges[0].reserve(ranges.size() == 1 ? faceCount : 0);
  parallelRanges(baseFaces, grain, [&](std::size_t begin, std::size_t end) {
    CellWalker walker(layers, trace, numbers, combined, seen, ranges[begin / grain]);
    for (std::size_t f = begin; f < end && fits; ++f) {
      if (f % kCellsPerLook == 0 &&
          !progress.keepGoing(static_cast<double>(done += kCellsPerLook) / static_cast<double>(baseFaces))) {
        return;
      }
      if (!walker.walkBaseFace(static_cast<Index>(f))) {
        fits = false;
      }
    }
  });
  if (progress.cancelled()) {
    return fail(ErrorCode::Cancelled, "Cancelled.");
  }
  CellFaces all = std::move(ranges[0]);
  if (ranges.size() > 1) {
    all.reserve(faceCount);
    for (std::size_t i = 1; i < ranges.size(); ++i) {
      all.append(ranges[i]);
      ranges[i] = {};
    }
  }
  if (fits) {
    CellWalker(layers, trace, numbers, combined, seen, all).addWholePartFaces();
  }
  if (!fits || all.faces.size() != faceCount) {
    return fail(tooFine());
  }
  combined.faces = std::move(all.faces);
  combined.partFaces = std::move(all.partFaces);
  combined.baseFaces = std::move(all.baseFaces);
  return {};
}

}  // namespace graftsman::overlay_detail
