#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A surface that turns from one shape into another.
struct GlbMorph {
  std::span<const Point> base;  // V×3; positions at weight 0
  std::span<const Point> part;  // V×3; positions at weight 1
  std::span<const Face> faces;  // F×3, F ≥ 1
  double weight = 0;            // that a viewer shows at first
  std::string name = "combined tile";
};

/// Writes a binary glTF 2.0 file: one mesh with the base's shape and one morph target, "part", with positions
/// and area-weighted normals for both, and one animation, "morph", whose weight goes from 0 to 1 and back to
/// 0 in four seconds. glTF holds floats: positions are stored relative to the centre of the shapes' box,
/// which is the node's translation, so that a model far from the origin keeps its shape. Atomic. Errors:
/// MeshEmpty, FileUnwritable (also: too many vertices for the format's 4 GiB, or a size that floats cannot
/// hold). Precondition: equally many positions of both, every index below that.
[[nodiscard]] Result<void> writeGlb(const std::filesystem::path& path, const GlbMorph& morph);

}  // namespace graftsman
