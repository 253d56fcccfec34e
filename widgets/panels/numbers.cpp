#include "widgets/panels/numbers.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace graftsman {

QString significant(double value, int digits) {
  const QLocale locale;
  const double size = std::abs(value);
  if (size == 0 || !std::isfinite(value)) {
    return locale.toString(value, 'f', 0);
  }
  if (size < 1e-5 || size >= 1e9) {
    return locale.toString(value, 'e', digits - 1);
  }
  const auto decimals = [digits](double magnitude) {
    return std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(magnitude))));
  };
  // Rounding may carry into another digit: 0.9996 is 1.00, not 1.000.
  const double unit = std::pow(10, -decimals(size));
  return locale.toString(value, 'f', decimals(std::round(size / unit) * unit));
}

}  // namespace graftsman
