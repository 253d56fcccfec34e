#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/fusion/update.h"
#include "core/io/mesh_file.h"

namespace graftsman {

/// Number of a fusion of a document, from 1 on, never given twice; 0: none.
using FusionId = int;

/// A mesh of a document, with where it came from. Immutable and shared: states of a document, undo steps and
/// variants cost no copy of it.
struct MeshAsset {
  std::string name;                          // as shown: the file's name at first
  std::filesystem::path source;              // of the file it was read from; may be gone by now
  ReadReport report;                         // what reading did to it
  std::shared_ptr<const TriangleMesh> mesh;  // null: a result that is not computed yet
  FusionId result = 0;  // of which fusion this mesh is the result; 0: it was read from a file
};

/// Whether both stand for the same mesh: the very same, or a result of the same fusion, whatever its state.
[[nodiscard]] bool same(const std::shared_ptr<const MeshAsset>& a, const std::shared_ptr<const MeshAsset>& b);

/// Everything that a person edits of one fusion. A value, cheap to copy.
///
/// A part or base that is another fusion's result changes as that one does. What is kept of it is which
/// fusion it is of, and of each CV on it where it was picked (SurfacePoint::place); its mesh and the CVs'
/// numbers are those of the state that was resolved last (core/project/evaluate.h) and count for nothing in
/// comparisons and files.
struct Fusion {
  FusionId id = 1;
  std::string name;                       // as a person named it; empty: see label()
  std::shared_ptr<const MeshAsset> part;  // null: not loaded yet
  std::shared_ptr<const MeshAsset> base;
  bool closed = false;  // the loop is complete: CV n−1 is joined to CV 0. An open loop is not fused
  FusionInputs inputs;  // `part` and `base` in it are the assets' meshes

  [[nodiscard]] const std::shared_ptr<const MeshAsset>& of(Side side) const {
    return side == Side::Part ? part : base;
  }
  /// The fusion whose result is the part or base; 0: it is a mesh of its own, or missing.
  [[nodiscard]] FusionId upstream(Side side) const { return of(side) ? of(side)->result : 0; }
  /// The same edit state: equal values, the same meshes.
  friend bool operator==(const Fusion& a, const Fusion& b);
};

/// Puts the asset on that side, its mesh with it.
void setAsset(Fusion& fusion, Side side, std::shared_ptr<const MeshAsset> asset);

/// "Nose", or for a fusion without a name "cone on head", "Fusion 2".
[[nodiscard]] std::string label(const Fusion& fusion);

/// Equal values and the very same meshes.
[[nodiscard]] bool same(const FusionInputs& a, const FusionInputs& b);

}  // namespace graftsman
