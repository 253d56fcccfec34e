#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Divides one triangle by points put into it one after the other, each given by its weights of the three
/// corners. Exact: a point is inside a piece, on an edge between two pieces, or at an earlier point.
class PointInsertion {
 public:
  /// Starts with one piece: the triangle itself, its corners numbered as in `corners`.
  explicit PointInsertion(const Face& corners);

  /// Puts the point numbered `id` in and returns −1, or returns the number of the earlier point or corner
  /// that has the same place. Precondition: weights are finite, none is negative, not all are 0. Cost: one
  /// visit of every piece.
  Index insert(Index id, const Eigen::Vector3d& weights);

  /// The pieces, oriented as the triangle. Each has a positive area in the weights' plane.
  [[nodiscard]] std::vector<Face> pieces() const;

 private:
  struct Site {
    Index id;
    Eigen::Vector3d weights;
  };
  std::vector<Site> sites_;
  std::vector<std::array<std::size_t, 3>> pieces_;  // of sites_
};

}  // namespace graftsman
