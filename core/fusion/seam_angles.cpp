#include "core/fusion/seam_angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace graftsman {
namespace {

Eigen::Vector3d normalOf(std::span<const Point> points, const Face& face) {
  const Point& a = points[static_cast<std::size_t>(face[0])];
  return (points[static_cast<std::size_t>(face[1])] - a).cross(points[static_cast<std::size_t>(face[2])] - a);
}

// The faces beside each edge of the seam; edge i leads from seam vertex i to the next.
struct Beside {
  std::vector<Index> inner;  // of the combined tile; −1: none
  std::vector<Index> outer;  // of the remainder
};

Beside facesBeside(const Join& join, std::size_t vertexCount, Index seamSize) {
  std::vector<Index> numbers(vertexCount, -1);  // of each vertex of the result, its number on the seam
  for (Index i = 0; i < seamSize; ++i) {
    numbers[static_cast<std::size_t>(join.tileVertices[static_cast<std::size_t>(i)])] = i;
  }
  Beside beside;
  beside.inner.assign(static_cast<std::size_t>(seamSize), -1);
  beside.outer = beside.inner;
  for (std::size_t f = 0; f < join.faces.size(); ++f) {
    const bool isInner = f >= static_cast<std::size_t>(join.restFaces);
    for (std::size_t k = 0; k < 3; ++k) {
      Index from = numbers[static_cast<std::size_t>(join.faces[f][k])];
      Index to = numbers[static_cast<std::size_t>(join.faces[f][(k + 1) % 3])];
      if (!isInner) {
        std::swap(from, to);
      }
      if (from >= 0 && to == (from + 1) % seamSize) {
        (isInner ? beside.inner : beside.outer)[static_cast<std::size_t>(from)] = static_cast<Index>(f);
      }
    }
  }
  return beside;
}

}  // namespace

SeamAngles seamAngles(std::span<const Point> points, const Join& join, Index seamSize) {
  const Beside beside = facesBeside(join, points.size(), seamSize);
  SeamAngles angles;
  double lengths = 0;
  for (Index i = 0; i < seamSize; ++i) {
    const Index inner = beside.inner[static_cast<std::size_t>(i)];
    const Index outer = beside.outer[static_cast<std::size_t>(i)];
    if (inner < 0 || outer < 0) {
      continue;
    }
    const Eigen::Vector3d a = normalOf(points, join.faces[static_cast<std::size_t>(inner)]);
    const Eigen::Vector3d b = normalOf(points, join.faces[static_cast<std::size_t>(outer)]);
    const double sine = a.cross(b).norm();
    const double cosine = a.dot(b);
    if (sine == 0 && cosine == 0) {
      continue;
    }
    const auto place = [&](Index k) -> const Point& {
      return points[static_cast<std::size_t>(join.tileVertices[static_cast<std::size_t>(k % seamSize)])];
    };
    const double angle = std::atan2(sine, cosine);
    const double length = (place(i + 1) - place(i)).norm();
    angles.greatest = std::max(angles.greatest, angle);
    angles.mean += angle * length;
    lengths += length;
  }
  angles.mean = lengths > 0 ? angles.mean / lengths : 0;
  return angles;
}

}  // namespace graftsman
