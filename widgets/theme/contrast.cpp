#include "widgets/theme/contrast.h"

#include <algorithm>
#include <cmath>

namespace graftsman {
namespace {

constexpr double kReadable = 4.5;  // WCAG 2.1, level AA, text of ordinary size

double luminance(const QColor& colour) {
  const auto linear = [](double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

}  // namespace

double contrast(const QColor& a, const QColor& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

QColor legible(const QColor& colour, const QColor& background) {
  constexpr int kSteps = 20;
  const QColor black(Qt::black);
  const QColor white(Qt::white);
  const QColor& far = contrast(black, background) > contrast(white, background) ? black : white;
  for (int i = 0; i < kSteps; ++i) {
    const QColor tried = mixed(colour, far, static_cast<double>(i) / kSteps);
    if (contrast(tried, background) >= kReadable) {
      return tried;
    }
  }
  return far;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto channel = [share](int from, int to) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  return {channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue())};
}

}  // namespace graftsman
