#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTableWidget>
#include <QUndoView>

#include "app/document/commands.h"
#include "core/project/edits.h"
#include "tests/support/panes.h"
#include "tests/support/workbench.h"
#include "widgets/curve/fusion_curve_editor.h"

using namespace graftsman;

// Fusion mode and the panels, with real mouse and keys on the real window.
class FusionTest : public QObject {
  Q_OBJECT

 private:
  struct Fused : Workbench {
    FusionCurveEditor* editor = nullptr;

    explicit Fused(const char* sample = "fig8b_cone_nose") {
      if (!openSample(sample)) {
        qFatal("the sample makes no result");
      }
      QTest::keyClick(window.get(), Qt::Key_F3);
      editor = window->findChild<FusionCurveEditor*>();
    }
    template <class T>
    T* find(const char* name) const {
      return window->findChild<T*>(name);
    }
    [[nodiscard]] QPoint place(std::size_t point) const {
      return editor->position(editor->curve().points()[point]).toPoint();
    }
    [[nodiscard]] const FCF& curve() const { return fusion().inputs.fcf; }
    [[nodiscard]] QString undoText() const { return window->model().history()->undoText(); }
    [[nodiscard]] QImage picture() const { return resultPane()->picture(); }
  };

 private Q_SLOTS:
  void thePointsAreAddedRemovedNudgedAndTyped() {
    Fused bench;
    bench.find<QAbstractButton>("presetLinear")->click();
    QCOMPARE(bench.undoText(), QString("Curve: Linear"));
    QTest::mouseDClick(bench.editor, Qt::LeftButton, {}, bench.editor->position({0.5, 0.5}).toPoint());
    QTest::mouseRelease(bench.editor, Qt::LeftButton, {}, bench.editor->position({0.5, 0.5}).toPoint());
    QCOMPARE(bench.curve().points().size(), std::size_t{5});
    QCOMPARE(bench.undoText(), QString("Add curve point 2"));
    const double f = bench.curve().points()[2].f;
    QTest::keyClick(bench.editor, Qt::Key_Up);
    QVERIFY(std::abs(bench.curve().points()[2].f - f - 0.01) < 1e-9);
    QCOMPARE(bench.undoText(), QString("Move curve point 2"));
    auto* box = bench.find<QDoubleSpinBox>("pointF");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QLocale().toString(0.875));
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(bench.curve().points()[2].f, 0.875);
    bench.editor->setFocus();
    QTest::keyClick(bench.editor, Qt::Key_Delete);
    QCOMPARE(bench.curve().points().size(), std::size_t{4});
    QCOMPARE(bench.undoText(), QString("Remove curve point 2"));
    // Fewer than four there cannot be: said, and nothing happens.
    QTest::keyClick(bench.editor, Qt::Key_Delete);
    QCOMPARE(bench.curve().points().size(), std::size_t{4});
    QVERIFY(!bench.find<QWidget>("curveLine")->findChild<QLabel*>("problemText")->text().isEmpty());
    QCOMPARE(bench.window->model().history()->count(), 5);
  }

  void presetsAreButtonsAndKeys() {
    Fused bench;
    const std::pair<Qt::Key, FCF::Preset> presets[] = {{Qt::Key_1, FCF::Preset::Linear},
                                                       {Qt::Key_2, FCF::Preset::Paste},
                                                       {Qt::Key_3, FCF::Preset::KeepBaseSlope},
                                                       {Qt::Key_4, FCF::Preset::Half}};
    const char* const buttons[] = {"presetLinear", "presetPaste", "presetKeepBaseSlope", "presetHalf"};
    for (std::size_t i = 0; i < 4; ++i) {
      const FCF wanted = FCF::preset(presets[i].second);
      QTest::mouseClick(bench.find<QAbstractButton>(buttons[i]), Qt::LeftButton);
      QVERIFY(bench.curve() == wanted);
      bench.window->model().push(
          std::make_unique<SetFCFPreset>(bench.window->model(), presets[(i + 1) % 4].second));
      QTest::keyClick(bench.resultPane(), presets[i].first, Qt::ShiftModifier);
      QVERIFY(bench.curve() == wanted);
    }
    QTest::mouseClick(bench.find<QCheckBox>("monotone"), Qt::LeftButton, {}, QPoint(8, 8));
    QVERIFY(!bench.curve().monotone());
  }

  void aDragFollowsTheHandUnderTheConditionsAndIsOneStep() {
    Fused bench;
    const int steps = bench.window->model().history()->count();
    QTest::mousePress(bench.editor, Qt::LeftButton, {}, bench.place(1));
    QImage before = bench.picture();
    const QPoint from = bench.place(1);
    // Far beyond its neighbour and below the base: it stays between them and within [0, 1].
    for (int i = 1; i <= 5; ++i) {
      panes::moveHeld(*bench.editor, from + QPoint(60 * i, 60 * i), Qt::LeftButton);
      if (i <= 2) {
        const QImage now = bench.picture();
        QVERIFY(now != before);
        before = now;
      }
      const auto& points = bench.curve().points();
      QVERIFY(points[0].s <= points[1].s && points[1].s <= points[2].s);
      QVERIFY(points[1].f >= 0 && points[1].f <= 1);
    }
    QTest::mouseRelease(bench.editor, Qt::LeftButton, {}, from + QPoint(300, 300));
    QCOMPARE(bench.window->model().history()->count(), steps + 1);
    QVERIFY(bench.settle());
    QVERIFY(bench.window->fusionPage().shown()->fused->points ==
            update(bench.fusion().inputs, {}, {}).fused->points);
  }

  void pointingAtTheCurveShowsTheRingAndTheOtherWayRound() {
    Fused bench;
    panes::moveTo(*bench.editor, {2, 2});
    const QImage without = bench.picture();
    panes::moveTo(*bench.editor, bench.editor->position({0.4, 0.9}).toPoint());
    QVERIFY(bench.picture() != without);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(bench.editor, &leave);
    QVERIFY(bench.picture() == without);
    // Over the tile of the result.
    const FusionResults& shown = *bench.window->fusionPage().shown();
    const auto innermost = std::ranges::max_element(shown.combined->s) - shown.combined->s.begin();
    const FCF& curve = shown.inputs.fcf;
    const auto i = static_cast<std::size_t>(innermost);
    const double f = curve(shown.combined->s[i]);
    const Point top = f * shown.combined->part[i] + (1 - f) * shown.combined->base[i];
    QSignalSpy hovered(bench.resultPane(), &ResultPane::sHovered);
    // Beside the tip: at the tip itself a ring has hardly a length.
    double s = -1;
    connect(bench.resultPane(), &ResultPane::sHovered, bench.resultPane(), [&](double at) { s = at; });
    for (const QPoint& aside : {QPoint(12, 0), QPoint(0, -12), QPoint(12, -12), QPoint(-12, 0)}) {
      if (s < 0.1 || s > 0.9) {
        hovered.clear();
        panes::moveTo(*bench.resultPane(), bench.resultPane()->screenPosition(top) + aside);
        QTRY_VERIFY(!hovered.isEmpty());
      }
    }
    QVERIFY2(s > 0.1 && s < 0.9, qPrintable(QString::number(s)));
    QVERIFY(bench.picture() != without);
  }

  void everyColouringSeamEdgesAndWireframeAreSeen() {
    Fused bench;
    auto* box = bench.find<QComboBox>("colouring");
    std::vector<QImage> seen;
    for (int i = 0; i < box->count(); ++i) {
      QCOMPARE(box->currentIndex(), i);
      seen.push_back(bench.picture());
      QTest::keyClick(bench.resultPane(), Qt::Key_C);
    }
    QCOMPARE(box->currentIndex(), 0);
    for (const Qt::Key key : {Qt::Key_S, Qt::Key_E, Qt::Key_W}) {
      QTest::keyClick(bench.resultPane(), key);
      seen.push_back(bench.picture());
      QTest::keyClick(bench.resultPane(), key);
      QVERIFY(bench.picture() == seen.front());
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        QVERIFY2(seen[i] != seen[k], qPrintable(QString("%1 and %2").arg(k).arg(i)));
      }
    }
  }

  void theAdjustmentIsSwitchedSetRunAndSeenBeforeAndAfter() {
    Fused bench;
    const auto original = bench.fusion();
    const std::pair<const char*, const char*> switches[] = {{"rigidStep", "Turn off rigid step"},
                                                            {"scaleStep", "Turn off scale step"},
                                                            {"lineFieldStep", "Turn off line field"},
                                                            {"exactFitStep", "Turn off exact fit"}};
    for (const auto& [name, text] : switches) {
      QTest::mouseClick(bench.find<QCheckBox>(name), Qt::LeftButton, {}, QPoint(8, 8));
      QCOMPARE(bench.undoText(), QString(text));
      QVERIFY(bench.settle());
      if (name == QString("rigidStep")) {
        // The nose's loop and the cone's look away from each other: said, with what to do.
        const QString said = bench.find<QWidget>("resultFrame")->findChild<QLabel*>("problemText")->text();
        QVERIFY2(said.contains("turn the adjustment's scaling off"), qPrintable(said));
      } else {
        QVERIFY(bench.window->fusionPage().shown()->inputs.adjustment == bench.fusion().inputs.adjustment);
      }
      QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
      QVERIFY(bench.find<QWidget>("adjustmentPanel")->findChild<QWidget*>("flash"));
    }
    auto* falloff = bench.find<QDoubleSpinBox>("falloff");
    falloff->setFocus();
    falloff->selectAll();
    QTest::keyClicks(falloff, "2");
    QTest::keyClick(falloff, Qt::Key_Return);
    QCOMPARE(bench.undoText(), QString("Set falloff to 2"));
    auto* epsilon = bench.find<QDoubleSpinBox>("epsilon");
    epsilon->setFocus();
    epsilon->selectAll();
    QTest::keyClicks(epsilon, "50");
    QTest::keyClick(epsilon, Qt::Key_Return);
    QCOMPARE(bench.fusion().inputs.adjustment.epsilon, 0.5);
    QVERIFY(bench.settle());
    // So far apart that the first step is enough: k and the iterations are not told.
    QCOMPARE(bench.find<QLabel>("rigidStepReached")->accessibleName(), QString("The step reached"));
    QCOMPARE(bench.find<QCheckBox>("scaleStep")->text(), QString("2 scale"));
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.fusion() == original);
    QVERIFY(bench.settle());
    QVERIFY(bench.find<QCheckBox>("scaleStep")->text().contains("times"));
    QTest::mouseClick(bench.find<QAbstractButton>("runAdjustment"), Qt::LeftButton);
    QVERIFY(bench.settle());
    auto* table = bench.find<QTableWidget>("stagesTable");
    QCOMPARE(table->item(static_cast<int>(Stage::Adjust), 1)->text(), QString("ran"));
    const QImage result = bench.picture();
    QTest::mouseClick(bench.find<QAbstractButton>("showAfter"), Qt::LeftButton);
    const QImage after = bench.picture();
    QTest::mouseClick(bench.find<QAbstractButton>("showBefore"), Qt::LeftButton);
    QVERIFY(after != result && bench.picture() != after);
    QTest::mouseClick(bench.find<QAbstractButton>("showResult"), Qt::LeftButton);
    QVERIFY(bench.picture() == result);
  }

  void aFailureIsToldAtItsPlaceAndLeavesEverythingUsable() {
    Fused bench;
    const auto before = bench.fusion();
    QTest::keyClick(bench.resultPane(), Qt::Key_R);
    QVERIFY(bench.settle());
    const QString said = bench.find<QWidget>("resultFrame")->findChild<QLabel*>("problemText")->text();
    QVERIFY2(said.contains("clockwise") && said.contains("last result that worked"), qPrintable(said));
    auto* table = bench.find<QTableWidget>("stagesTable");
    QCOMPARE(table->item(static_cast<int>(Stage::Tile), 1)->text(), QString("failed"));
    QVERIFY(table->item(static_cast<int>(Stage::Tile), 1)->toolTip().contains("clockwise"));
    QCOMPARE(table->item(static_cast<int>(Stage::Blend), 1)->text(), QString("not reached"));
    QVERIFY(!bench.action("exportResult")->isEnabled());
    // The curve still shapes what is shown, and the button leads to the place.
    const QImage picture = bench.picture();
    QTest::keyClick(bench.resultPane(), Qt::Key_4, Qt::ShiftModifier);
    QVERIFY(bench.picture() != picture);
    QTest::mouseClick(bench.find<QWidget>("resultFrame")->findChild<QAbstractButton*>("remedy"),
                      Qt::LeftButton);
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Tiles);
    QTest::keyClick(bench.pane(Side::Base), Qt::Key_R);
    QVERIFY(bench.settle());
    QVERIFY(bench.fusion().inputs.loop == before.inputs.loop);
    QVERIFY(bench.action("exportResult")->isEnabled());
  }

  // What is shown still is the last result; nothing stands for the document's own.
  void anOpenLoopHasNoResultToExport() {
    Fused bench;
    for (const char* name : {"exportResult", "exportFrames"}) {
      QVERIFY(bench.action(name)->isEnabled());
    }
    bench.action("openLoop")->trigger();
    QVERIFY(bench.settle());
    for (const char* name : {"exportResult", "exportFrames"}) {
      QVERIFY(!bench.action(name)->isEnabled());
    }
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.settle());
    for (const char* name : {"exportResult", "exportFrames"}) {
      QVERIFY(bench.action(name)->isEnabled());
    }
  }

  void theHistoryDockGoesToAnyStep() {
    Fused bench;
    const auto before = bench.fusion();
    QTest::keyClick(bench.resultPane(), Qt::Key_4, Qt::ShiftModifier);
    QTest::keyClick(bench.resultPane(), Qt::Key_R);
    auto* view = bench.find<QUndoView>("historyView");
    QCOMPARE(view->model()->rowCount(), 3);
    QCOMPARE(view->model()->index(0, 0).data().toString(), QString("Beginning"));
    QCOMPARE(view->model()->index(1, 0).data().toString(), QString("Curve: Half"));
    QCOMPARE(view->model()->index(2, 0).data().toString(), QString("Reverse the loop"));
    view->parentWidget()->raise();
    view->setCurrentIndex(view->model()->index(0, 0));
    QVERIFY(bench.fusion() == before);
    QVERIFY(bench.settle());
    QVERIFY(bench.window->fusionPage().shown()->fused->points == update(before.inputs, {}, {}).fused->points);
  }

  void theThinLineAndTheDimmingAreThereOnlyWhileTheResultIsStale() {
    Fused bench;
    bench.resultPane()->setBusy({});
    const QImage calm = bench.resultPane()->grabFramebuffer();
    bench.resultPane()->setBusy(0.5);
    const QImage busy = bench.resultPane()->grabFramebuffer();
    const QPoint side(4, calm.height() / 2);
    const double dimmed = busy.pixelColor(side).lightnessF() / calm.pixelColor(side).lightnessF();
    QVERIFY2(std::abs(dimmed - 0.9) < 0.02, qPrintable(QString::number(dimmed)));
    const QColor line = busy.pixelColor(10, 0);
    QVERIFY(line == bench.resultPane()->palette().color(QPalette::Highlight));
    QVERIFY(busy.pixelColor(busy.width() - 10, 0) != line && busy.pixelColor(10, 4) != line);
  }
};

QTEST_MAIN(FusionTest)
#include "fusion_test.moc"
