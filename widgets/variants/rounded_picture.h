#pragma once

#include <QImage>
#include <QPainterPath>
#include <QPixmap>

namespace graftsman {

/// A rectangle whose corners are rounded by `radius`.
[[nodiscard]] QPainterPath roundedRect(const QRectF& rect, double radius);

/// The picture filling `size` (device-independent pixels) at this pixel ratio, its corners rounded by
/// `radius`. Made once and kept in the QPixmapCache.
[[nodiscard]] QPixmap roundedPicture(const QImage& picture, const QSize& size, double radius, double ratio);

}  // namespace graftsman
