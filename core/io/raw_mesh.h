#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// The content of a mesh file as the file has it: vertices and polygons.
///
/// Most files hold triangles alone, so these have a list of their own, and what is left is filed with its
/// place among them. Every corner is a valid vertex number.
struct RawMesh {
  struct Polygon {
    Index trianglesBefore = 0;  // how many of `triangles` come before it in the file
    Index firstCorner = 0;      // in `polygonCorners`; the corners end where the next polygon's begin
  };

  std::vector<Point> points;
  std::vector<Face> triangles;
  std::vector<Polygon> polygons;  // with fewer or more than three corners
  std::vector<Index> polygonCorners;
  bool binary = false;
  std::size_t fileVertices = 0;  // set where it is not points.size(): STL

  [[nodiscard]] std::size_t faceCount() const { return triangles.size() + polygons.size(); }

  [[nodiscard]] std::span<const Index> corners(std::size_t polygon) const {
    const auto first = static_cast<std::size_t>(polygons[polygon].firstCorner);
    const std::size_t last = polygon + 1 < polygons.size()
                                 ? static_cast<std::size_t>(polygons[polygon + 1].firstCorner)
                                 : polygonCorners.size();
    return {polygonCorners.data() + first, last - first};
  }

  /// Starts a polygon; its corners are then appended to polygonCorners.
  void beginPolygon() {
    polygons.push_back({static_cast<Index>(triangles.size()), static_cast<Index>(polygonCorners.size())});
  }
};

/// What a reader of one format is given.
struct ReadInput {
  std::span<const char> bytes;
  std::string name;  // the file's name, printable, for messages
  Progress progress;
};

/// More vertices, faces or corners than an Index can count.
inline constexpr std::size_t kGreatestCount = std::size_t{1} << 30;

}  // namespace graftsman
