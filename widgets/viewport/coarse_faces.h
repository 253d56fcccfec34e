#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Fewer faces on the vertices of a surface: what it looks like while frames must be quick.
struct CoarseFaces {
  std::vector<Face> faces;
  std::vector<Index> sources;  // of each, a face of the surface in whose place it stands
};

/// Surfaces of no more faces are always drawn whole. What has more must be made ready on a worker thread.
inline constexpr std::size_t kManyDrawnFaces = 300'000;

/// The cubes in which vertices are taken together. Surfaces that share it share their coarse faces.
struct ClusterGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double cell = 1;  // > 0

  /// About 10⁵ faces for a surface in a box of this size.
  [[nodiscard]] static ClusterGrid across(double size,
                                          const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());
};

/// Of the vertices in one cube whose normals look the same way the one nearest to the cube's middle stands
/// for all; faces that become an edge or a point are left out. Vertices on a border stand for themselves, so
/// that what lies beside them still fits. No faces if there are no more than kManyDrawnFaces. positions,
/// normals: 3 × vertexCount. Cost: linear.
[[nodiscard]] CoarseFaces coarsen(const float* positions, const float* normals, Index vertexCount,
                                  std::span<const Face> faces, const ClusterGrid& grid);

[[nodiscard]] Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh);

/// Likewise of a mesh's shaded vertices and the faces between them, in cubes that divide the box.
/// meshVertices, normals: of each shaded vertex.
[[nodiscard]] CoarseFaces coarsen(const TriangleMesh& mesh, std::span<const Index> meshVertices,
                                  std::span<const Eigen::Vector3f> normals, std::span<const Face> faces,
                                  const Eigen::AlignedBox3d& box);

}  // namespace graftsman
