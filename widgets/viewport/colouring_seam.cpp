#include "widgets/viewport/colouring_seam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace graftsman {
namespace {

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
constexpr double kNone = -1;

using Triangle = std::array<Point, 3>;

Point blended(const MorphSurface& surface, Index v) {
  const CombinedTile& combined = surface.combined();
  const auto k = static_cast<std::size_t>(v);
  const double f = surface.curve()(combined.s[k]);
  return f * combined.part[k] + (1 - f) * combined.base[k];
}

Triangle tileTriangle(const MorphSurface& surface, Index face) {
  const Face& corners = surface.combined().faces[static_cast<std::size_t>(face)];
  return {blended(surface, corners[0]), blended(surface, corners[1]), blended(surface, corners[2])};
}

Triangle rimTriangle(const MorphSurface& surface, Index face) {
  const MorphLayout& layout = surface.layout();
  const auto position = [&](Index v) -> Point {
    if (v >= layout.ringCount) {
      return blended(surface, v - layout.ringCount);
    }
    const Index joined =
        layout.restVertices[static_cast<std::size_t>(layout.ringBegin()) + static_cast<std::size_t>(v)];
    return surface.join().points[static_cast<std::size_t>(joined)];
  };
  const Face& corners = layout.rimFaces[static_cast<std::size_t>(face)];
  return {position(corners[0]), position(corners[1]), position(corners[2])};
}

double angleBetween(const Triangle& a, const Triangle& b) {
  const Eigen::Vector3d normalA = (a[1] - a[0]).cross(a[2] - a[0]);
  const Eigen::Vector3d normalB = (b[1] - b[0]).cross(b[2] - b[0]);
  const double sine = normalA.cross(normalB).norm();
  const double cosine = normalA.dot(normalB);
  return sine == 0 && cosine == 0 ? kNone : std::atan2(sine, cosine) * kDegreesPerRadian;
}

}  // namespace

void measureSeamAngles(const MorphSurface& surface, SeamAngles& angles) {
  const std::vector<SeamEdge>& edges = surface.seamEdges();
  angles.degrees.assign(edges.size(), kNone);
  angles.greatest = 0;
  double sum = 0;
  double lengths = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].tileFace < 0 || edges[i].rimFace < 0) {
      continue;
    }
    const double angle =
        angleBetween(tileTriangle(surface, edges[i].tileFace), rimTriangle(surface, edges[i].rimFace));
    if (angle < 0) {
      continue;
    }
    const auto from = static_cast<Index>(i);
    const Index to = i + 1 == edges.size() ? 0 : from + 1;
    const double length = (blended(surface, to) - blended(surface, from)).norm();
    angles.degrees[i] = angle;
    angles.greatest = std::max(angles.greatest, angle);
    sum += angle * length;
    lengths += length;
  }
  angles.mean = lengths > 0 ? sum / lengths : 0;
}

}  // namespace graftsman
