#include <QSignalSpy>
#include <QtTest>
#include <cmath>

#include "tests/support/shown_editor.h"
#include "widgets/curve/curve_edit.h"
#include "widgets/curve/curve_plot.h"
#include "widgets/curve/fusion_curve_editor.h"

using namespace graftsman;

class FusionCurveEditorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aCurveIsShownWithoutASignal() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(4);
    shown.selection.clear();
    shown.editor.setCurve(FCF::preset(FCF::Preset::Paste));
    QCOMPARE(shown.started.count() + shown.moved.count() + shown.finished.count() + shown.cancelled.count() +
                 shown.added.count() + shown.removed.count() + shown.selection.count() +
                 shown.refused.count(),
             0);
    QVERIFY(shown.editor.curve() == FCF::preset(FCF::Preset::Paste));
    QCOMPARE(shown.editor.selectedPoint(), -1);  // the fifth point is gone
  }

  void aDragTellsStartEachMoveAndEnd() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint from = shown.pixelOf(2);
    shown.press(from);
    QCOMPARE(shown.editor.selectedPoint(), 2);
    QCOMPARE(shown.started.count(), 0);  // a click alone moves nothing
    shown.move(from + QPoint(10, 20));
    shown.move(from + QPoint(20, 40));
    shown.release(from + QPoint(20, 40));
    QCOMPARE(shown.started.count(), 1);
    QCOMPARE(shown.moved.count(), 2);
    QCOMPARE(shown.finished.count(), 1);
    QCOMPARE(shown.cancelled.count(), 0);
    QCOMPARE(shown.moved.last().at(0).toInt(), 2);
    QVERIFY(shown.moved.last().at(1).value<FCF>() == shown.editor.curve());
    const QPointF reached = shown.editor.position(at(shown.editor, 2));
    QVERIFY2(QLineF(reached, from + QPointF(20, 40)).length() < 1.5, "the point lies under the pointer");
  }

  void aClickThatShakesALittleMovesNothing() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint from = shown.pixelOf(2);
    shown.press(from);
    shown.move(from + QPoint(1, 1));
    shown.release(from + QPoint(1, 1));
    QCOMPARE(shown.started.count() + shown.moved.count() + shown.finished.count(), 0);
    QVERIFY(shown.editor.curve() == fivePoints());
  }

  void aPointIsHitEightPixelsAside() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.press(shown.pixelOf(2) + QPoint(8, 0));
    QCOMPARE(shown.editor.selectedPoint(), 2);
    shown.release(shown.pixelOf(2));
    shown.press(shown.pixelOf(2) + QPoint(-40, -30));
    QCOMPARE(shown.editor.selectedPoint(), -1);
  }

  void aDraggedPointStaysBetweenItsNeighbours() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint from = shown.pixelOf(2);
    shown.press(from);
    shown.move(shown.pixel({1.2, 1.4}));
    QCOMPARE(at(shown.editor, 2).s, at(shown.editor, 3).s - kPointGap);
    QCOMPARE(at(shown.editor, 2).f, 1.0);
    shown.move(shown.pixel({-0.3, -0.4}));
    QCOMPARE(at(shown.editor, 2).s, at(shown.editor, 1).s + kPointGap);
    QCOMPARE(at(shown.editor, 2).f, 0.0);
    shown.move(shown.pixel({0.5, 0.5}));  // back within: again under the pointer
    QVERIFY(std::abs(at(shown.editor, 2).s - 0.5) < 0.004);
    shown.release(shown.pixel({0.5, 0.5}));
  }

  void anEndPointKeepsItsPlaceAndMovesUpAndDown() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    for (const int end : {0, 4}) {
      const QPoint from = shown.pixelOf(end);
      shown.press(from);
      shown.move(shown.pixel({0.4, 0.6}));
      shown.release(shown.pixel({0.4, 0.6}));
      QCOMPARE(at(shown.editor, end).s, end == 0 ? 0.0 : 1.0);
      QVERIFY(std::abs(at(shown.editor, end).f - 0.6) < 0.005);
    }
  }

  void everyCurveProposedIsLegalHoweverThePointerRuns() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    int proposed = 0;
    connect(&shown.editor, &FusionCurveEditor::moved, this, [&](int, const FCF& curve) {
      ++proposed;
      QVERIFY(FCF::through(curve.points(), curve.monotone()).has_value());
    });
    QRandomGenerator random(7);
    for (int drag = 0; drag < 20; ++drag) {
      shown.press(shown.pixelOf(static_cast<int>(random.bounded(5))));
      for (int i = 0; i < 20; ++i) {
        shown.move({static_cast<int>(random.bounded(-100, 700)), static_cast<int>(random.bounded(-100, 500))},
                   i % 3 == 0   ? Qt::ShiftModifier
                   : i % 3 == 1 ? Qt::ControlModifier
                                : Qt::NoModifier);
      }
      shown.release({10, 10});
    }
    QVERIFY(proposed > 100);
  }

  void shiftKeepsADragStraight() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint from = shown.pixelOf(2);
    shown.press(from);
    shown.move(from + QPoint(8, 60), Qt::ShiftModifier);
    QCOMPARE(at(shown.editor, 2).s, 0.5);
    QVERIFY(at(shown.editor, 2).f < 0.75);
    shown.move(from + QPoint(70, 20), Qt::ShiftModifier);
    QCOMPARE(at(shown.editor, 2).f, 0.8);
    QVERIFY(at(shown.editor, 2).s > 0.55);
    shown.release(from);
  }

  void controlMovesATenthAsFar() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint from = shown.pixelOf(2);
    const double perPixel = 1 / (shown.editor.position({1, 0}).x() - shown.editor.position({0, 0}).x());
    shown.press(from);
    shown.move(from + QPoint(50, 0), Qt::ControlModifier);
    QVERIFY(std::abs(at(shown.editor, 2).s - (0.5 + 5 * perPixel)) < 1e-4);
    shown.release(from);
  }

  void escapeDuringADragRestoresTheCurve() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint from = shown.pixelOf(1);
    shown.press(from);
    shown.move(from + QPoint(30, -80));
    QVERIFY(!(shown.editor.curve() == fivePoints()));
    shown.key(Qt::Key_Escape);
    QVERIFY(shown.editor.curve() == fivePoints());
    QCOMPARE(shown.cancelled.count(), 1);
    shown.move(from + QPoint(60, -80));  // the button is still down, the drag is over
    shown.release(from);
    QVERIFY(shown.editor.curve() == fivePoints());
    QCOMPARE(shown.finished.count(), 0);
  }

  void anotherCurveFromOutsideEndsADrag() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint from = shown.pixelOf(2);
    shown.press(from);
    shown.move(from + QPoint(0, 40));
    shown.editor.setCurve(shown.editor.curve());  // the owner agrees: the drag goes on
    shown.move(from + QPoint(0, 60));
    QCOMPARE(shown.moved.count(), 2);
    shown.editor.setCurve(FCF());
    shown.move(from + QPoint(0, 80));
    shown.release(from);
    QVERIFY(shown.editor.curve() == FCF());
    QCOMPARE(shown.moved.count(), 2);
    QCOMPARE(shown.finished.count(), 0);
  }

  void aDoubleClickOnTheCurveAddsAPointThere() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const double f = fivePoints()(0.35);
    QTest::mouseDClick(&shown.editor, Qt::LeftButton, {}, shown.pixel({0.35, f}) + QPoint(0, 6));
    QCOMPARE(shown.added.count(), 1);
    QCOMPARE(shown.added.first().at(0).toInt(), 2);
    QCOMPARE(shown.editor.curve().points().size(), 6U);
    QCOMPARE(shown.editor.selectedPoint(), 2);
    QVERIFY(std::abs(at(shown.editor, 2).s - 0.35) < 0.004);
    QVERIFY(std::abs(at(shown.editor, 2).f - fivePoints()(at(shown.editor, 2).s)) < 1e-4);
  }

  void aDoubleClickBesideTheCurveAddsAPointUnderThePointer() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    QTest::mouseDClick(&shown.editor, Qt::LeftButton, {}, shown.pixel({0.3, 0.9}));
    QCOMPARE(shown.added.count(), 1);
    QVERIFY(std::abs(at(shown.editor, 2).f - 0.9) < 0.004);
  }

  void thePointAddedCanBeDraggedOnAtOnce() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    const QPoint where = shown.pixel({0.3, 0.9});
    shown.press(where);
    shown.release(where);
    QMouseEvent second(QEvent::MouseButtonDblClick, where, shown.editor.mapToGlobal(where), Qt::LeftButton,
                       Qt::LeftButton, {});
    QApplication::sendEvent(&shown.editor, &second);
    shown.move(where + QPoint(0, 60));
    shown.release(where + QPoint(0, 60));
    QCOMPARE(shown.added.count(), 1);
    QCOMPARE(shown.started.count(), 1);
    QCOMPARE(shown.finished.count(), 1);
    QVERIFY(at(shown.editor, 2).f < 0.8);
  }

  void theSUnderThePointerIsToldAndItsLeaving() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.move(shown.pixel({0.35, 0.9}), {}, Qt::NoButton);
    QCOMPARE(shown.hovered.count(), 1);
    QVERIFY(std::abs(shown.hovered.last().first().toDouble() - 0.35) < 0.002);
    shown.move(shown.pixelOf(2) + QPoint(4, 3), {}, Qt::NoButton);
    QCOMPARE(shown.hovered.last().first().toDouble(), 0.5);  // on a point: the point's
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&shown.editor, &leave);
    QCOMPARE(shown.hovered.last().first().toDouble(), -1.0);
    QCOMPARE(shown.hovered.count(), 3);
  }

  void theHistogramShowsSmallCounts() {
    std::vector<double> s(10000, 0.5);
    s.push_back(0);
    s.push_back(1);
    const std::vector<double> bars = histogramOf(s);
    QCOMPARE(bars.size(), static_cast<std::size_t>(kHistogramBins));
    QCOMPARE(bars[kHistogramBins / 2], 1.0);
    QCOMPARE(bars.front(), 0.01);
    QCOMPARE(bars.back(), 0.01);
    QCOMPARE(bars[3], 0.0);
    QVERIFY(histogramOf({}).empty());
  }

  void itDrawsAtEverySize() {
    for (const QSize size : {QSize(1, 1), QSize(240, 180), QSize(1200, 800)}) {
      ShownEditor shown(FCF::preset(FCF::Preset::Paste), size);
      QVERIFY(shown.ready());
      shown.editor.setHistogram(std::vector<double>(100, 0.2));
      const QImage picture = shown.editor.grab().toImage();
      QVERIFY(!picture.isNull());
      const QPointF end = shown.editor.position({1, 1});
      if (size.width() > 1) {
        QVERIFY(shown.editor.rect().adjusted(8, 8, -8, -8).contains(end.toPoint()));
        const QColor curve = picture.pixelColor(shown.editor.position({0.5, 1}).toPoint());
        QVERIFY2(curve.red() > curve.blue() + 40, "the part's end of the curve is warm");
      }
    }
  }
};

QTEST_MAIN(FusionCurveEditorTest)
#include "fusion_curve_editor_test.moc"
