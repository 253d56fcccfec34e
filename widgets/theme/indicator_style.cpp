#include "widgets/theme/indicator_style.h"

#include <QApplication>
#include <QPainter>
#include <QStyleOption>

#include "widgets/theme/contrast.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr auto kFusion = "fusion";

// Of the text's colour in a frame, the rest is the window's: about 4 : 1 on a dark window, the least being 3
// : 1 (WCAG 2.1, 1.4.11), and less than 2 : 1 where nothing can be ticked.
constexpr double kFrame = 0.5;
constexpr double kDisabledFrame = 0.2;

QColor frameColour(const QStyleOption& option) {
  const QPalette& palette = option.palette;
  if (!option.state.testFlag(QStyle::State_Enabled)) {
    return mixed(palette.color(QPalette::Window), palette.color(QPalette::Active, QPalette::WindowText),
                 kDisabledFrame);
  }
  const bool marked = option.state.testFlag(QStyle::State_HasFocus) &&
                      option.state.testFlag(QStyle::State_KeyboardFocusChange);
  return marked ? palette.color(QPalette::Highlight).lighter()
                : mixed(palette.color(QPalette::Window), palette.color(QPalette::WindowText), kFrame);
}

}  // namespace

IndicatorStyle::IndicatorStyle() : QProxyStyle(kFusion) {}

void IndicatorStyle::install() {
  if (QApplication::style()->name() == kFusion) {
    QApplication::setStyle(new IndicatorStyle);
  }
}

void IndicatorStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                   const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  const bool isBox = element == PE_IndicatorCheckBox;
  if ((!isBox && element != PE_IndicatorRadioButton) || !themeFor(option->palette).dark) {
    return;
  }
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(frameColour(*option));
  painter->setBrush(Qt::NoBrush);
  // Where Fusion has its own.
  if (isBox) {
    painter->drawRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5));
  } else {
    const int width = option->rect.width();
    const double radius = (width + (width + 1) % 2) / 2.0 - 1;
    painter->drawEllipse(QPointF(option->rect.center() + QPoint(1, 1)), radius, radius);
  }
  painter->restore();
}

}  // namespace graftsman
