#include "core/mesh/nearest_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "core/mesh/triangle_distance.h"

namespace graftsman {
namespace {

constexpr Index kLeaf = 4;  // faces at most

double distanceToBox(const Point& p, const Point& low, const Point& high) {
  return (low - p).cwiseMax(p - high).cwiseMax(0).norm();
}

}  // namespace

NearestSurface::NearestSurface(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {
  assert(mesh_->faceCount() > 0);
  faces_.resize(static_cast<std::size_t>(mesh_->faceCount()));
  std::iota(faces_.begin(), faces_.end(), 0);
  std::vector<Point> centres;
  centres.reserve(faces_.size());
  for (const auto& [a, b, c] : mesh_->faces()) {
    centres.emplace_back(mesh_->point(a) / 3 + mesh_->point(b) / 3 + mesh_->point(c) / 3);
  }
  boxes_.reserve(faces_.size());
  boxes_.emplace_back();
  build(0, 0, mesh_->faceCount(), centres);
}

// Fills the box in for the faces [first, last) of faces_, halved along the longest side at the median.
void NearestSurface::build(Index box, Index first, Index last, const std::vector<Point>& centres) {
  Eigen::AlignedBox3d around;
  Eigen::AlignedBox3d middles;
  for (Index i = first; i < last; ++i) {
    const Index face = faces_[static_cast<std::size_t>(i)];
    for (const Index v : mesh_->face(face)) {
      around.extend(mesh_->point(v));
    }
    middles.extend(centres[static_cast<std::size_t>(face)]);
  }
  Box made = {around.min(), around.max(), first, last - first};
  if (last - first > kLeaf) {
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const Index middle = first + (last - first) / 2;
    // Equal centres by their face's number: the same tree everywhere.
    std::nth_element(faces_.begin() + first, faces_.begin() + middle, faces_.begin() + last,
                     [&](Index a, Index b) {
                       const double ofA = centres[static_cast<std::size_t>(a)][axis];
                       const double ofB = centres[static_cast<std::size_t>(b)][axis];
                       return ofA != ofB ? ofA < ofB : a < b;
                     });
    made.first = static_cast<Index>(boxes_.size());
    made.count = 0;
    boxes_.resize(boxes_.size() + 2);
    build(made.first, first, middle, centres);
    build(made.first + 1, middle, last, centres);
  }
  boxes_[static_cast<std::size_t>(box)] = made;
}

double NearestSurface::distance(const Point& p, double bound) const {
  return nearest(p, bound).distance;
}

NearestSurface::Nearest NearestSurface::nearest(const Point& p, double bound) const {
  Nearest best = {-1, bound};
  struct Waiting {
    Index box;
    double distance;
  };
  // The tree is balanced: its depth, and with it what waits, is at most the number of bits of an Index.
  std::array<Waiting, 64> waiting;
  std::size_t count = 0;
  const auto distanceTo = [&](Index box) {
    const Box& b = boxes_[static_cast<std::size_t>(box)];
    return distanceToBox(p, b.low, b.high);
  };
  waiting[count++] = {0, distanceTo(0)};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (next.distance >= best.distance) {
      continue;
    }
    const Box& box = boxes_[static_cast<std::size_t>(next.box)];
    for (Index i = box.first; i < box.first + box.count; ++i) {
      const Index face = faces_[static_cast<std::size_t>(i)];
      const auto& [a, b, c] = mesh_->face(face);
      const double distance = distanceToTriangle(p, mesh_->point(a), mesh_->point(b), mesh_->point(c));
      if (distance < best.distance) {
        best = {face, distance};
      }
    }
    if (box.count == 0) {
      Waiting nearer = {box.first, distanceTo(box.first)};
      Waiting farther = {box.first + 1, distanceTo(box.first + 1)};
      if (farther.distance < nearer.distance) {
        std::swap(nearer, farther);
      }
      waiting[count++] = farther;
      waiting[count++] = nearer;
    }
  }
  return best;
}

}  // namespace graftsman
