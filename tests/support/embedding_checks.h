#pragma once

#include <set>
#include <string>

#include "core/base/predicates.h"
#include "core/fusion/embedding.h"
#include "tests/support/tiles.h"

/// What an Embedding promises, checked from outside.
namespace graftsman {

inline double layoutArea(const Embedding& e, const Face& face) {
  const Point2& a = e.uv[static_cast<std::size_t>(face[0])];
  const Point2 ab = e.uv[static_cast<std::size_t>(face[1])] - a;
  const Point2 ac = e.uv[static_cast<std::size_t>(face[2])] - a;
  return (ab.x() * ac.y() - ab.y() * ac.x()) / 2;
}

inline double regularPolygonArea(Index sides) {
  return sides * std::sin(2 * std::numbers::pi / sides) / 2;
}

/// The position on the tile of a vertex of the embedding.
inline Point embeddedPoint(const shapes::DiscTile& tile, const Embedding& e, Index v) {
  const auto index = static_cast<std::size_t>(v);
  if (index < tile.points.size()) {
    return tile.points[index];
  }
  const AddedVertex& added = e.added[index - tile.points.size()];
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    sum +=
        added.weights[static_cast<Eigen::Index>(i)] * tile.points[static_cast<std::size_t>(added.corners[i])];
  }
  return sum;
}

inline double embeddedFaceArea(const shapes::DiscTile& tile, const Embedding& e, const Face& face) {
  const Point a = embeddedPoint(tile, e, face[0]);
  return (embeddedPoint(tile, e, face[1]) - a).cross(embeddedPoint(tile, e, face[2]) - a).norm() / 2;
}

/// True if the areas on the tile of each face's parts sum to its own.
inline bool partsCoverParents(const shapes::DiscTile& tile, const Embedding& e) {
  std::vector<double> rest(tile.faces.size());
  for (std::size_t f = 0; f < rest.size(); ++f) {
    rest[f] = embeddedFaceArea(tile, e, tile.faces[f]);
  }
  for (std::size_t f = 0; f < e.faces.size(); ++f) {
    rest[static_cast<std::size_t>(e.parents[f])] -= embeddedFaceArea(tile, e, e.faces[f]);
  }
  for (std::size_t f = 0; f < rest.size(); ++f) {
    if (std::abs(rest[f]) > 1e-12 * embeddedFaceArea(tile, e, tile.faces[f])) {
      return false;
    }
  }
  return true;
}

inline std::string brokenBoundary(const shapes::DiscTile& tile, const Embedding& e) {
  for (std::size_t i = 0; i < e.boundary.size(); ++i) {
    const std::string which = "boundary vertex " + std::to_string(i);
    if (e.uv[i] != boundaryPoint(e.sides, e.boundary[i])) {
      return which + " is not at its boundaryPoint()";
    }
    if (!(e.boundary[i].t >= 0 && e.boundary[i].t < 1)) {
      return which + " is beside its side";
    }
    if (i > 0 && (!(e.boundary[i - 1] < e.boundary[i]) || e.uv[i] == e.uv[i - 1])) {
      return which + " is out of order";
    }
  }
  for (std::size_t i = 0; i < tile.corners.size(); ++i) {
    if (e.boundary[static_cast<std::size_t>(tile.corners[i])] != BoundaryPosition{static_cast<Index>(i), 0}) {
      return "corner " + std::to_string(i) + " is elsewhere";
    }
  }
  return {};
}

/// Which of the promises of struct Embedding is broken; empty if none.
inline std::string brokenPromise(const shapes::DiscTile& tile, const Embedding& e) {
  const Index boundary = tile.boundarySize;
  if (e.sides != static_cast<Index>(tile.corners.size()) ||
      e.uv.size() != tile.points.size() + e.added.size() || e.parents.size() != e.faces.size() ||
      e.boundary.size() != static_cast<std::size_t>(boundary)) {
    return "sizes do not fit";
  }
  const auto isBoundaryEdge = [&](Index a, Index b) { return a < boundary && b == (a + 1) % boundary; };
  double sum = 0;
  std::set<std::pair<Index, Index>> halfedges;
  for (const Face& face : e.faces) {
    const std::string which =
        "face " + std::to_string(face[0]) + " " + std::to_string(face[1]) + " " + std::to_string(face[2]);
    const auto at = [&](std::size_t k) { return e.uv[static_cast<std::size_t>(face[k])]; };
    if (orient2d(at(0), at(1), at(2)) != 1) {
      return which + " is not counter-clockwise";
    }
    sum += layoutArea(e, face);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face[k];
      const Index b = face[(k + 1) % 3];
      if (!halfedges.emplace(a, b).second) {
        return which + " has an edge that another runs through in the same direction";
      }
      if (a < boundary && b < boundary && !isBoundaryEdge(a, b)) {
        return which + " has an interior edge between boundary vertices";
      }
    }
  }
  for (const auto& [a, b] : halfedges) {
    if (!isBoundaryEdge(a, b) && !halfedges.contains({b, a})) {
      return "edge " + std::to_string(a) + " " + std::to_string(b) + " has one side";
    }
  }
  if (std::abs(sum - regularPolygonArea(e.sides)) > 1e-12) {
    return "the areas sum to " + std::to_string(sum);
  }
  return brokenBoundary(tile, e);
}

}  // namespace graftsman
