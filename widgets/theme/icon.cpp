#include "widgets/theme/icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <optional>
#include <utility>

// A static library's resources are linked in only where something asks for them. Not within a namespace: the
// macro declares a function.
static void readyResources() {
  Q_INIT_RESOURCE(graftsman);
}

namespace graftsman {
namespace {

QString pathOf(const QString& name) {
  readyResources();
  const QString path = QStringLiteral(":/graftsman/icons/%1.svg").arg(name);
  return QFile::exists(path) ? path : QString();
}

QColor paletteColour(QIcon::Mode mode) {
  const QPalette palette = QGuiApplication::palette();
  switch (mode) {
    case QIcon::Disabled:
      return palette.color(QPalette::Disabled, QPalette::WindowText);
    case QIcon::Selected:
      return palette.color(QPalette::Active, QPalette::HighlightedText);
    default:
      return palette.color(QPalette::Active, QPalette::WindowText);
  }
}

QPixmap render(QSvgRenderer& svg, const QSize& size) {
  QPixmap drawn(size);
  drawn.fill(Qt::transparent);
  if (!size.isEmpty()) {
    svg.setAspectRatioMode(Qt::KeepAspectRatio);
    QPainter painter(&drawn);
    svg.render(&painter, QRectF(drawn.rect()));
  }
  return drawn;
}

// Draws an SVG's shapes in a single colour. The colour is looked up at each drawing, so that icons follow a
// change from light to dark.
class TintedIcon : public QIconEngine {
 public:
  TintedIcon(QString path, std::optional<QColor> colour) : path_(std::move(path)), colour_(colour) {}

  [[nodiscard]] QIconEngine* clone() const override { return new TintedIcon(*this); }
  QString key() const override { return QStringLiteral("GraftsmanTintedIcon"); }
  bool isNull() override { return false; }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const double ratio = painter->device() ? painter->device()->devicePixelRatioF() : 1;
    QPixmap drawn = pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state);
    drawn.setDevicePixelRatio(ratio);
    painter->drawPixmap(rect, drawn);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/) override {
    const bool own = colour_ && (mode == QIcon::Normal || mode == QIcon::Active);
    const QColor colour = own ? *colour_ : paletteColour(mode);
    const QString key = QStringLiteral("%1 %2×%3 %4")
                            .arg(path_)
                            .arg(size.width())
                            .arg(size.height())
                            .arg(colour.rgba(), 8, 16, QLatin1Char('0'));
    QPixmap drawn;
    if (!QPixmapCache::find(key, &drawn)) {
      drawn = draw(size, colour);
      QPixmapCache::insert(key, drawn);
    }
    return drawn;
  }

 private:
  [[nodiscard]] QPixmap draw(const QSize& size, const QColor& colour) const {
    QSvgRenderer svg(path_);
    QPixmap drawn = render(svg, size);
    if (!size.isEmpty()) {
      QPainter painter(&drawn);
      painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
      painter.fillRect(drawn.rect(), colour);
    }
    return drawn;
  }

  QString path_;
  std::optional<QColor> colour_;
};

QIcon tinted(const QString& name, std::optional<QColor> colour) {
  const QString path = pathOf(name);
  return path.isEmpty() ? QIcon() : QIcon(new TintedIcon(path, colour));
}

}  // namespace

QIcon icon(const QString& name) {
  return tinted(name, std::nullopt);
}

QIcon icon(const QString& name, const QColor& colour) {
  return tinted(name, colour);
}

// Drawn here: Qt's own engine for SVG icons is a plugin that not every system installs with the library.
QIcon applicationIcon() {
  QSvgRenderer svg(pathOf(QStringLiteral("graftsman")));
  QIcon icon;
  for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
    icon.addPixmap(render(svg, {size, size}));
  }
  return icon;
}

}  // namespace graftsman
