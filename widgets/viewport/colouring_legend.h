#pragma once

#include <QColor>
#include <QString>
#include <utility>
#include <vector>

#include "widgets/viewport/colouring_surface.h"

class QPainter;
class QPalette;
class QRectF;

namespace graftsman {

/// What the colours mean, in words and numbers.
struct Legend {
  QString title;                                     // empty: there is nothing to explain
  std::vector<QColor> bar;                           // a scale's colours from left to right; empty: none
  std::vector<std::pair<double, QString>> ticks;     // below the bar; the place on it in [0, 1]
  std::vector<std::pair<QColor, QString>> swatches;  // a line each
  QString note;

  /// All of it as one sentence after the other.
  [[nodiscard]] QString text() const;
};

[[nodiscard]] Legend legendOf(const SurfaceColours& colours, const Theme& theme);

/// Paints the legend into the bottom left corner of the pane: on a plate of the palette's window colour, in
/// the painter's font. Returns where; empty if there is no room or nothing to explain.
QRectF paintLegend(QPainter& painter, const Legend& legend, const QRectF& pane, const QPalette& palette);

}  // namespace graftsman
