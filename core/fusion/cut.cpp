#include "core/fusion/cut.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <tuple>

#include "core/mesh/polygon_triangulation.h"

namespace graftsman {
namespace {

/// A new point on its edge; sorted, the points of one edge are in order along its smaller halfedge.
struct PointOnEdge {
  Index halfedge;
  double t;
  Index point;  // index in Cut::points
  bool operator<(const PointOnEdge& other) const {
    return std::tie(halfedge, t, point) < std::tie(other.halfedge, other.t, other.point);
  }
};

/// A segment of the loop through a face, by the vertices of its ends.
struct Chord {
  Index face;
  Index from;
  Index to;
};

/// One place on a face's perimeter: a corner, or a new point on an edge.
struct Place {
  Index vertex;
  std::uint8_t sides;  // as in triangulatePolygon()
};

/// Divides one mesh; the functions are called in this order.
class Cutter {
 public:
  Cutter(const TriangleMesh& mesh, const LoopPaths& paths) : mesh_(mesh), paths_(paths) {}

  Cut run() {
    gatherLoop();
    gatherChords();
    gatherFaces();
    auto chord = chords_.begin();
    for (const Index face : crossed_) {
      const auto end = std::find_if(chord, chords_.end(), [&](const Chord& c) { return c.face != face; });
      layOutPerimeter(face);
      divide(face, {chord, end});
      chord = end;
    }
    assert(chord == chords_.end());
    return std::move(cut_);
  }

 private:
  // The paths' points one after the other, each path's last left to the next one.
  void gatherLoop() {
    for (const auto& path : paths_.paths) {
      cut_.corners.push_back(static_cast<Index>(loop_.size()));
      loop_.insert(loop_.end(), path->points.begin(), path->points.end() - 1);
    }
    for (const EdgePoint& p : loop_) {
      if (p.isVertex()) {
        cut_.boundary.push_back(p.vertex);
        continue;
      }
      const auto number = static_cast<Index>(cut_.where.size());
      cut_.boundary.push_back(mesh_.vertexCount() + number);
      cut_.where.push_back(p);
      cut_.points.push_back(position(mesh_, p));
      onEdges_.push_back({p.halfedge, p.t, number});
    }
    std::sort(onEdges_.begin(), onEdges_.end());
  }

  void gatherChords() {
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const std::size_t next = i + 1 < loop_.size() ? i + 1 : 0;
      const Index face = faceThrough(loop_[i], loop_[next]);
      if (face >= 0) {
        chords_.push_back({face, cut_.boundary[i], cut_.boundary[next]});
      }
    }
    std::stable_sort(chords_.begin(), chords_.end(),
                     [](const Chord& a, const Chord& b) { return a.face < b.face; });
  }

  // The face that a segment passes through, or −1 for one along an edge.
  [[nodiscard]] Index faceThrough(const EdgePoint& a, const EdgePoint& b) const {
    if (a.isVertex() && b.isVertex()) {
      return -1;
    }
    if (a.isVertex()) {
      return faceThrough(b, a);
    }
    if (b.isVertex() ? mesh_.from(a.halfedge) == b.vertex || mesh_.to(a.halfedge) == b.vertex
                     : a.halfedge == b.halfedge) {
      return -1;
    }
    for (const Index h : {a.halfedge, mesh_.twin(a.halfedge)}) {
      if (h < 0) {
        continue;
      }
      const Index n = TriangleMesh::next(h);
      const Index p = TriangleMesh::prev(h);
      if (b.isVertex() ? mesh_.from(p) == b.vertex : smaller(n) == b.halfedge || smaller(p) == b.halfedge) {
        return TriangleMesh::faceOf(h);
      }
    }
    assert(!"a segment of a path leaves its face");
    return -1;
  }

  [[nodiscard]] Index smaller(Index h) const {
    const Index t = mesh_.twin(h);
    return t >= 0 && t < h ? t : h;
  }

  // Every face beside an edge with a new point; each chord ends in one, so these are all.
  void gatherFaces() {
    for (const PointOnEdge& p : onEdges_) {
      for (const Index h : {p.halfedge, mesh_.twin(p.halfedge)}) {
        if (h >= 0) {
          crossed_.push_back(TriangleMesh::faceOf(h));
        }
      }
    }
    std::sort(crossed_.begin(), crossed_.end());
    crossed_.erase(std::unique(crossed_.begin(), crossed_.end()), crossed_.end());
    slot_.resize(cut_.points.size());
  }

