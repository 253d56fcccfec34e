#include "widgets/theme/theme.h"

#include <array>

namespace graftsman {

Theme themeFor(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightness() < 128;
  Theme theme;
  theme.dark = dark;
  theme.part = QColor(dark ? "#F09A5E" : "#E07B39");
  theme.base = QColor(dark ? "#6FB1D3" : "#3B7EA1");
  theme.loop = QColor(dark ? "#F2F2F2" : "#2B2B2B");
  theme.problem = QColor(dark ? "#F0718A" : "#C4314B");
  theme.selected = palette.color(QPalette::Highlight);
  theme.mesh = QColor::fromRgbF(dark ? 0.62F : 0.78F, dark ? 0.62F : 0.78F, dark ? 0.62F : 0.78F);
  theme.backgroundTop = QColor(dark ? "#3A3D42" : "#F4F6F8");
  theme.backgroundBottom = QColor(dark ? "#232528" : "#D9DEE3");
  return theme;
}

QColor cvColour(int number) {
  // Paul Tol's "muted" scheme (nine) and three of his "bright" one that differ from all of those.
  static constexpr std::array<const char*, 12> kColours = {"#CC6677", "#332288", "#DDCC77", "#117733",
                                                           "#88CCEE", "#882255", "#44AA99", "#999933",
                                                           "#AA4499", "#4477AA", "#EE6677", "#66CCEE"};
  return {kColours[static_cast<std::size_t>(number) % kColours.size()]};
}

QColor readableOn(const QColor& background) {
  return background.lightnessF() * 0.4 +
                     (0.299 * background.redF() + 0.587 * background.greenF() + 0.114 * background.blueF()) *
                         0.6 >
                 0.55
             ? QColor(Qt::black)
             : QColor(Qt::white);
}

}  // namespace graftsman
