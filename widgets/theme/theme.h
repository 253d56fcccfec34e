#pragma once

#include <QColor>
#include <QPalette>

#include "core/base/error.h"

namespace graftsman {

/// The colours that mean something: the part is warm, the base is cool, everywhere and only there. The frame
/// around them is the platform's palette.
struct Theme {
  bool dark = false;
  QColor part;
  QColor base;
  QColor loop;     // paths, and the seam of the result
  QColor problem;  // always with an icon or a text, never alone
  QColor selected;
  QColor mesh;
  QColor backgroundTop;  // of the panes' gradient
  QColor backgroundBottom;

  [[nodiscard]] const QColor& of(Side side) const { return side == Side::Part ? part : base; }
};

/// The colours that go with a palette, light or dark.
[[nodiscard]] Theme themeFor(const QPalette& palette);

/// The colour of a CV: a palette of 12 that colour-blind people can tell apart, repeated. Precondition:
/// number ≥ 0.
[[nodiscard]] QColor cvColour(int number);

/// Black or white, whichever is easier to read on `background`.
[[nodiscard]] QColor readableOn(const QColor& background);

/// Lengths of the interface, in device-independent pixels.
namespace sizes {
inline constexpr int kGrid = 8;
inline constexpr int kCVSphere = 9;
inline constexpr int kCVSphereHovered = 12;
inline constexpr int kHitArea = 16;
inline constexpr int kCurvePoint = 10;
inline constexpr int kLoopWidth = 2;
}  // namespace sizes

}  // namespace graftsman
