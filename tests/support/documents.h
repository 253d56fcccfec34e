#pragma once

#include "core/project/document.h"
#include "tests/support/samples.h"

/// Documents of the sample scenarios, for tests.
namespace graftsman::samples {

inline Document document(const std::string& name) {
  Document document;
  document.inputs = load(name);
  document.part = std::make_shared<const MeshAsset>(MeshAsset{"part", "part.obj", {}, document.inputs.part});
  document.base = std::make_shared<const MeshAsset>(MeshAsset{"base", "base.obj", {}, document.inputs.base});
  document.closed = true;
  return document;
}

}  // namespace graftsman::samples
