#include "widgets/panels/flash.h"

#include <QPainter>
#include <QVariantAnimation>
#include <QWidget>

namespace graftsman {
namespace {

constexpr int kMilliseconds = 900;
constexpr int kAround = 3;
constexpr double kWidth = 2;

class Frame : public QWidget {
 public:
  Frame(QWidget& widget, const QRect& place) : QWidget(&widget) {
    setObjectName("flash");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setGeometry(place.adjusted(-kAround, -kAround, kAround, kAround) & widget.rect());
    fade_.setStartValue(1.0);
    fade_.setEndValue(0.0);
    fade_.setDuration(kMilliseconds);
    connect(&fade_, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
    connect(&fade_, &QVariantAnimation::finished, this, &QObject::deleteLater);
    fade_.start();
    show();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(fade_.currentValue().toDouble());
    painter.setPen(QPen(palette().color(QPalette::Highlight), kWidth));
    painter.drawRoundedRect(QRectF(rect()).adjusted(kWidth / 2, kWidth / 2, -kWidth / 2, -kWidth / 2), 3, 3);
  }

 private:
  QVariantAnimation fade_;
};

}  // namespace

void flash(QWidget& widget, const QRect& place) {
  new Frame(widget, place);
}

}  // namespace graftsman
