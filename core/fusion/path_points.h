#pragma once

#include <span>
#include <vector>

#include "core/mesh/surface_point.h"

namespace graftsman {

class PathObstacles;

/// The smaller halfedge of h's edge: the one that EdgePoint names.
[[nodiscard]] inline Index canonical(const TriangleMesh& mesh, Index h) {
  const Index twin = mesh.twin(h);
  return twin >= 0 && twin < h ? twin : h;
}

/// What two points of a path have in common: an edge (its canonical halfedge), or else a face, or nothing.
struct SharedPlace {
  Index edge = -1;
  Index face = -1;
};

/// Where the straight line from a to b runs. Precondition: vertices are not singular; a ≠ b.
[[nodiscard]] SharedPlace sharedPlace(const TriangleMesh& mesh, const EdgePoint& a, const EdgePoint& b);

/// Where a point lies on a face's perimeter, counter-clockwise from corner 0. Exact: keys compare as places
/// do.
struct PerimeterPosition {
  int edge = 0;    // 0, 1, 2: on the way from this corner to the next
  double key = 0;  // −2 at the corner itself; rises along the edge
  friend auto operator<=>(const PerimeterPosition&, const PerimeterPosition&) = default;
};

/// Precondition: p lies on the perimeter of the face.
[[nodiscard]] PerimeterPosition perimeterPosition(const TriangleMesh& mesh, Index face, const EdgePoint& p);

/// True if the chords a–b and p–q of one face cross between their ends; sharing an end is not crossing.
[[nodiscard]] bool chordsCross(const PerimeterPosition& a, const PerimeterPosition& b,
                               const PerimeterPosition& p, const PerimeterPosition& q);

/// The length of a polyline of path points.
[[nodiscard]] double polylineLength(const TriangleMesh& mesh, std::span<const EdgePoint> points);

/// The polyline without detours inside one face: no point lies between two that share a face with nothing of
/// `obstacles` between them. Then two consecutive points lie on one edge only if they are its ends. Never
/// longer than given. Precondition: consecutive points share a face or are equal.
[[nodiscard]] std::vector<EdgePoint> withoutDetours(const PathObstacles& obstacles,
                                                    std::span<const EdgePoint> points);

/// Cuts out every loop of the polyline: where it meets or crosses itself, what lies between goes. True if
/// something went.
bool removeLoops(const TriangleMesh& mesh, std::vector<EdgePoint>& points);

}  // namespace graftsman
