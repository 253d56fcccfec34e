#include "widgets/variants/rounded_picture.h"

#include <QPainter>
#include <QPixmapCache>
#include <utility>

namespace graftsman {

QPainterPath roundedRect(const QRectF& rect, double radius) {
  QPainterPath path;
  path.addRoundedRect(rect, radius, radius);
  return path;
}

QPixmap roundedPicture(const QImage& picture, const QSize& size, double radius, double ratio) {
  const QString key =
      QStringLiteral("picture %1 %2 %3 %4").arg(picture.cacheKey()).arg(size.width()).arg(radius).arg(ratio);
  QPixmap pixmap;
  if (!QPixmapCache::find(key, &pixmap)) {
    const QSize pixels = (QSizeF(size) * ratio).toSize();
    QImage drawn(pixels, QImage::Format_ARGB32_Premultiplied);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(
        roundedRect(QRectF({}, QSizeF(pixels)), radius * ratio),
        QBrush(picture.scaled(pixels, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation)));
    painter.end();
    drawn.setDevicePixelRatio(ratio);
    pixmap = QPixmap::fromImage(std::move(drawn));
    QPixmapCache::insert(key, pixmap);
  }
  return pixmap;
}

}  // namespace graftsman
