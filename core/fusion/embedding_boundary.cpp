#include "core/fusion/embedding_boundary.h"

#include <algorithm>

namespace graftsman {
namespace {

/// Share of its side's mean edge that every boundary edge gets at least. Far below what anyone sees, and yet
/// even with 10⁶ boundary vertices neighbours lie 10⁶ roundings apart.
constexpr double kShortestEdge = 1e-4;

/// Lengths of the edges first → first + 1 → … → last (taken modulo B), none below the shortest allowed.
std::vector<double> edgeLengths(std::span<const Point> points, Index boundarySize, Index first, Index last) {
  std::vector<double> lengths;
  double sum = 0;
  for (Index a = first; a < last; ++a) {
    const Index b = a + 1 == boundarySize ? 0 : a + 1;
    lengths.push_back((points[static_cast<std::size_t>(b)] - points[static_cast<std::size_t>(a)]).norm());
    sum += lengths.back();
  }
  const double shortest = kShortestEdge * sum / static_cast<double>(lengths.size());
  for (double& length : lengths) {
    length = shortest > 0 ? std::max(length, shortest) : 1;
  }
  return lengths;
}

}  // namespace

std::vector<BoundaryPosition> layOutBoundary(std::span<const Point> points, Index boundarySize,
                                             std::span<const Index> corners) {
  std::vector<BoundaryPosition> positions;
  positions.reserve(static_cast<std::size_t>(boundarySize));
  for (std::size_t side = 0; side < corners.size(); ++side) {
    const Index last = side + 1 < corners.size() ? corners[side + 1] : boundarySize;
    const std::vector<double> lengths = edgeLengths(points, boundarySize, corners[side], last);
    double sum = 0;
    for (const double length : lengths) {
      sum += length;
    }
    double before = 0;
    for (const double length : lengths) {
      positions.push_back({static_cast<Index>(side), before / sum});
      before += length;
    }
  }
  return positions;
}

}  // namespace graftsman
