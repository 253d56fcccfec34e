#include "widgets/curve/curve_plot.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "widgets/theme/contrast.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr double kSpace = 6;   // between axis and label
constexpr double kMargin = 9;  // of the frame about the plot: a point on the plot's edge lies within
constexpr double kCurveWidth = 2;
constexpr double kHistogramShare = 0.55;  // of the plot's height, for the highest bar
constexpr double kCurveStep = 0.5;        // between two samples of the curve

QString partText() {
  return QStringLiteral("part 1");
}
QString baseText() {
  return QStringLiteral("base 0");
}
QString seamText() {
  return QStringLiteral("seam 0");
}
QString centreText() {
  return QStringLiteral("centre 1");
}

QString numbers(const FCFPoint& point, int decimals) {
  const QLocale locale;
  return QStringLiteral("s %1  f %2")
      .arg(locale.toString(point.s, 'f', decimals), locale.toString(point.f, 'f', decimals));
}

struct Colours {
  QColor ground;
  QColor text;
  QColor quietText;
  QColor grid;
  QColor bars;
  Theme theme;

  Colours(const QPalette& palette, bool enabled) : theme(themeFor(palette)) {
    const auto group = enabled ? QPalette::Active : QPalette::Disabled;
    ground = palette.color(group, QPalette::Base);
    text = palette.color(group, QPalette::Text);
    quietText = legible(mixed(text, ground, 0.35), palette.color(QPalette::Window));
    grid = mixed(ground, text, 0.12);
    bars = mixed(ground, text, theme.dark ? 0.2 : 0.16);
    theme.selected = palette.color(group, QPalette::Highlight);
  }
};

void paintGround(QPainter& painter, const CurvePlot& plot, const CurveLook& look, const Colours& colours) {
  const QRectF& area = plot.area;
  const QRectF frame = area.adjusted(-kMargin, -kMargin, kMargin, kMargin);
  painter.fillRect(frame, colours.ground);
  const double width = area.width() / kHistogramBins;
  for (std::size_t i = 0; i < look.histogram.size(); ++i) {
    const double height = look.histogram[i] * area.height() * kHistogramShare;
    painter.fillRect(QRectF(area.left() + static_cast<double>(i) * width, area.bottom() - height,
                            std::max(1.0, width - 1), height),
                     colours.bars);
  }
  painter.setPen(QPen(colours.grid, 1));
  for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const QPointF middle = plot.toWidget({at, at});
    painter.drawLine(QPointF(middle.x(), area.top()), QPointF(middle.x(), area.bottom()));
    painter.drawLine(QPointF(area.left(), middle.y()), QPointF(area.right(), middle.y()));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(look.focused ? QPen(colours.theme.selected, 2)
                              : QPen(mixed(colours.ground, colours.text, 0.3), 1));
  painter.drawRect(frame);
}

void paintAxes(QPainter& painter, const CurvePlot& plot, const CurveLook& look, const Colours& colours,
               const QPalette& palette) {
  const QColor window = palette.color(QPalette::Window);
  const QFontMetricsF metrics(painter.font());
  const QRectF& area = plot.area;
  const double height = metrics.height();
  const auto label = [&](const QString& text, const QColor& colour, double y) {
    painter.setPen(look.enabled ? legible(colour, window) : colours.quietText);
    painter.drawText(QRectF(0, y, area.left() - kMargin - kSpace, height), Qt::AlignRight | Qt::AlignVCenter,
                     text);
  };
  label(partText(), colours.theme.part, area.top() - height / 2);
  label(baseText(), colours.theme.base, area.bottom() - height / 2);
  painter.setPen(colours.quietText);
  const QRectF below(area.left(), area.bottom() + kMargin + kSpace / 2, area.width(), height);
  painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, seamText());
  painter.drawText(below, Qt::AlignRight | Qt::AlignTop, centreText());
}

void paintLine(QPainter& painter, const CurvePlot& plot, const CurveLook& look, const Colours& colours) {
  const auto steps = static_cast<int>(std::ceil(plot.area.width() / kCurveStep));
  QPolygonF line;
  line.reserve(steps + 1);
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    line.append(plot.toWidget({s, look.curve(s)}));
  }
  QLinearGradient warmToCool(plot.area.topLeft(), plot.area.bottomLeft());
  warmToCool.setColorAt(0, look.enabled ? colours.theme.part : colours.quietText);
  warmToCool.setColorAt(1, look.enabled ? colours.theme.base : colours.quietText);
  painter.setPen(QPen(QBrush(warmToCool), kCurveWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
}

void paintPoints(QPainter& painter, const CurvePlot& plot, const CurveLook& look, const Colours& colours) {
  const auto paint = [&](int i) {
    const FCFPoint& point = look.curve.points()[static_cast<std::size_t>(i)];
    const QPointF at = plot.toWidget(point);
    const bool selected = i == look.selected;
    const double radius = sizes::kCurvePoint / 2.0 + (i == look.hovered || i == look.moving ? 2 : 0);
    if (selected) {  // a ring as well: the highlight's colour alone would not tell
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(colours.theme.selected, 1.5));
      painter.drawEllipse(at, radius + 2.5, radius + 2.5);
    }
    painter.setBrush(selected ? colours.theme.selected : colours.ground);
    painter.setPen(QPen(selected ? colours.ground : colours.text, selected ? 1 : 1.75));
    painter.drawEllipse(at, radius - 0.75, radius - 0.75);
  };
  for (int i = 0; i < static_cast<int>(look.curve.points().size()); ++i) {
    if (i != look.selected) {
      paint(i);
    }
  }
  if (look.selected >= 0) {
    paint(look.selected);
  }
}

