#include "core/fusion/seam_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "core/fusion/embedding_boundary.h"
#include "core/fusion/harmonic_extension.h"
#include "core/mesh/polygon_triangulation.h"

namespace graftsman {
namespace {

// Fraction of the shorter boundary edge within which a part vertex takes a base vertex's place, as in the
// overlay.
constexpr double kFitSnap = 1e-3;

// Rounding of a position that was turned, scaled and moved, in units of the greatest coordinate.
constexpr double kFitRounding = 16 * 2.220446049250313e-16;

/// A vertex of the fitted boundary.
struct BoundaryVertex {
  BoundaryPosition position;
  Index partVertex = -1;  // the tile's boundary vertex, or −1 for one that the base brought
  Index baseVertex = -1;  // the base tile's, or −1
};

Index nextOn(Index i, std::size_t size) {
  return static_cast<std::size_t>(i) + 1 == size ? 0 : i + 1;
}

// t of boundary vertex i's successor, as seen from i's side: 1 for the next corner.
double nextT(const std::vector<BoundaryPosition>& boundary, Index i) {
  const BoundaryPosition& next = boundary[static_cast<std::size_t>(nextOn(i, boundary.size()))];
  return next.side == boundary[static_cast<std::size_t>(i)].side ? next.t : 1;
}

// The length in t of the shorter of the two boundary edges at vertex i, which is no corner.
double shorterEdge(const std::vector<BoundaryPosition>& boundary, Index i) {
  const double t = boundary[static_cast<std::size_t>(i)].t;
  const double before = boundary[static_cast<std::size_t>(i - 1)].t;
  return std::min(t - before, nextT(boundary, i) - t);
}

bool snaps(const std::vector<BoundaryPosition>& part, Index i, const std::vector<BoundaryPosition>& base,
           Index j) {
  const BoundaryPosition& p = part[static_cast<std::size_t>(i)];
  const BoundaryPosition& b = base[static_cast<std::size_t>(j)];
  if (p.side != b.side || (p.t == 0) != (b.t == 0)) {
    return false;
  }
  return p.t == b.t || std::abs(p.t - b.t) <= kFitSnap * std::min(shorterEdge(part, i), shorterEdge(base, j));
}

// Both boundaries in one order.
std::vector<BoundaryVertex> mergeBoundaries(const std::vector<BoundaryPosition>& part,
                                            const std::vector<BoundaryPosition>& base) {
  std::vector<BoundaryVertex> merged;
  merged.reserve(part.size() + base.size());
  Index i = 0;
  Index j = 0;
  const auto partSize = static_cast<Index>(part.size());
  const auto baseSize = static_cast<Index>(base.size());
  while (i < partSize || j < baseSize) {
    if (i < partSize && j < baseSize && snaps(part, i, base, j)) {
      merged.push_back({base[static_cast<std::size_t>(j)], i++, j});
      ++j;
    } else if (j == baseSize ||
               (i < partSize && part[static_cast<std::size_t>(i)] < base[static_cast<std::size_t>(j)])) {
      merged.push_back({part[static_cast<std::size_t>(i)], i, -1});
      ++i;
    } else {
      merged.push_back({base[static_cast<std::size_t>(j)], -1, j});
      ++j;
    }
  }
  return merged;
}

// Positions of the merged boundary's vertices on one of the two curves: exactly the curve's own vertices, the
// others between their neighbours of the curve in proportion to t.
std::vector<Point> placeOnCurve(const std::vector<BoundaryVertex>& merged, Index BoundaryVertex::*own,
                                const std::vector<BoundaryPosition>& boundary,
                                std::span<const Point> points) {
  std::vector<Point> placed;
  placed.reserve(merged.size());
  Index last = 0;
  for (const BoundaryVertex& vertex : merged) {
    if (vertex.*own >= 0) {
      last = vertex.*own;
      placed.push_back(points[static_cast<std::size_t>(last)]);
      continue;
    }
    const double start = boundary[static_cast<std::size_t>(last)].t;
    const double share = std::clamp((vertex.position.t - start) / (nextT(boundary, last) - start), 0.0, 1.0);
    const Point& a = points[static_cast<std::size_t>(last)];
    const Point& b = points[static_cast<std::size_t>(nextOn(last, boundary.size()))];
    placed.push_back(a + share * (b - a));
  }
  return placed;
}

/// Divides the tile's faces at the boundary for the vertices that the base brought.
class BoundaryDivider {
 public:
  BoundaryDivider(const Tile& tile, const std::vector<BoundaryVertex>& merged, FittedTile& fitted)
      : tile_(tile), merged_(merged), fitted_(fitted), numbers_(static_cast<std::size_t>(tile.boundarySize)) {
    for (std::size_t i = 0; i < merged.size(); ++i) {
      if (merged[i].partVertex >= 0) {
        numbers_[static_cast<std::size_t>(merged[i].partVertex)] = static_cast<Index>(i);
      }
    }
  }

