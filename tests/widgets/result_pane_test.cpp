#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>
#include <set>

#include "core/fusion/path_position.h"
#include "tests/support/panes.h"
#include "tests/support/shapes.h"
#include "widgets/viewport/result_pane.h"

using namespace graftsman;

namespace {

constexpr int kPatienceMs = 60'000;

using Results = std::shared_ptr<const FusionResults>;

Results fuse(FusionInputs inputs, const FusionResults& previous = {}) {
  return std::make_shared<const FusionResults>(update(inputs, previous, {}));
}

}  // namespace

class ResultPaneTest : public QObject {
  Q_OBJECT

 private:
  struct Shown {
    ResultPane pane;
    Results results;

    explicit Shown(const std::string& name) : results(fuse(samples::load(name))) {
      pane.resize(480, 400);
      pane.show();
      if (!QTest::qWaitForWindowExposed(&pane)) {
        qFatal("the pane is not shown");
      }
      pane.aim({{0.4, -3, 0.8}, {0, 0, 0}});
      show(results);
    }
    void show(const Results& now) {
      QSignalSpy shown(&pane, &ResultPane::resultsShown);
      pane.setResults(now);
      if (shown.isEmpty() && !shown.wait(kPatienceMs)) {
        qFatal("the results are not shown");
      }
    }
    /// Looks at the middle of the tile from outside, near enough that it fills the pane.
    void lookAtTile() {
      const CombinedTile& tile = *results->combined;
      const auto top = std::max_element(tile.s.begin(), tile.s.end()) - tile.s.begin();
      const Point at =
          results->fused
              ->points[static_cast<std::size_t>(results->join->tileVertices[static_cast<std::size_t>(top)])];
      Point middle = Point::Zero();
      for (const Point& p : results->inputs.base->points()) {
        middle += p / results->inputs.base->vertexCount();
      }
      const Eigen::Vector3d out = (at - middle).normalized();
      const Eigen::Vector3d up =
          std::abs(out.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
      pane.setCamera({at + 0.8 * results->inputs.base->diagonal() * out, at, up, up});
    }
  };

 private Q_SLOTS:
  void aCurveIsShownLikeItsFusion() {
    for (const char* name : {"fig4c_cone_sphere", "fig8b_cone_nose", "fig9b_bird_plane"}) {
      Shown shown(name);
      const QImage before = shown.pane.picture();
      FusionInputs inputs = shown.results->inputs;
      inputs.fcf = *FCF::through({{0, 0.2}, {0.3, 0.9}, {0.7, 0.4}, {1, 0.1}});
      shown.pane.setCurve(inputs.fcf);
      const QImage followed = shown.pane.picture();
      QVERIFY(followed != before);
      Shown fresh(name);
      fresh.results = fuse(inputs, *shown.results);
      fresh.show(fresh.results);
      QVERIFY(fresh.pane.picture() == followed);
    }
  }

  void everyColouringIsAnother() {
    Shown shown("fig7_letters_bottle");
    shown.lookAtTile();
    std::set<QByteArray> pictures;
    for (const Colouring colouring : {Colouring::Plain, Colouring::FusionCurve, Colouring::Origin,
                                      Colouring::SeamAngle, Colouring::Quality}) {
      shown.pane.setColouring(colouring);
      const QImage picture = shown.pane.picture();
      pictures.insert(QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()));
    }
    QCOMPARE(pictures.size(), std::size_t{5});
  }

  void theCurvesColoursFollowTheCurve() {
    Shown shown("fig4c_cone_sphere");
    shown.lookAtTile();
    shown.pane.setColouring(Colouring::FusionCurve);
    shown.pane.setSeamShown(false);
    const auto middle = [&] { return shown.pane.picture().pixelColor(240, 200); };
    shown.pane.setCurve(*FCF::through({{0, 0}, {0.3, 0}, {0.6, 0}, {1, 0}}));
    const QColor cool = middle();
    shown.pane.setCurve(*FCF::through({{0, 1}, {0.3, 1}, {0.6, 1}, {1, 1}}));
    const QColor warm = middle();
    QVERIFY(cool.blue() > cool.red());
    QVERIFY(warm.red() > warm.blue());
  }