// A small box with text beside `at`, kept within the plot.
void paintNote(QPainter& painter, const CurvePlot& plot, const QPointF& at, const QString& text,
               const Colours& colours) {
  const QFontMetricsF metrics(painter.font());
  const QSizeF size(metrics.horizontalAdvance(text) + 12, metrics.height() + 6);
  constexpr double kAside = 14;
  QRectF box(at + QPointF(kAside, -kAside - size.height()), size);
  if (box.right() > plot.area.right() - 2) {
    box.moveRight(std::max(at.x() - kAside, plot.area.left() + 2 + size.width()));
  }
  if (box.top() < plot.area.top() + 2) {
    box.moveTop(at.y() + kAside);
  }
  box.moveBottom(std::min(box.bottom(), plot.area.bottom() - 2));
  painter.setPen(QPen(mixed(colours.ground, colours.text, 0.4), 1));
  painter.setBrush(colours.ground);
  painter.drawRoundedRect(box, 4, 4);
  painter.setPen(colours.text);
  painter.drawText(box, Qt::AlignCenter, text);
}

void paintGuide(QPainter& painter, const CurvePlot& plot, const CurveLook& look, const Colours& colours) {
  const FCFPoint on{*look.guide, look.curve(*look.guide)};
  const QPointF at = plot.toWidget(on);
  painter.setPen(QPen(mixed(colours.ground, colours.text, 0.6), 1));
  painter.drawLine(QPointF(at.x(), plot.area.top()), QPointF(at.x(), plot.area.bottom()));
  if (look.hovered < 0) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.text);
    painter.drawEllipse(at, 3, 3);
  }
}

}  // namespace

CurvePlot plotIn(const QSize& size, const QFont& font) {
  const QFontMetricsF metrics(font);
  const double label = std::max(metrics.horizontalAdvance(partText()), metrics.horizontalAdvance(baseText()));
  // Whole pixels, so that the frame's one-pixel lines are crisp.
  const double left = std::ceil(label + kSpace + kMargin);
  const double top = kMargin + 1;
  const double bottom = std::ceil(metrics.height() + kSpace / 2 + kMargin);
  return {QRectF(left, top, std::max(1.0, size.width() - left - kMargin - 1),
                 std::max(1.0, size.height() - top - bottom))};
}

QSize leastPlotSize(const QFont& font) {
  const QFontMetricsF metrics(font);
  return {static_cast<int>(std::ceil(metrics.horizontalAdvance(seamText() + centreText() + partText()))) + 70,
          static_cast<int>(std::ceil(metrics.height() * 2)) + 80};
}

std::vector<double> histogramOf(std::span<const double> s) {
  std::vector<double> counts(kHistogramBins, 0.0);
  for (const double value : s) {
    const double bin = std::clamp(value, 0.0, 1.0) * kHistogramBins;
    counts[std::min<std::size_t>(static_cast<std::size_t>(bin), kHistogramBins - 1)] += 1;
  }
  const double greatest = *std::max_element(counts.begin(), counts.end());
  if (greatest == 0) {
    return {};
  }
  for (double& count : counts) {
    count = std::sqrt(count / greatest);
  }
  return counts;
}

void paintCurve(QPainter& painter, const CurvePlot& plot, const CurveLook& look, const QPalette& palette) {
  const Colours colours(palette, look.enabled);
  painter.setRenderHint(QPainter::Antialiasing, false);
  paintGround(painter, plot, look, colours);
  painter.setRenderHint(QPainter::Antialiasing);
  paintAxes(painter, plot, look, colours, palette);
  paintLine(painter, plot, look, colours);
  if (look.guide) {
    paintGuide(painter, plot, look, colours);
  }
  paintPoints(painter, plot, look, colours);
  if (look.moving >= 0) {
    const FCFPoint& point = look.curve.points()[static_cast<std::size_t>(look.moving)];
    paintNote(painter, plot, plot.toWidget(point), numbers(point, 3), colours);
  } else if (look.guide) {
    const FCFPoint on{*look.guide, look.curve(*look.guide)};
    paintNote(painter, plot, plot.toWidget(on), numbers(on, 2), colours);
  }
}

}  // namespace graftsman
