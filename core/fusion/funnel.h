#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/fusion/face_strip.h"

namespace graftsman {

/// The shortest way through a strip of faces.
///
/// Unfolds the strip in the plane, where it may overlap itself, and keeps the funnel of shortest ways to the
/// ends of one portal after another. Linear cost; keeps its memory for the next strip. Rounding makes the way
/// longer by about 1e-16 of itself, never invalid: which portals it passes is the strip's. Source: Lee &
/// Preparata 1984; Hershberger & Snoeyink 1994.
class Funnel {
 public:
  using Point2 = Eigen::Vector2d;

  /// A place where the way bends: the left or the right end of a portal.
  struct Corner {
    Point2 at;
    Index portal = -1;  // −1 at the strip's first vertex, number of portals at its last
    bool left = false;
  };

  /// Solves a strip with at least one portal.
  void solve(const TriangleMesh& mesh, const FaceStrip& strip);

  /// The bends, with both ends of the strip.
  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }

  /// The vertex at a portal's left or right end in the plane, whether the way may reach it or not; the first
  /// or the last vertex for portal −1 or the number of portals.
  [[nodiscard]] const Point2& edgeEnd(Index portal, bool left) const;

  /// The way as points of the mesh, one for each portal at most. Close to a vertex it goes through it.
  [[nodiscard]] std::vector<EdgePoint> points(const TriangleMesh& mesh, const FaceStrip& strip) const;

 private:
  struct Gate {
    Point2 rightEnd, leftEnd;  // of the edge
    Point2 right, left;        // of the portal in it
    double rightShare = 0;     // where they lie between rightEnd and leftEnd
    double leftShare = 1;
  };

  void unfold(const TriangleMesh& mesh, const FaceStrip& strip);
  void add(const Corner& corner);
  [[nodiscard]] EdgePoint crossing(const TriangleMesh& mesh, const Portal& portal, std::size_t k,
                                   const Corner& a, const Corner& b) const;

  Point2 start_, end_;
  std::vector<Gate> gates_;
  std::vector<Corner> corners_;
  std::vector<Corner> chains_[2];  // right and left side of the funnel, from the apex outwards
  std::size_t heads_[2] = {0, 0};
};

}  // namespace graftsman
