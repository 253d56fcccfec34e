#include "widgets/viewport/morph_mapper.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

namespace graftsman {
namespace {

// DISABLE_SHIFT_SCALE, which belongs to another class in VTK 9.3 than in 9.1.
constexpr int kNoShiftScale = 0;

}  // namespace

vtkStandardNewMacro(MorphMapper);

MorphMapper::MorphMapper() {
  // Positions are relative to the middle already; anything else would copy them on every change.
  SetVBOShiftScaleMethod(kNoShiftScale);
}

void MorphMapper::setBox(const Eigen::AlignedBox3d& box) {
  box_ = box;
  Modified();
}

void MorphMapper::ComputeBounds() {
  if (box_.isEmpty()) {
    vtkMath::UninitializeBounds(Bounds);
    return;
  }
  for (int k = 0; k < 3; ++k) {
    Bounds[2 * k] = box_.min()[k];
    Bounds[2 * k + 1] = box_.max()[k];
  }
}

}  // namespace graftsman
