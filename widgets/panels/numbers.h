#pragma once

#include <QString>

namespace graftsman {

/// A number with that many significant digits, as the locale writes it, trailing zeros kept ("0.3100" for
/// 0.31 and 4 digits); digits left of the point are never dropped. Exponents below 1e-5 and from 1e9 on.
/// Precondition: digits ≥ 1.
[[nodiscard]] QString significant(double value, int digits);

}  // namespace graftsman
