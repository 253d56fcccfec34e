#pragma once

#include <QFont>
#include <QPalette>
#include <QRectF>
#include <optional>
#include <span>
#include <vector>

#include "core/fusion/fcf.h"

class QPainter;

namespace graftsman {

/// Where the fusion curve's axes lie in a widget: s to the right, f upwards. Device-independent pixels.
struct CurvePlot {
  QRectF area;  // s and f from 0 to 1

  [[nodiscard]] QPointF toWidget(const FCFPoint& point) const {
    return {area.left() + point.s * area.width(), area.bottom() - point.f * area.height()};
  }
  /// May lie outside [0, 1].
  [[nodiscard]] FCFPoint toCurve(const QPointF& at) const {
    return {(at.x() - area.left()) / area.width(), (area.bottom() - at.y()) / area.height()};
  }
};

/// The plot in a widget of that size, with room for the axes' labels.
[[nodiscard]] CurvePlot plotIn(const QSize& size, const QFont& font);
/// The least size in which the plot can be worked with.
[[nodiscard]] QSize leastPlotSize(const QFont& font);

/// Number of bars of the histogram of s.
inline constexpr int kHistogramBins = 48;

/// How many of `s` fall in each of kHistogramBins equal parts of [0, 1], as bar heights in [0, 1]: square
/// roots of the counts over the greatest one, so that small counts show. Empty without any s.
[[nodiscard]] std::vector<double> histogramOf(std::span<const double> s);

/// What is drawn.
struct CurveLook {
  const FCF& curve;
  const std::vector<double>& histogram;  // bar heights, or empty
  int selected = -1;
  int hovered = -1;
  int moving = -1;              // its numbers are shown beside it
  std::optional<double> guide;  // s of the vertical line under the pointer
  bool focused = false;
  bool enabled = true;
};

void paintCurve(QPainter& painter, const CurvePlot& plot, const CurveLook& look, const QPalette& palette);

}  // namespace graftsman
