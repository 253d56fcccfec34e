#pragma once

#include "core/project/document.h"
#include "tests/support/samples.h"

/// Documents of the sample scenarios, for tests.
namespace graftsman::samples {

/// The document of one fusion.
inline Document documentOf(const Fusion& fusion) {
  return {{std::make_shared<const Fusion>(fusion)}, {}};
}

inline Fusion fusion(const std::string& name) {
  Fusion fusion;
  fusion.inputs = load(name);
  fusion.part = std::make_shared<const MeshAsset>(MeshAsset{"part", "part.obj", {}, fusion.inputs.part});
  fusion.base = std::make_shared<const MeshAsset>(MeshAsset{"base", "base.obj", {}, fusion.inputs.base});
  fusion.closed = true;
  return fusion;
}

}  // namespace graftsman::samples
