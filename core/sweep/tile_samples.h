#pragma once

#include <vector>

#include "core/fusion/update.h"

namespace graftsman {

/// Places of a combined tile by which results of the same base and loop are compared, however the part lies:
/// points of the n-gon, on which the base's embedding is the same for all of them.
class TileSamples {
 public:
  /// At most `count` of the combined tile's interior vertices, evenly out of their order: more where its
  /// meshes are finer.
  TileSamples(const CombinedTile& combined, std::size_t count);

  /// Where the results' surface is at each. Precondition: `fused` is there. Cost: a look at each face of the
  /// combined tile, once for all results that have the same one.
  [[nodiscard]] std::vector<Point> positions(const FusionResults& results);
  /// How far the adjusted part is from the base there: root mean square. As positions().
  [[nodiscard]] double partDistance(const FusionResults& results);

 private:
  struct Place {
    std::size_t face = 0;
    Eigen::Vector3d weights = Eigen::Vector3d(1, 0, 0);
  };
  void locate(const std::shared_ptr<const CombinedTile>& in);
  template <class PointOf>
  [[nodiscard]] std::vector<Point> interpolated(const PointOf& pointOf) const;

  std::vector<Point2> uv_;  // in increasing order of u
  std::shared_ptr<const CombinedTile> locatedIn_;
  std::vector<Place> places_;
};

/// The root mean square of the distances. Precondition: equally many, at least one.
[[nodiscard]] double rootMeanSquareDistance(const std::vector<Point>& a, const std::vector<Point>& b);

}  // namespace graftsman
