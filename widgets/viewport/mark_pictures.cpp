#include "widgets/viewport/mark_pictures.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRadialGradient>
#include <cmath>

namespace graftsman {
namespace {

constexpr double kHalo = 1.25;  // of white, between a mark and whatever colour is behind it

QImage blank(const QSizeF& size, double ratio) {
  // An odd number of pixels has a middle one.
  const auto pixels = [&](double length) { return static_cast<int>(std::ceil(length * ratio)) | 1; };
  QImage image(pixels(size.width()), pixels(size.height()), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  image.setDevicePixelRatio(ratio);
  return image;
}

/// Draws with the origin in the middle of the image.
template <class Draw>
void drawOn(QImage& image, Draw draw) {
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QSizeF size = image.deviceIndependentSize();
  painter.translate(size.width() / 2, size.height() / 2);
  draw(painter);
}

void drawCircle(QPainter& painter, double radius, const QColor& colour, double width) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, width));
  painter.drawEllipse(QPointF(), radius, radius);
}

void drawDisk(QPainter& painter, double radius, const QBrush& brush) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(brush);
  painter.drawEllipse(QPointF(), radius, radius);
}

}  // namespace

void MarkPictures::prepare(const Theme& theme, const QFont& font, double ratio) {
  const bool same =
      ratio == ratio_ && font == font_ && theme.dark == theme_.dark && theme.selected == theme_.selected;
  if (!same) {
    theme_ = theme;
    font_ = font;
    ratio_ = ratio;
    pictures_.clear();
  }
}

template <class Draw>
QImage MarkPictures::kept(const QString& key, const QSizeF& size, Draw draw) {
  const auto found = pictures_.constFind(key);
  if (found != pictures_.constEnd()) {
    return *found;
  }
  QImage image = blank(size, ratio_);
  drawOn(image, draw);
  return *pictures_.insert(key, image);
}

QImage MarkPictures::sphere(const MarkLook& look) {
  const QString key = QString("sphere %1 %2%3%4%5")
                          .arg(look.number)
                          .arg(look.hollow)
                          .arg(look.selected)
                          .arg(look.problem)
                          .arg(look.hovered);
  return kept(key, {36, 36}, [&](QPainter& painter) {
    const double radius = (look.hovered ? sizes::kCVSphereHovered : sizes::kCVSphere) / 2.0;
    const QColor colour = cvColour(look.number);
    double outside = radius + kHalo;
    if (look.problem) {
      drawCircle(painter, outside + 1.5, Qt::white, 4);
      drawCircle(painter, outside + 1.5, theme_.problem, 2);
      outside += 3.5;
    }
    if (look.selected) {
      drawCircle(painter, outside + 2, Qt::white, 4);
      drawCircle(painter, outside + 2, theme_.selected, 2.5);
    }
    if (look.hollow) {
      drawCircle(painter, radius - 1, Qt::white, 2 + 2 * kHalo);
      drawCircle(painter, radius - 1, colour, 2.25);
      return;
    }
    drawDisk(painter, radius + kHalo, QColor(Qt::white));
    QRadialGradient shine(QPointF(-0.35 * radius, -0.4 * radius), 1.5 * radius);
    shine.setColorAt(0, colour.lighter(135));
    shine.setColorAt(0.45, colour);
    shine.setColorAt(1, colour.darker(150));
    drawDisk(painter, radius, shine);
  });
}

QImage MarkPictures::label(const MarkLook& look) {
  const QString text = QString::number(look.number) + (look.problem ? " !" : "");
  return pill("label " + text, text, look.problem);
}

QImage MarkPictures::problemSign() {
  return pill("sign", "!", true);
}

QImage MarkPictures::pill(const QString& key, const QString& text, bool problem) {
  QFont bold = font_;
  bold.setBold(true);
  const QFontMetricsF metrics(bold);
  const double height = std::ceil(metrics.height()) - 1;
  const double width = std::max(height, std::ceil(metrics.horizontalAdvance(text)) + 8);
  return kept(key, {width + 2, height + 2}, [&](QPainter& painter) {
    QColor ground = problem ? theme_.problem : QColor(theme_.dark ? "#1D1F22" : "#FFFFFF");
    const QColor ink = readableOn(ground);
    ground.setAlphaF(problem ? 1.0F : 0.86F);
    const QRectF box(-width / 2, -height / 2, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, height / 2, height / 2);
    painter.setFont(bold);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, text);
  });
}

QImage MarkPictures::dot(bool ringed) {
  return kept(ringed ? "ringed dot" : "dot", {24, 24}, [&](QPainter& painter) {
    drawDisk(painter, 4, QColor(Qt::white));
    drawDisk(painter, 2.75, QColor("#2B2B2B"));
    if (ringed) {
      drawCircle(painter, 8, Qt::white, 4);
      drawCircle(painter, 8, theme_.selected, 2);
    }
  });
}

QImage MarkPictures::ring(double radius, double opacity) const {
  QImage image = blank({2 * radius + 6, 2 * radius + 6}, ratio_);
  drawOn(image, [&](QPainter& painter) {
    painter.setOpacity(opacity);
    drawCircle(painter, radius, Qt::white, 4.5);
    drawCircle(painter, radius, theme_.selected, 2.5);
  });
  return image;
}

}  // namespace graftsman
