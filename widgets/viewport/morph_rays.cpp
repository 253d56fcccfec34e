#include "widgets/viewport/morph_rays.h"

#include <algorithm>

namespace graftsman {
namespace {

constexpr std::size_t kRayBlock = 128;
// A ray along an edge must not slip between its two faces; in barycentric coordinates.
constexpr float kSlack = 1e-5F;

bool meets(const Eigen::AlignedBox3f& box, const Eigen::Vector3f& origin, const Eigen::Array3f& perDirection,
           float before) {
  const Eigen::Array3f a = (box.min() - origin).array() * perDirection;
  const Eigen::Array3f b = (box.max() - origin).array() * perDirection;
  const float enters = std::max(a.min(b).maxCoeff(), 0.0F);
  return enters <= a.max(b).minCoeff() && enters < before;
}

/// After Möller & Trumbore 1997.
std::optional<SheetHit> meets(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                              const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
  const Eigen::Vector3f ab = b - a;
  const Eigen::Vector3f ac = c - a;
  const Eigen::Vector3f p = direction.cross(ac);
  const float determinant = ab.dot(p);
  if (determinant == 0) {
    return {};
  }
  const Eigen::Vector3f from = origin - a;
  const float u = from.dot(p) / determinant;
  const Eigen::Vector3f q = from.cross(ab);
  const float v = direction.dot(q) / determinant;
  if (!(u >= -kSlack && v >= -kSlack && u + v <= 1 + kSlack)) {
    return {};
  }
  return SheetHit{-1, ac.dot(q) / determinant, {1 - u - v, u, v}};
}

}  // namespace

void SheetRays::measure() {
  boxes_.assign((sheet_.faces.size() + kRayBlock - 1) / kRayBlock, Eigen::AlignedBox3f());
  for (std::size_t f = 0; f < sheet_.faces.size(); ++f) {
    for (const Index v : sheet_.faces[f]) {
      boxes_[f / kRayBlock].extend(sheet_.position(v));
    }
  }
}

std::optional<SheetHit> SheetRays::nearest(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                                           float before) const {
  const Eigen::Array3f perDirection = direction.array().inverse();
  std::optional<SheetHit> best;
  for (std::size_t block = 0; block < boxes_.size(); ++block) {
    if (!meets(boxes_[block], origin, perDirection, before)) {
      continue;
    }
    const std::size_t end = std::min((block + 1) * kRayBlock, sheet_.faces.size());
    for (std::size_t f = block * kRayBlock; f < end; ++f) {
      const auto& [a, b, c] = sheet_.faces[f];
      auto hit = meets(sheet_.position(a), sheet_.position(b), sheet_.position(c), origin, direction);
      if (hit && hit->distance > 0 && hit->distance < before) {
        before = hit->distance;
        hit->face = static_cast<Index>(f);
        best = hit;
      }
    }
  }
  return best;
}

}  // namespace graftsman
