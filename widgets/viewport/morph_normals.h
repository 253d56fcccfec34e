#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A normal with twice the area as its length; the fourth number means nothing.
using AreaVector = Eigen::Vector4f;

/// Which faces meet at each vertex.
struct VertexFans {
  std::vector<Index> first;  // V + 1
  std::vector<Index> faces;  // 3F; those of vertex v: faces[first[v]] to before faces[first[v + 1]]
};

/// The fans of a mesh of `vertexCount` vertices; faces ascend within a fan.
[[nodiscard]] VertexFans findFans(std::span<const Face> faces, Index vertexCount);

/// Three floats, and one after them that must be there.
[[nodiscard]] inline Eigen::Vector4f loadFour(const float* values) {
  return Eigen::Map<const Eigen::Vector4f>(values);
}

/// The face's area vector, lengths times `perLength`.
[[nodiscard]] inline AreaVector areaOf(const float* positions, const Face& face, float perLength) {
  const Eigen::Vector4f a = loadFour(positions + std::ptrdiff_t{3} * face[0]);
  const Eigen::Vector4f b = (loadFour(positions + std::ptrdiff_t{3} * face[1]) - a) * perLength;
  const Eigen::Vector4f c = (loadFour(positions + std::ptrdiff_t{3} * face[2]) - a) * perLength;
  return b.cross3(c);
}

/// Adds each face's area vector to the sums of its vertices. positions: 3 × V and one more.
void addAreas(const float* positions, std::span<const Face> faces, float perLength,
              std::span<AreaVector> sums);

/// Writes the direction of `sum` into three floats; where it has none, any.
inline void writeNormal(const AreaVector& sum, float* normal) {
  const float x = sum[0];
  const float y = sum[1];
  const float z = sum[2];
  const float squared = x * x + y * y + z * z;
  const float perLength = 1 / std::sqrt(squared);
  normal[0] = squared > 0 ? x * perLength : 0;
  normal[1] = squared > 0 ? y * perLength : 0;
  normal[2] = squared > 0 ? z * perLength : 1;
}

}  // namespace graftsman
