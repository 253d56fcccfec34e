#include "widgets/theme/indicator_style.h"

#include <QApplication>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>
#include <QtTest>
#include <algorithm>
#include <memory>

#include "widgets/theme/contrast.h"

using namespace graftsman;

namespace {

constexpr double kVisible = 3;  // WCAG 2.1, 1.4.11

QPalette darkPalette() {
  QPalette palette(QColor("#3C3C3C"), QColor("#323232"));
  palette.setColor(QPalette::Base, QColor("#242424"));
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(role, QColor("#F0F0F0"));
    palette.setColor(QPalette::Disabled, role, QColor("#8C8C8C"));
  }
  return palette;
}

QImage drawn(const QStyle& style, QStyle::PrimitiveElement element, const QPalette& palette,
             QStyle::State state) {
  QImage picture(20, 20, QImage::Format_RGB32);
  picture.fill(palette.color(QPalette::Window));
  QStyleOptionButton option;
  option.palette = palette;
  option.palette.setCurrentColorGroup(state.testFlag(QStyle::State_Enabled) ? QPalette::Active
                                                                            : QPalette::Disabled);
  option.state = state;
  option.rect = QRect(3, 3, 14, 14);
  QPainter painter(&picture);
  style.drawPrimitive(element, &option, &painter);
  return picture;
}

// The greatest contrast with the window's colour in the row through the picture's middle.
double frameContrast(const QImage& picture, const QColor& window) {
  double greatest = 1;
  for (int x = 0; x < picture.width(); ++x) {
    greatest = std::max(greatest, contrast(picture.pixelColor(x, picture.height() / 2), window));
  }
  return greatest;
}

constexpr QStyle::PrimitiveElement kIndicators[] = {
    QStyle::PE_IndicatorCheckBox, QStyle::PE_IndicatorItemViewItemCheck, QStyle::PE_IndicatorRadioButton};

}  // namespace

class IndicatorStyleTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void inTheDarkAnEmptyIndicatorHasAVisibleFrame() {
    const IndicatorStyle style;
    const QPalette palette = darkPalette();
    const QColor window = palette.color(QPalette::Window);
    for (const auto element : kIndicators) {
      const double enabled =
          frameContrast(drawn(style, element, palette, QStyle::State_Enabled | QStyle::State_Off), window);
      const double disabled = frameContrast(drawn(style, element, palette, QStyle::State_Off), window);
      QVERIFY2(enabled >= kVisible, qPrintable(QString::number(enabled)));
      QVERIFY2(disabled < enabled && disabled > 1.3, qPrintable(QString::number(disabled)));
    }
  }

  void inTheLightNothingChanges() {
    const IndicatorStyle style;
    const std::unique_ptr<QStyle> fusion(QStyleFactory::create("fusion"));
    const QPalette palette(QColor("#EFEFEF"), QColor("#EFEFEF"));
    for (const auto element : kIndicators) {
      for (const QStyle::State state :
           {QStyle::State_Enabled | QStyle::State_On, QStyle::State_Enabled | QStyle::State_Off,
            QStyle::State(QStyle::State_Off)}) {
        QCOMPARE(drawn(style, element, palette, state), drawn(*fusion, element, palette, state));
      }
    }
  }

  void theFrameLiesOnFusionsOwn() {
    const IndicatorStyle style;
    const std::unique_ptr<QStyle> fusion(QStyleFactory::create("fusion"));
    const QPalette palette = darkPalette();
    const QRgb window = palette.color(QPalette::Window).rgb();
    for (const auto element : kIndicators) {
      const QStyle::State state = QStyle::State_Enabled | QStyle::State_Off;
      const QImage own = drawn(style, element, palette, state);
      const QImage base = drawn(*fusion, element, palette, state);
      for (int y = 0; y < own.height(); ++y) {
        for (int x = 0; x < own.width(); ++x) {
          QVERIFY(base.pixel(x, y) != window || own.pixel(x, y) == window);  // nothing outside
        }
      }
    }
  }

  void aStyleThatWasChosenStays() {
    QApplication::setStyle("windows");
    IndicatorStyle::install();
    QCOMPARE(QApplication::style()->name(), QString("windows"));
    QApplication::setStyle("fusion");
    IndicatorStyle::install();
    QVERIFY(dynamic_cast<IndicatorStyle*>(QApplication::style()) != nullptr);
  }
};

QTEST_MAIN(IndicatorStyleTest)
#include "indicator_style_test.moc"
