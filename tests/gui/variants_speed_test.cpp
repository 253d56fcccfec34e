#include <QElapsedTimer>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <ctime>

#include "tests/support/gallery.h"
#include "tests/support/many_variants.h"
#include "tests/support/projects.h"

using namespace graftsman;

namespace {

/// Watches the event loop: how long the GUI thread was busy with one event at most. Its own processor time,
/// so that other programs on the machine don't count.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (depth_++ > 0) {
      const bool done = QApplication::notify(receiver, event);
      --depth_;
      return done;
    }
    const QString what = QString("%1 of %2").arg(event->type()).arg(receiver->metaObject()->className());
    const double before = now();
    const bool done = QApplication::notify(receiver, event);
    --depth_;
    const double took = now() - before;
    if (took > longestMs) {
      longestMs = took;
      longest = what;
    }
    return done;
  }

  double longestMs = 0;
  QString longest;

 private:
  static double now() {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }

  int depth_ = 0;
};

WatchedApplication& watch() {
  return static_cast<WatchedApplication&>(*QApplication::instance());
}

}  // namespace

// 200 variants of a fusion of 112k faces.
class VariantsSpeedTest : public QObject {
  Q_OBJECT

 private:
  static constexpr int kVariants = 200;
  static constexpr double kStallMs = 50;
  static constexpr qint64 kOpeningMs = 3000;

  // Down the whole gallery and up again by the wheel, a frame for each step.
  static void scroll(const GalleryHands& hands) {
    QScrollBar* bar = hands.view()->verticalScrollBar();
    QWidget* viewport = hands.view()->viewport();
    QVERIFY(bar->maximum() > 10 * viewport->height());
    for (const int direction : {-1, 1}) {
      const int end = direction < 0 ? bar->maximum() : bar->minimum();
      while (bar->value() != end) {
        const QPointF at = viewport->rect().center();
        QCoreApplication::postEvent(
            viewport, new QWheelEvent(at, viewport->mapToGlobal(at), {}, {0, 120 * direction}, Qt::NoButton,
                                      Qt::NoModifier, Qt::NoScrollPhase, false));
        const int before = bar->value();
        QVERIFY(QTest::qWaitFor([&] { return bar->value() != before; }, 10'000));
      }
    }
  }

 private Q_SLOTS:
  void aProjectOfManyVariantsOpensAtOnceAndScrollsWithoutAStall() {
    Workbench bench;
    const GalleryHands hands{bench};
    const QString path = bench.folder.filePath("many.graft");
    Project project = samples::manyVariants(kVariants);
    project.viewState = R"({"mode": "variants"})";
    projects::mustSucceed(writeProject(path.toStdString(), project, {}));

    QElapsedTimer timer;
    timer.start();
    bench.window->openFile(path);
    QVERIFY(QTest::qWaitFor([&] { return hands.shown().size() == kVariants; }, kPatienceMs));
    const qint64 opening = timer.elapsed();
    qInfo("opened in %lld ms", static_cast<long long>(opening));
    QVERIFY2(opening <= kOpeningMs, qPrintable(QString("%1 ms").arg(opening)));
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Variants);

    // While the pictures are made, and when they are there.
    VariantPictures* pictures = bench.window->variantsPage().pictures();
    QVERIFY(QTest::qWaitFor([&] { return pictures->missing() > 0; }, kPatienceMs));
    watch().longestMs = 0;
    scroll(hands);
    qInfo("while %d pictures are to come: %.1f ms at most in %s", pictures->missing(), watch().longestMs,
          qPrintable(watch().longest));
    QVERIFY2(watch().longestMs <= kStallMs, qPrintable(watch().longest));
    QVERIFY(hands.drawn());
    watch().longestMs = 0;
    scroll(hands);
    qInfo("with all pictures: %.1f ms at most in %s", watch().longestMs, qPrintable(watch().longest));
    QVERIFY2(watch().longestMs <= kStallMs, qPrintable(watch().longest));
  }
};

int main(int argc, char** argv) {
  WatchedApplication application(argc, argv);
  VariantsSpeedTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "variants_speed_test.moc"
