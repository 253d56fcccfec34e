#include <QDir>
#include <QImage>
#include <QtTest>

#include "widgets/theme/icon.h"

using namespace graftsman;

class IconTest : public QObject {
  Q_OBJECT

 private:
  // The alpha of all pixels together: 0 for a blank icon.
  static qint64 ink(const QIcon& icon, int size) {
    const QImage image = icon.pixmap(size).toImage();
    qint64 sum = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        sum += qAlpha(image.pixel(x, y));
      }
    }
    return sum;
  }

 private Q_SLOTS:
  void everyIconIsDrawn() {
    QVERIFY(!icon("undo").isNull());
    const QStringList files = QDir(":/graftsman/icons").entryList({"*.svg"});
    QVERIFY(files.size() > 25);
    for (const QString& file : files) {
      for (const int size : {16, 24, 48}) {
        QVERIFY2(ink(icon(file.chopped(4)), size) > 255 * size / 4, qPrintable(file));
      }
    }
  }

  void aNameThatThereIsNotGivesNone() { QVERIFY(icon("no such icon").isNull()); }

  void iconsFollowThePalette() {
    const auto lightest = [] {
      const QImage image = icon("undo").pixmap(48).toImage();
      int most = 0;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          if (qAlpha(image.pixel(x, y)) > 200) {
            most = std::max(most, qGray(image.pixel(x, y)));
          }
        }
      }
      return most;
    };
    QPalette palette = QGuiApplication::palette();
    palette.setColor(QPalette::WindowText, Qt::black);
    QGuiApplication::setPalette(palette);
    QVERIFY(lightest() < 60);
    palette.setColor(QPalette::WindowText, Qt::white);
    QGuiApplication::setPalette(palette);
    QVERIFY(lightest() > 200);
  }

  void theProgramsIconIsInColour() {
    const QImage image = applicationIcon().pixmap(64).toImage();
    bool warm = false;
    bool cool = false;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor colour = image.pixelColor(x, y);
        warm = warm || (colour.alpha() > 200 && colour.red() > colour.blue() + 60);
        cool = cool || (colour.alpha() > 200 && colour.blue() > colour.red() + 60);
      }
    }
    QVERIFY(warm && cool);
  }
};

QTEST_MAIN(IconTest)
#include "icon_test.moc"
