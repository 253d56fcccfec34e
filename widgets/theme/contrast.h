#pragma once

#include <QColor>

namespace graftsman {

/// Contrast of two opaque colours after WCAG 2.1: from 1 (the same) to 21 (black on white).
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

/// `colour`, made darker or lighter until it can be read as text on `background` (4.5 : 1); as it is where it
/// can be already.
[[nodiscard]] QColor legible(const QColor& colour, const QColor& background);

/// `share` of b, the rest of a. Precondition: 0 ≤ share ≤ 1.
[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, double share);

}  // namespace graftsman