  void layOutPerimeter(Index face) {
    perimeter_.clear();
    for (int k = 0; k < 3; ++k) {
      const Index h = 3 * face + k;
      perimeter_.push_back({mesh_.from(h), static_cast<std::uint8_t>(1 << k | 1 << (k + 2) % 3)});
      const auto onSide = static_cast<std::uint8_t>(1 << k);
      const Index canonical = smaller(h);
      const auto [begin, end] = std::equal_range(
          onEdges_.begin(), onEdges_.end(), PointOnEdge{canonical, 0, 0},
          [](const PointOnEdge& a, const PointOnEdge& b) { return a.halfedge < b.halfedge; });
      const auto add = [&](const PointOnEdge& p) {
        slot_[static_cast<std::size_t>(p.point)] = static_cast<Index>(perimeter_.size());
        perimeter_.push_back({mesh_.vertexCount() + p.point, onSide});
      };
      if (canonical == h) {
        std::for_each(begin, end, add);
      } else {
        std::for_each(std::reverse_iterator(end), std::reverse_iterator(begin), add);
      }
    }
  }

  [[nodiscard]] Index placeOf(Index vertex) const {
    if (vertex >= mesh_.vertexCount()) {
      return slot_[static_cast<std::size_t>(vertex - mesh_.vertexCount())];
    }
    const auto at = std::find_if(perimeter_.begin(), perimeter_.end(),
                                 [&](const Place& place) { return place.vertex == vertex; });
    return static_cast<Index>(at - perimeter_.begin());
  }

  // Chords do not cross, so they nest like brackets on the perimeter: walking round it, a closing chord
  // bounds the places since its opening, less what inner chords have cut off.
  void divide(Index face, std::span<const Chord> chords) {
    brackets_.clear();
    for (const Chord& chord : chords) {
      const auto [open, close] = std::minmax({placeOf(chord.from), placeOf(chord.to)});
      brackets_.emplace_back(open, -close);
    }
    std::sort(brackets_.begin(), brackets_.end());  // at the same opening the outermost first
    opened_.clear();
    pending_.clear();
    auto bracket = brackets_.begin();
    for (Index place = 0; place < static_cast<Index>(perimeter_.size()); ++place) {
      while (!opened_.empty() && opened_.back().close == place) {
        const std::size_t start = opened_.back().start;
        pending_.push_back(place);
        emit(face, std::span(pending_).subspan(start));
        pending_.resize(start + 1);
        opened_.pop_back();
      }
      for (; bracket != brackets_.end() && bracket->first == place; ++bracket) {
        assert(opened_.empty() || -bracket->second <= opened_.back().close);  // or chords cross
        opened_.push_back({pending_.size(), -bracket->second});
      }
      pending_.push_back(place);
    }
    assert(opened_.empty());
    emit(face, pending_);
  }

  void emit(Index face, std::span<const Index> places) {
    ids_.clear();
    corners_.clear();
    sides_.clear();
    for (const Index i : places) {
      const Place& place = perimeter_[static_cast<std::size_t>(i)];
      ids_.push_back(place.vertex);
      corners_.push_back(place.vertex < mesh_.vertexCount()
                             ? mesh_.point(place.vertex)
                             : cut_.points[static_cast<std::size_t>(place.vertex - mesh_.vertexCount())]);
      sides_.push_back(place.sides);
    }
    triangulatePolygon(ids_, corners_, sides_, cut_.faces);
    cut_.parents.resize(cut_.faces.size(), face);
  }

  struct OpenChord {
    std::size_t start;  // its first place's index in pending_
    Index close;        // its last place
  };

  const TriangleMesh& mesh_;
  const LoopPaths& paths_;
  Cut cut_;
  std::vector<EdgePoint> loop_;
  std::vector<PointOnEdge> onEdges_;  // sorted
  std::vector<Chord> chords_;         // by face
  std::vector<Index> crossed_;        // ascending
  // of the face at hand
  std::vector<Place> perimeter_;                   // counter-clockwise from corner 0
  std::vector<Index> slot_;                        // of each new point, its place
  std::vector<std::pair<Index, Index>> brackets_;  // (first place, −last place) of each chord
  std::vector<OpenChord> opened_;
  std::vector<Index> pending_;  // places of the polygons that are not closed yet
  std::vector<Index> ids_;
  std::vector<Point> corners_;
  std::vector<std::uint8_t> sides_;
};

}  // namespace

Cut cutMesh(const TriangleMesh& mesh, const LoopPaths& paths) {
  return Cutter(mesh, paths).run();
}

}  // namespace graftsman
