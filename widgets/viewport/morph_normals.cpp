#include "widgets/viewport/morph_normals.h"

#include <numeric>

namespace graftsman {

VertexFans findFans(std::span<const Face> faces, Index vertexCount) {
  VertexFans fans;
  fans.first.assign(static_cast<std::size_t>(vertexCount) + 1, 0);
  for (const Face& face : faces) {
    for (const Index v : face) {
      ++fans.first[static_cast<std::size_t>(v) + 1];
    }
  }
  std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
  fans.faces.resize(3 * faces.size());
  std::vector<Index> next(fans.first.begin(), fans.first.end() - 1);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const Index v : faces[f]) {
      fans.faces[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = static_cast<Index>(f);
    }
  }
  return fans;
}

void addAreas(const float* positions, std::span<const Face> faces, float perLength,
              std::span<AreaVector> sums) {
  for (const Face& face : faces) {
    const AreaVector area = areaOf(positions, face, perLength);
    for (const Index v : face) {
      sums[static_cast<std::size_t>(v)] += area;
    }
  }
}

}  // namespace graftsman
