#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/fusion/update.h"
#include "core/io/mesh_file.h"

namespace graftsman {

/// A mesh of a document, with where it came from. Immutable and shared: states of a document, undo steps and
/// variants cost no copy of it.
struct MeshAsset {
  std::string name;              // as shown: the file's name at first
  std::filesystem::path source;  // of the file it was read from; may be gone by now
  ReadReport report;             // what reading did to it
  std::shared_ptr<const TriangleMesh> mesh;
};

/// Everything that a person edits and a project file keeps. A value, cheap to copy.
struct Document {
  std::shared_ptr<const MeshAsset> part;  // null: not loaded yet
  std::shared_ptr<const MeshAsset> base;
  bool closed = false;  // the loop is complete: CV n−1 is joined to CV 0. An open loop is not fused
  FusionInputs inputs;  // `part` and `base` in it are the assets' meshes

  [[nodiscard]] const std::shared_ptr<const MeshAsset>& of(Side side) const {
    return side == Side::Part ? part : base;
  }
  /// The same edit state: equal values, the very same meshes.
  friend bool operator==(const Document& a, const Document& b);
};

/// Equal values and the very same meshes.
[[nodiscard]] bool same(const FusionInputs& a, const FusionInputs& b);

}  // namespace graftsman
