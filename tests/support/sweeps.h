#pragma once

#include <QtTest>

#include "core/base/parallel.h"
#include "core/io/mesh_file.h"
#include "core/sweep/sweep_folder.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"

namespace graftsman {

inline SweepCurve preset(FCF::Preset which) {
  return {std::string(name(which)), FCF::preset(which)};
}

// Two curves, two falloffs, three shifts on the small cone and sphere: twelve combinations.
inline Sweep smallSweep() {
  Sweep sweep;
  sweep.base = samples::load("fig4a_cone_sphere");
  sweep.curves = {preset(FCF::Preset::Paste), preset(FCF::Preset::KeepBaseSlope)};
  sweep.falloffs = {2, 5};
  sweep.shifts = {0, 1, -2};
  return sweep;
}

}  // namespace graftsman
