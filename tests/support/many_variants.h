#pragma once

#include <memory>
#include <string>

#include "core/project/document_edits.h"
#include "core/project/project_file.h"
#include "tests/support/documents.h"
#include "tests/support/shapes.h"

/// A project with many variants of a large fusion.
namespace graftsman::samples {

/// The cone on the head, whose triangles are divided in four: 112k faces. The sample's vertices keep their
/// numbers.
inline Fusion largeFusion() {
  Fusion large = fusion("fig8b_cone_nose");
  const TriangleMesh& base = *large.inputs.base;
  auto [points, faces] = shapes::subdivided(base.points(), base.faces());
  setAsset(large, Side::Base,
           std::make_shared<const MeshAsset>(
               MeshAsset{"head.obj",
                         "head.obj",
                         {},
                         std::make_shared<const TriangleMesh>(std::move(points), std::move(faces))}));
  return large;
}

/// Each with a curve of its own, a note, and every third with a loop of its own.
inline Project manyVariants(int count) {
  Project project;
  Fusion large = largeFusion();
  project.document = documentOf(large);
  for (int i = 0; i < count; ++i) {
    const double f = static_cast<double>(i) / count;
    large.inputs.fcf = *FCF::through({{0, 0}, {0.2, f}, {0.6, 1 - f / 2}, {1, f}}, true);
    if (i % 3 == 0) {
      std::rotate(large.inputs.loop.begin(), large.inputs.loop.begin() + 1, large.inputs.loop.end());
    }
    project.document = edits::addVariant(edits::withFusion(std::move(project.document), large), large.id);
    Variant noted = *project.document.variants.back();
    noted.note = "Between paste and keep, step " + std::to_string(i);
    project.document = edits::withVariant(std::move(project.document), std::move(noted));
  }
  return project;
}

}  // namespace graftsman::samples
