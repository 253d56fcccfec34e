#pragma once

#include <span>
#include <vector>

#include "core/fusion/path_obstacles.h"

namespace graftsman {

/// A stretch of an edge through which a path passes from one face to the next.
struct Portal {
  Index h =
      -1;  // the edge's halfedge in the face that is left: its end is on the left, its start on the right
  double lo = 0;  // t of the canonical halfedge; 0 is the vertex itself, a blocked end lies a little inside
  double hi = 1;
};

/// A strip of faces from one vertex to another, as the portals between them. The first vertex is opposite the
/// first portal in its face, the last one opposite the last. Empty: the vertices are neighbours.
struct FaceStrip {
  Index from = -1;
  Index to = -1;
  std::vector<Portal> portals;
};

/// The portal for leaving the face of h through an interval of its edge. Blocked ends are kept off by a
/// fraction of the interval.
[[nodiscard]] Portal makePortal(const PathObstacles::Interval& interval, Index h);

/// Adds a portal; one that leads straight back cancels the last.
void pushPortal(const TriangleMesh& mesh, std::vector<Portal>& portals, const Portal& portal);

/// Drops portals at both ends that the end vertices themselves lie on.
void trimEnds(const TriangleMesh& mesh, FaceStrip& strip);

/// The strip of the faces that a polyline runs through. Round a vertex it takes the side with the smaller
/// angle. Precondition: no detours (see path_points.h), every point but the ends is free.
[[nodiscard]] FaceStrip stripAlong(const TriangleMesh& mesh, const PathObstacles& obstacles,
                                   std::span<const EdgePoint> points);

/// The angle at corner from(h) of the face of h, in radians; 0 for a degenerate corner.
[[nodiscard]] double cornerAngle(const TriangleMesh& mesh, Index h);

}  // namespace graftsman
