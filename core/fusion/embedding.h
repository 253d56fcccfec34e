#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A position in the plane of the unit circle.
using Point2 = Eigen::Vector2d;

/// Which weights an embedding ended with.
enum class EmbeddingWeights { Cotangent, MeanValue, LowStretch };

/// Settings of the embedding.
struct EmbeddingSettings {
  /// Automatic: cotangent, mean value on a flip, low stretch where a protrusion is squeezed. Others: that
  /// one.
  enum class Method { Automatic, Cotangent, MeanValue, LowStretch } method = Method::Automatic;
  friend bool operator==(const EmbeddingSettings&, const EmbeddingSettings&) = default;
};

/// A point of the n-gon's boundary: side i leads from corner i to corner (i + 1) mod n.
struct BoundaryPosition {
  Index side = 0;
  double t = 0;  // in [0, 1): fraction of the side's length from corner i; the corner itself has t = 0
  friend auto operator<=>(const BoundaryPosition&, const BoundaryPosition&) = default;
};

/// A vertex that the embedding put into the tile (on an edge or, rarely, inside a face).
struct AddedVertex {
  std::array<Index, 3> corners;  // vertices of the tile
  Eigen::Vector3d weights;       // ≥ 0, sum 1
};

/// A tile laid out on the regular n-gon in the unit circle (Kanai et al. 1999, §2.2, after Eck et al. 1995).
/// Promises: every triangle is counter-clockwise by orient2d(); every edge that is not on the boundary has an
/// interior vertex at one end, hence each triangle has at most one boundary edge; corner i lies at angle
/// 2πi/n.
struct Embedding {
  std::vector<Point2> uv;                  // V'×2; the tile's V vertices, then `added`
  std::vector<Face> faces;                 // F'×3; the tile's faces, some divided
  std::vector<Index> parents;              // F'; the tile's face of each
  std::vector<AddedVertex> added;          // V' − V
  std::vector<BoundaryPosition> boundary;  // B; ascending; boundary[0] is corner 0
  Index sides = 0;                         // n
  EmbeddingWeights weights = EmbeddingWeights::Cotangent;
  int flippedCotangent = 0;      // triangles that the cotangent weights flipped, if they were tried
  double smallestAreaRatio = 0;  // least over the faces of uv-area / (n-gon's area · share of 3D area)
};

/// The position of a point of the n-gon's boundary. Equal arguments give equal bits: corners from cos and
/// sin, other points by corner + t (next corner − corner).
[[nodiscard]] Point2 boundaryPoint(Index sides, const BoundaryPosition& position);

/// Embeds the tile with vertices `points` (V×3, the first `boundarySize` of them the boundary in order;
/// corners as in Tile). Errors: EmbeddingFailed, Cancelled.
[[nodiscard]] Result<Embedding> embed(std::span<const Point> points, std::span<const Face> faces,
                                      Index boundarySize, std::span<const Index> corners,
                                      const EmbeddingSettings& settings, const Progress& progress);

/// The same with the boundary's positions on the n-gon given: B of them, ascending from corner 0, no two
/// nearer than doubles can tell apart.
[[nodiscard]] Result<Embedding> embed(std::span<const Point> points, std::span<const Face> faces,
                                      std::vector<BoundaryPosition> boundaryPositions, Index sides,
                                      const EmbeddingSettings& settings, const Progress& progress);

}  // namespace graftsman
