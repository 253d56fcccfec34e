#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

#include "core/fusion/fcf.h"
#include "core/fusion/join.h"
#include "widgets/viewport/coarse_faces.h"
#include "widgets/viewport/morph_layout.h"
#include "widgets/viewport/morph_normals.h"

namespace graftsman {

/// A sheet of the displayed result, as MorphLayout says. Its buffers stay where they are while their
/// MorphSurface lives; what is in them follows the curve.
struct MorphSheet {
  const float* positions = nullptr;  // 3 × vertexCount, relative to MorphSurface::centre()
  const float* normals = nullptr;    // 3 × vertexCount, of length 1
  Index vertexCount = 0;
  std::span<const Face> faces;          // numbers from the sheet's first vertex
  Eigen::AlignedBox3d box;              // relative to centre(); holds the sheet whatever the curve
  const CoarseFaces* coarse = nullptr;  // for quick frames; null: none

  [[nodiscard]] Eigen::Vector3f position(Index v) const {
    return Eigen::Map<const Eigen::Vector3f>(positions + std::ptrdiff_t{3} * v);
  }
};

/// The result of a fusion as it is shown: positions and normals in single precision, area-weighted over the
/// whole result, that follow the fusion curve. Holds on to the join and the combined tile.
class MorphSurface {
 public:
  /// Cost: in proportion to the result.
  MorphSurface(std::shared_ptr<const Join> join, std::shared_ptr<const CombinedTile> combined,
               const FCF& curve);

  /// Blends the tile along `curve` and computes the normals that change. Allocates nothing for up to 2¹⁸
  /// vertices of the tile (more are shared among threads, which must be started). True if the rest's normals
  /// changed, too: the seam has moved.
  bool setCurve(const FCF& curve);
  [[nodiscard]] const FCF& curve() const { return curve_; }

  /// What the positions are relative to, so that models far from the origin keep their shape.
  [[nodiscard]] const Point& centre() const { return centre_; }

  [[nodiscard]] MorphSheet rest() const;
  [[nodiscard]] MorphSheet rim() const;
  [[nodiscard]] MorphSheet tile() const;
  /// f at each of the tile's vertices.
  [[nodiscard]] std::span<const float> weights() const { return weights_; }

  [[nodiscard]] const Join& join() const { return *join_; }
  [[nodiscard]] const CombinedTile& combined() const { return *combined_; }
  [[nodiscard]] const MorphLayout& layout() const { return layout_; }
  [[nodiscard]] const std::vector<SeamEdge>& seamEdges() const { return seamEdges_; }

 private:
  void place();
  void blendRange(std::size_t begin, std::size_t end);
  bool moveSeam();
  void findRimNormals();
  void findTileNormals(std::size_t begin, std::size_t end);
  void findCoarseFaces();
  [[nodiscard]] MorphSheet sheet(Index first, Index end, std::span<const Face> faces,
                                 const Eigen::AlignedBox3d& box, const CoarseFaces* coarse) const;
  [[nodiscard]] float* positionsAt(Index v) { return positions_.data() + std::ptrdiff_t{3} * v; }
  [[nodiscard]] float* normalsAt(Index v) { return normals_.data() + std::ptrdiff_t{3} * v; }

  std::shared_ptr<const Join> join_;
  std::shared_ptr<const CombinedTile> combined_;
  MorphLayout layout_;
  std::vector<SeamEdge> seamEdges_;
  FCF curve_;
  Point centre_ = Point::Zero();
  Eigen::AlignedBox3d restBox_;
  Eigen::AlignedBox3d rimBox_;
  Eigen::AlignedBox3d tileBox_;

  std::vector<float> positions_;  // 3 × vertexCount, and one float that is read but not used
  std::vector<float> normals_;    // likewise
  std::vector<float> part_;       // 3 × tileSize; the tile's positions on the part
  std::vector<float> base_;
  std::vector<float> weights_;         // tileSize
  std::vector<AreaVector> ringRest_;   // ringCount; of each, the sum over its faces of the rest
  std::vector<AreaVector> rim_;        // ringCount + seamSize; of each, the sum over its faces of the rim
  VertexFans fans_;                    // of the tile
  std::vector<AreaVector> faceAreas_;  // of the tile's faces
  CoarseFaces coarseRest_;
  CoarseFaces coarseTile_;  // as the first curve has it
  float unit_ = 1;          // areas are computed in this length, so that they stay within floats
};

}  // namespace graftsman
