#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/fusion/path_points.h"
#include "core/fusion/zeroed_array.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// What a path must not meet: the mesh's singular vertices, other CVs, and other paths. Obstacle paths divide
/// the edges that they cross into intervals and the faces into convex regions; a free point of an edge
/// belongs to one interval, and a straight line between two intervals of one region meets no obstacle.
/// Everything is decided by the order of points round a face, never by positions.
class PathObstacles {
 public:
  /// Only singular vertices stand in the way; with `keepOffBorder`, the vertices of the mesh's border, too.
  explicit PathObstacles(const TriangleMesh& mesh, bool keepOffBorder = false);

  void addCv(Index vertex, int cv);
  void addPath(std::span<const EdgePoint> points, int path);

  /// The ends of the path that is being sought: allowed although they are CVs and other paths may end there.
  void setEnds(Index from, Index to) { from_ = from, to_ = to; }

  [[nodiscard]] bool blocked(Index v) const {
    if (v == from_ || v == to_) {
      return false;
    }
    return mesh_->singular(v) || (vertexOwners_.allocated() && vertexOwners_[v] != 0) ||
           (keepOffBorder_ && mesh_->onBorder(v));
  }

  /// A stretch of an edge between neighbouring obstacles, in t of the canonical halfedge. An end that is not
  /// blocked is a vertex (0 or 1) that a path may pass.
  struct Interval {
    double lo = 0;
    double hi = 1;
    bool loBlocked = false;
    bool hiBlocked = false;

    /// The t at the fraction `f` of the interval; nothing if doubles are too coarse for a point between its
    /// ends.
    [[nodiscard]] std::optional<double> inside(double f) const {
      const double t = lo + f * (hi - lo);
      return lo < t && t < hi ? std::optional(t) : std::nullopt;
    }
  };

  /// The interval of h's edge that reaches its end v; the one in which t lies; all of them (none if an
  /// obstacle path runs along the edge). Precondition of the first two: it exists and is not an obstacle's.
  [[nodiscard]] Interval intervalNear(Index h, Index v) const;
  [[nodiscard]] Interval intervalAround(Index h, double t) const;
  [[nodiscard]] std::vector<Interval> intervals(Index h) const;

  /// True if an obstacle crosses, runs along, or ends at the edge of h.
  [[nodiscard]] bool touches(Index h) const;

  /// True if a and b lie in one region of a face, or on one edge with no obstacle between.
  [[nodiscard]] bool permits(const EdgePoint& a, const EdgePoint& b) const;
  /// The same for two points known to lie in this face, not both on one edge.
  [[nodiscard]] bool permitsIn(Index face, const EdgePoint& a, const EdgePoint& b) const;
  /// The same for the two ends of h's edge.
  [[nodiscard]] bool permitsAlong(Index h) const;

  /// The first obstacle that the path meets but in its ends: a path's number or a CV's, the other −1.
  struct Conflict {
    int path = -1;
    int cv = -1;
  };
  [[nodiscard]] std::optional<Conflict> conflict(std::span<const EdgePoint> points) const;

 private:
  struct Crossing {
    double t;
    int path;
  };
  struct EdgeMarks {
    std::vector<Crossing> crossings;  // ascending t
    int along = -1;                   // the path that runs along the whole edge
  };
  struct Chord {
    PerimeterPosition a;
    PerimeterPosition b;
    int path;
  };

  void allocate();
  EdgeMarks& marksToWrite(Index edge);
  [[nodiscard]] const EdgeMarks* marks(Index h) const;
  [[nodiscard]] const std::vector<Chord>* chords(Index face) const;
  [[nodiscard]] Interval between(const EdgeMarks* marks, Index edge, std::size_t k) const;
  [[nodiscard]] std::optional<Conflict> conflictAt(const EdgePoint& p) const;
  [[nodiscard]] std::optional<Conflict> conflictBetween(const EdgePoint& a, const EdgePoint& b) const;

  const TriangleMesh* mesh_;
  bool keepOffBorder_;
  Index from_ = -1;
  Index to_ = -1;
  ZeroedArray<int> vertexOwners_;  // 0: none; p + 1: path p; −c − 1: CV c
  ZeroedArray<Index> edgeSlots_;   // of each canonical halfedge, 1 + its entry in edges_; 0: none
  ZeroedArray<Index> faceSlots_;   // likewise in chords_
  std::vector<EdgeMarks> edges_;
  std::vector<std::vector<Chord>> chords_;
};

}  // namespace graftsman
