#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// How far points are from a mesh's surface: a tree of boxes over its faces. Immutable; any number of threads
/// may ask at once. Memory: about 60 bytes a face.
class NearestSurface {
 public:
  /// Cost O(F log F). Precondition: at least one face.
  explicit NearestSurface(std::shared_ptr<const TriangleMesh> mesh);

  [[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh() const { return mesh_; }

  /// The distance of p to the nearest face, or `bound` if none is nearer: a bound known beforehand saves
  /// time. Exact but for the rounding of the distance to that face.
  [[nodiscard]] double distance(const Point& p, double bound = std::numeric_limits<double>::infinity()) const;

  struct Nearest {
    Index face =
        -1;  // of several at the same distance always the same one; −1: none is nearer than the bound
    double distance = 0;
  };
  /// The same with the face.
  [[nodiscard]] Nearest nearest(const Point& p, double bound = std::numeric_limits<double>::infinity()) const;

 private:
  struct Box {
    Point low;
    Point high;
    Index first =
        0;  // of a leaf: its first entry in faces_; of another box: its first child, the second follows
    Index count = 0;  // faces of a leaf; 0: no leaf
  };

  void build(Index box, Index first, Index last, const std::vector<Point>& centres);

  std::shared_ptr<const TriangleMesh> mesh_;
  std::vector<Index> faces_;
  std::vector<Box> boxes_;
};

}  // namespace graftsman
