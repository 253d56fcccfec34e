#include <QAbstractButton>
#include <QElapsedTimer>

#include "core/project/project_file.h"
#include "tests/support/documents.h"
#include "tests/support/shapes.h"
#include "tests/support/workbench.h"

using namespace graftsman;

namespace {

// The longest time for which the GUI thread answered nothing.
class Standstill : public QObject {
 public:
  Standstill() {
    connect(&ticks_, &QTimer::timeout, this, [this] { longest_ = std::max(longest_, clock_.restart()); });
    clock_.start();
    ticks_.start(0);
  }
  [[nodiscard]] qint64 longest() const { return longest_; }

 private:
  QTimer ticks_;
  QElapsedTimer clock_;
  qint64 longest_ = 0;
};

// The cone of a sample on a ring of more than a million faces.
Project millionFaces() {
  constexpr Index kSize = 720;
  constexpr Index kRadius = 330;  // a tile of two thirds of a million faces: time to cancel
  Fusion fusion = samples::fusion("fig4c_cone_sphere");
  fusion.inputs.base = shapes::torus(kSize, kSize);
  fusion.base = std::make_shared<const MeshAsset>(MeshAsset{"ring", "ring.ply", {}, fusion.inputs.base});
  for (std::size_t k = 0; k < fusion.inputs.loop.size(); ++k) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(fusion.inputs.loop.size());
    const auto i = static_cast<Index>(kSize / 2 + kRadius * std::cos(angle));
    const auto j = static_cast<Index>(kSize / 2 + kRadius * std::sin(angle));
    fusion.inputs.loop[k].base = SurfacePoint::atVertex(i * kSize + j);
  }
  Project project;
  project.document = samples::documentOf(fusion);
  return project;
}

}  // namespace

// A base of a million faces: the window answers all the time.
class MillionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theWindowAnswersWhileItOpensFusesAndIsCancelled() {
    Workbench bench;
    const QString path = bench.folder.filePath("million.graft");
    QVERIFY(writeProject(path.toStdString(), millionFaces(), {}));
    const QSignalSpy announced(&bench.window->jobs(), &JobQueue::progressed);
    qint64 opened = 0;
    qint64 standstill = 0;
    {
      const Standstill watch;
      QElapsedTimer clock;
      clock.start();
      QSignalSpy shown(bench.pane(Side::Base), &MeshPane::meshShown);
      bench.window->openFile(path);
      QVERIFY(bench.settle());
      QTRY_VERIFY_WITH_TIMEOUT(!shown.isEmpty(), kPatienceMs);
      opened = clock.elapsed();
      standstill = watch.longest();
    }
    qInfo("opened and fused in %lld ms; the longest standstill %lld ms; progress told %d times", opened,
          standstill, static_cast<int>(announced.size()));
    QVERIFY(bench.fusion().inputs.base->faceCount() > 1'000'000);
    QVERIFY(bench.window->fusionPage().shown());
    QVERIFY(!announced.isEmpty());

    // A run is cancelled by the button in the status bar.
    QTest::keyClick(bench.window.get(), Qt::Key_F2);
    auto* cancel = bench.window->findChild<QAbstractButton*>("statusCancel");
    const Standstill watch;
    bench.action("paperPaths")->trigger();
    QTRY_VERIFY(cancel->isVisible());
    QTest::mouseClick(cancel, Qt::LeftButton);
    QVERIFY(bench.settle());
    QVERIFY2(bench.status().startsWith("Cancelled"), qPrintable(bench.status()));
    QVERIFY(!cancel->isVisible());

    // Everything is usable: the edit is undone, and there is the result.
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.settle());
    QVERIFY(bench.window->fusionPage().shown()->inputs.loop == bench.fusion().inputs.loop);
    QVERIFY(bench.action("exportResult")->isEnabled());
    qInfo("cancelled and fused again: the longest standstill %lld ms", watch.longest());
  }
};

QTEST_MAIN(MillionTest)
#include "million_test.moc"