  void run() {
    for (std::size_t f = 0; f < tile_.faces.size(); ++f) {
      ids_.clear();
      sides_.clear();
      for (std::size_t k = 0; k < 3; ++k) {
        addSide(tile_.faces[f][k], tile_.faces[f][(k + 1) % 3], k);
      }
      points_.clear();
      for (const Index id : ids_) {
        points_.push_back(fitted_.points[static_cast<std::size_t>(id)]);
      }
      triangulatePolygon(ids_, points_, sides_, fitted_.faces);
      fitted_.parents.resize(fitted_.faces.size(), static_cast<Index>(f));
    }
    for (const Index corner : tile_.corners) {
      fitted_.corners.push_back(numbers_[static_cast<std::size_t>(corner)]);
    }
  }

 private:
  [[nodiscard]] Index numberOf(Index vertex) const {
    return vertex < tile_.boundarySize ? numbers_[static_cast<std::size_t>(vertex)]
                                       : vertex - tile_.boundarySize + static_cast<Index>(merged_.size());
  }

  // Corner a of the face, and what the base put between a and b.
  void addSide(Index a, Index b, std::size_t side) {
    ids_.push_back(numberOf(a));
    sides_.push_back(static_cast<std::uint8_t>(1U << side | 1U << (side + 2) % 3));
    if (a >= tile_.boundarySize || b != nextOn(a, numbers_.size())) {
      return;
    }
    const auto end = static_cast<Index>(merged_.size());
    for (Index i = numberOf(a) + 1; i < end && merged_[static_cast<std::size_t>(i)].partVertex < 0; ++i) {
      ids_.push_back(i);
      sides_.push_back(static_cast<std::uint8_t>(1U << side));
    }
  }

  const Tile& tile_;
  const std::vector<BoundaryVertex>& merged_;
  FittedTile& fitted_;
  std::vector<Index> numbers_;  // of each boundary vertex of the tile
  std::vector<Index> ids_;
  std::vector<Point> points_;
  std::vector<std::uint8_t> sides_;
};

double greatestCoordinate(const std::vector<Point>& points) {
  double greatest = 0;
  for (const Point& p : points) {
    greatest = std::max(greatest, p.cwiseAbs().maxCoeff());
  }
  return greatest;
}

// Whether the fitted tile is the base's, vertex by vertex, but for rounding errors.
bool isBaseTile(const FittedTile& fitted, const Tile& base, double rounding) {
  return fitted.points.size() == base.points.size() && fitted.faces == base.faces &&
         std::equal(
             fitted.points.begin(), fitted.points.end(), base.points.begin(),
             [&](const Point& a, const Point& b) { return (a - b).cwiseAbs().maxCoeff() <= rounding; });
}

}  // namespace

FittedTile keepBoundary(const Tile& tile, const Adjustment& adjustment) {
  FittedTile fitted;
  fitted.points = adjustment.points;
  fitted.faces = tile.faces;
  fitted.parents.resize(tile.faces.size());
  for (std::size_t f = 0; f < fitted.parents.size(); ++f) {
    fitted.parents[f] = static_cast<Index>(f);
  }
  fitted.corners = tile.corners;
  fitted.boundary = layOutBoundary(adjustment.points, tile.boundarySize, tile.corners);
  return fitted;
}

Result<FittedTile> fitBoundary(const Tile& tile, const Adjustment& adjustment, const Tile& base,
                               const std::vector<BoundaryPosition>& baseBoundary, const Progress& progress) {
  assert(tile.corners.size() == base.corners.size());
  const std::vector<BoundaryPosition> partBoundary =
      layOutBoundary(adjustment.points, tile.boundarySize, tile.corners);
  const std::vector<BoundaryVertex> merged = mergeBoundaries(partBoundary, baseBoundary);

  FittedTile fitted;
  fitted.points = placeOnCurve(merged, &BoundaryVertex::partVertex, partBoundary, adjustment.points);
  fitted.points.insert(fitted.points.end(), adjustment.points.begin() + tile.boundarySize,
                       adjustment.points.end());
  BoundaryDivider(tile, merged, fitted).run();
  for (const BoundaryVertex& vertex : merged) {
    fitted.boundary.push_back(vertex.position);
  }

  const std::vector<Point> target =
      placeOnCurve(merged, &BoundaryVertex::baseVertex, baseBoundary, base.points);
  std::vector<Eigen::Vector3d> corrections;
  corrections.reserve(merged.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    corrections.emplace_back(target[i] - fitted.points[i]);
    fitted.meanDistance += corrections.back().norm() / static_cast<double>(merged.size());
    fitted.greatestDistance = std::max(fitted.greatestDistance, corrections.back().norm());
  }
  const Result<std::vector<Eigen::Vector3d>> spread =
      extendHarmonically(fitted.points, fitted.faces, corrections, progress);
  if (!spread) {
    return fail(spread.error());
  }
  for (std::size_t v = 0; v < fitted.points.size(); ++v) {
    fitted.points[v] = v < target.size() ? target[v] : Point(fitted.points[v] + (*spread)[v]);
  }
  const double farthest =
      std::max(greatestCoordinate(base.points), adjustment.report.scale * greatestCoordinate(tile.points));
  if (isBaseTile(fitted, base, kFitRounding * farthest)) {
    fitted.points = base.points;  // then its embedding has the same bits, too
  }
  return fitted;
}

}  // namespace graftsman
