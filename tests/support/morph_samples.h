#pragma once

#include <QtTest>

#include "core/fusion/blend.h"
#include "core/fusion/verify.h"
#include "tests/support/samples.h"
#include "widgets/viewport/colouring_surface.h"
#include "widgets/viewport/morph_rays.h"
#include "widgets/viewport/morph_surface.h"
#include "widgets/viewport/ring_line.h"

namespace graftsman {

inline FCF curve(const std::vector<FCFPoint>& points) {
  return FCF::through(points).value();
}

inline FusionResults fuse(const FusionInputs& inputs) {
  FusionResults results = update(inputs, {}, {});
  if (results.error) {
    qFatal("%s", results.error->message.c_str());
  }
  return results;
}

inline const FusionResults& sample(const std::string& name) {
  static std::map<std::string, FusionResults> known;
  const auto [at, isNew] = known.try_emplace(name);
  if (isNew) {
    at->second = fuse(samples::load(name));
  }
  return at->second;
}

inline MorphSurface surfaceOf(const FusionResults& results) {
  return {results.join, results.combined, results.inputs.fcf};
}

inline void addSamples() {
  QTest::addColumn<QString>("name");
  for (const char* const name :
       {"fig4d_cone_sphere", "fig7_letters_bottle", "fig8b_cone_nose", "fig9a_cars", "fig9b_bird_plane"}) {
    QTest::newRow(name) << QString::fromLatin1(name);
  }
}

}  // namespace graftsman
