#include "widgets/viewport/colouring_legend.h"

#include <QLinearGradient>
#include <QLocale>
#include <QObject>
#include <QPainter>
#include <QPalette>
#include <QStringList>
#include <algorithm>

namespace graftsman {
namespace {

constexpr double kBarWidth = 168;
constexpr double kBarHeight = 10;
constexpr double kSwatch = 12;
constexpr int kBarSteps = 10;
constexpr double kGap = 4;

QString degrees(double angle) {
  return QLocale().toString(angle, 'f', angle < 10 ? 1 : 0) + QStringLiteral("°");
}

QString counted(const QString& what, Index count) {
  return QObject::tr("%1: %2 vertices").arg(what, QLocale().toString(count));
}

// A tick every `step` degrees up to `greatest`.
void addDegrees(Legend& legend, double greatest, double step, Rgba colourOf(double)) {
  for (int i = 0; i <= kBarSteps; ++i) {
    legend.bar.push_back(toQColor(colourOf(greatest * i / kBarSteps)));
  }
  for (double angle = 0; angle <= greatest; angle += step) {
    legend.ticks.emplace_back(angle / greatest, QLocale().toString(angle, 'f', 0) + QStringLiteral("°"));
  }
}

/// What a legend takes, and where its rows begin.
class Plan {
 public:
  Plan(const Legend& legend, const QFontMetricsF& metrics) : metrics_(metrics) {
    double width = metrics.horizontalAdvance(legend.title);
    double height = metrics.height();
    if (!legend.bar.empty()) {
      const double sides = metrics.horizontalAdvance(legend.ticks.front().second) / 2 +
                           metrics.horizontalAdvance(legend.ticks.back().second) / 2;
      width = std::max(width, kBarWidth + sides);
      height += kGap + kBarHeight + metrics.height();
    }
    for (const auto& [colour, text] : legend.swatches) {
      width = std::max(width, kSwatch + sizes::kGrid + metrics.horizontalAdvance(text));
      height += metrics.height() + kGap;
    }
    if (!legend.note.isEmpty()) {
      width = std::max(width, metrics.horizontalAdvance(legend.note));
      height += kGap + metrics.height();
    }
    size_ = {width + 2 * sizes::kGrid, height + 2 * sizes::kGrid};
  }

  [[nodiscard]] QSizeF size() const { return size_; }
  [[nodiscard]] const QFontMetricsF& metrics() const { return metrics_; }

 private:
  QFontMetricsF metrics_;
  QSizeF size_;
};

double paintBar(QPainter& painter, const Legend& legend, const QPointF& at, const QFontMetricsF& metrics,
                const QColor& text) {
  const double left = at.x() + metrics.horizontalAdvance(legend.ticks.front().second) / 2;
  const QRectF bar(left, at.y() + kGap, kBarWidth, kBarHeight);
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (std::size_t i = 0; i < legend.bar.size(); ++i) {
    gradient.setColorAt(static_cast<double>(i) / static_cast<double>(legend.bar.size() - 1), legend.bar[i]);
  }
  painter.fillRect(bar, gradient);
  painter.setPen(text);
  for (const auto& [place, label] : legend.ticks) {
    const double x = bar.left() + place * bar.width();
    const QRectF box(x - kBarWidth, bar.bottom(), 2 * kBarWidth, metrics.height());
    painter.drawText(box, Qt::AlignCenter, label);
  }
  return bar.bottom() + metrics.height();
}

}  // namespace

QString Legend::text() const {
  QStringList parts = {title};
  for (const auto& [place, label] : ticks) {
    parts << label;
  }
  for (const auto& [colour, label] : swatches) {
    parts << label;
  }
  parts << note;
  parts.removeAll(QString());
  return parts.join(QStringLiteral(", "));
}

Legend legendOf(const SurfaceColours& colours, const Theme& theme) {
  const ColouringNumbers& numbers = colours.numbers();
  using Origin = SurfaceColours::Origin;
  const auto ofOrigin = [&theme](Origin origin) { return toQColor(SurfaceColours::ofOrigin(origin, theme)); };
  Legend legend;
  switch (colours.colouring()) {
    case Colouring::Plain:
      break;
    case Colouring::FusionCurve:
      legend.title = QObject::tr("Fusion curve f");
      for (int i = 0; i <= kBarSteps; ++i) {
        legend.bar.push_back(toQColor(mixed(rgba(theme.base), rgba(theme.part), i / float{kBarSteps})));
      }
      legend.ticks = {{0, QObject::tr("0 base")}, {0.5, QLocale().toString(0.5)}, {1, QObject::tr("1 part")}};
      break;
    case Colouring::Origin:
      legend.title = QObject::tr("Origin of the vertices");
      legend.swatches = {{theme.mesh, QObject::tr("rest of the base")},
                         {ofOrigin(Origin::Base), counted(QObject::tr("base"), numbers.baseVertices)},
                         {ofOrigin(Origin::Part), counted(QObject::tr("part"), numbers.partVertices)},
                         {ofOrigin(Origin::Both), counted(QObject::tr("both"), numbers.commonVertices)}};
      break;
    case Colouring::SeamAngle:
      legend.title = QObject::tr("Angle of the normals across the seam");
      addDegrees(legend, SurfaceColours::kGreatestSeamAngle, 30, SurfaceColours::ofSeamAngle);
      legend.note = QObject::tr("mean %1, greatest %2")
                        .arg(degrees(numbers.meanSeamAngle), degrees(numbers.greatestSeamAngle));
      break;
    case Colouring::Quality:
      legend.title = QObject::tr("Smallest angle of each triangle");
      addDegrees(legend, SurfaceColours::kGreatestSmallestAngle, 20, SurfaceColours::ofSmallestAngle);
      legend.note = QObject::tr("smallest of all %1").arg(degrees(numbers.smallestAngle));
      break;
  }
  return legend;
}

QRectF paintLegend(QPainter& painter, const Legend& legend, const QRectF& pane, const QPalette& palette) {
  if (legend.title.isEmpty()) {
    return {};
  }
  const Plan plan(legend, QFontMetricsF(painter.font(), painter.device()));
  const QSizeF size = plan.size();
  const QRectF plate(pane.left() + sizes::kGrid, pane.bottom() - sizes::kGrid - size.height(), size.width(),
                     size.height());
  if (!pane.contains(plate)) {
    return {};
  }
  QColor background = palette.color(QPalette::Window);
  background.setAlphaF(0.9F);
  painter.fillRect(plate, background);
  const QColor text = palette.color(QPalette::WindowText);
  const QFontMetricsF& metrics = plan.metrics();
  const double left = plate.left() + sizes::kGrid;
  double y = plate.top() + sizes::kGrid;
  const auto line = [&](double x, const QString& words) {
    painter.setPen(text);
    painter.drawText(QPointF(x, y + metrics.ascent()), words);
    y += metrics.height();
  };
  line(left, legend.title);
  if (!legend.bar.empty()) {
    y = paintBar(painter, legend, {left, y}, metrics, text);
  }
  for (const auto& [colour, label] : legend.swatches) {
    y += kGap;
    const QRectF swatch(left, y + (metrics.height() - kSwatch) / 2, kSwatch, kSwatch);
    painter.fillRect(swatch, colour);
    painter.setPen(text);
    painter.drawRect(swatch.adjusted(0.5, 0.5, -0.5, -0.5));
    line(left + kSwatch + sizes::kGrid, label);
  }
  if (!legend.note.isEmpty()) {
    y += kGap;
    line(left, legend.note);
  }
  return plate;
}

}  // namespace graftsman