  void seamEdgesWireframeRingAndPartAreSeenAndGo() {
    Shown shown("fig8b_cone_nose");
    shown.lookAtTile();
    shown.pane.setSeamShown(false);
    const QImage plain = shown.pane.picture();
    const auto changes = [&](const std::function<void(bool)>& set) {
      set(true);
      const bool seen = shown.pane.picture() != plain;
      set(false);
      return seen && shown.pane.picture() == plain;
    };
    QVERIFY(changes([&](bool on) { shown.pane.setSeamShown(on); }));
    QVERIFY(changes([&](bool on) { shown.pane.setEdgesShown(on); }));
    QVERIFY(changes([&](bool on) { shown.pane.setWireframe(on); }));
    QVERIFY(changes([&](bool on) { shown.pane.setRing(on ? std::optional(0.4) : std::nullopt); }));
    using PartInPlace = ResultPane::PartInPlace;
    QVERIFY(
        changes([&](bool on) { shown.pane.setPartInPlace(on ? PartInPlace::After : PartInPlace::Hidden); }));
    QVERIFY(
        changes([&](bool on) { shown.pane.setPartInPlace(on ? PartInPlace::Before : PartInPlace::Hidden); }));
  }

  void sIsToldOverTheTileAndNowhereElse() {
    Shown shown("fig4c_cone_sphere");
    shown.lookAtTile();
    QSignalSpy hovered(&shown.pane, &ResultPane::sHovered);
    QVERIFY(!shown.pane.picture().isNull());
    panes::moveTo(shown.pane, QPoint(240, 200));
    QTRY_VERIFY(!hovered.isEmpty());
    const double s = hovered.last().first().toDouble();
    QVERIFY2(s > 0.5 && s <= 1, qPrintable(QString::number(s)));
    panes::moveTo(shown.pane, QPoint(2, 2));
    QTRY_VERIFY(hovered.last().first().toDouble() < 0);
  }

  void anotherResultKeepsTheCamera() {
    Shown shown("fig4c_cone_sphere");
    const Camera camera = shown.pane.camera();
    FusionInputs inputs = shown.results->inputs;
    inputs.loop.erase(inputs.loop.begin());
    const Results other = fuse(inputs, *shown.results);
    QVERIFY(other->fused);
    shown.show(other);
    QVERIFY(shown.pane.camera() == camera);
  }

  void nothingIsShownAfterNoResult() {
    Shown shown("fig4c_cone_sphere");
    const QColor shape = shown.pane.picture().pixelColor(240, 200);
    shown.pane.setResults(nullptr);
    const QImage empty = shown.pane.picture();
    QVERIFY(empty.pixelColor(240, 200) != shape);
    QCOMPARE(empty.pixelColor(240, 200), empty.pixelColor(20, 200));
  }

  void aLargeResultComesWithoutAStandstillAndTheNewestWins() {
    FusionInputs inputs;
    inputs.base = shapes::torus(500, 500);
    inputs.part = shapes::torus(40, 40);
    for (int k = 0; k < 8; ++k) {
      const double angle = 2 * 3.14159265358979 * k / 8;
      const auto at = [&](int n) {
        return SurfacePoint::atVertex(static_cast<Index>(n * (0.5 + 0.1 * std::cos(angle))) * n +
                                      static_cast<Index>(n * (0.5 + 0.1 * std::sin(angle))));
      };
      inputs.loop.push_back({at(40), at(500)});
    }
    const Results first = fuse(inputs);
    QVERIFY2(first->fused, first->error ? first->error->message.c_str() : "");
    inputs.fcf = FCF::preset(FCF::Preset::Half);
    const Results second = fuse(inputs);

    ResultPane pane;
    pane.resize(480, 400);
    pane.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pane));
    QElapsedTimer clock;
    qint64 longest = 0;
    qint64 last = 0;
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, this, [&] {
      longest = std::max(longest, clock.elapsed() - last);
      last = clock.elapsed();
    });
    ticks.start(0);
    clock.start();
    QSignalSpy shown(&pane, &ResultPane::resultsShown);
    pane.setResults(first);
    pane.setResults(second);
    QVERIFY(shown.wait(kPatienceMs));
    qInfo("the longest standstill until 500,000 faces were shown: %lld ms", longest);
    QCOMPARE(shown.size(), 1);
  }

  void aPaneGoesAwayWhileItsResultIsMadeReady() {
    FusionInputs inputs = samples::load("fig9b_bird_plane");
    const Results results = fuse(inputs);
    for (int i = 0; i < 5; ++i) {
      ResultPane pane;
      pane.resize(300, 200);
      pane.show();
      pane.setResults(results);
    }
  }
};

QTEST_MAIN(ResultPaneTest)
#include "result_pane_test.moc"
