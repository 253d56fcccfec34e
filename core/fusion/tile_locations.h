#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Where a vertex of the combined tile lies on one embedding.
struct TileLocation {
  enum class Kind : std::uint8_t { OnVertex, OnEdge, InFace } kind = Kind::OnVertex;
  std::array<Index, 3> corners = {-1, -1, -1};         // vertices of the embedding; 1, 2 or 3 of them
  Eigen::Vector3d weights = Eigen::Vector3d(1, 0, 0);  // each in [0, 1], sum 1, 0 where unused
};

/// The locations of many vertices on one embedding, in 16 bytes each, and 32 more in a face: most of a
/// combined tile's vertices are crossings, which lie on edges.
class TileLocations {
 public:
  /// Of `count` vertices, of which those in faces will have the slots 0 … inFaces − 1.
  TileLocations() = default;
  TileLocations(std::size_t count, std::size_t inFaces);

  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] TileLocation operator[](std::size_t vertex) const;

  /// `slot`: the vertex's own, unused but in a face. Threads may set different vertices at once.
  void set(std::size_t vertex, const TileLocation& location, std::size_t slot);

 private:
  static constexpr Index kOnVertex = -1;
  static constexpr Index kInFace = -2;

  struct Place {
    Index from;  // the vertex, the edge's start, or the slot in faces_
    Index to;    // kOnVertex, the edge's end, or kInFace
    double t;    // the fraction of the edge
    // Not initialised: pages of memory are first touched where they are written.
    Place() {}  // NOLINT(cppcoreguidelines-pro-type-member-init,modernize-use-equals-default)
  };
  struct InFace {
    std::array<Index, 3> corners;
    Eigen::Vector2d weights;  // of corners 1 and 2
  };
  std::vector<Place> places_;
  std::vector<InFace> faces_;
};

}  // namespace graftsman
