#include <QAbstractButton>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QtTest>

#include "widgets/curve/fusion_curve_editor.h"
#include "widgets/curve/fusion_curve_panel.h"
#include "widgets/panels/problem_line.h"

using namespace graftsman;

namespace {

FCF fivePoints() {
  return FCF::through({{0, 0}, {0.2, 0.1}, {1.0 / 3, 0.8}, {0.75, 0.7}, {1, 1}}).value();
}

struct Shown {
  FusionCurvePanel panel;
  FusionCurveEditor& editor = *panel.editor();
  QDoubleSpinBox& s = *panel.findChild<QDoubleSpinBox*>("pointS");
  QDoubleSpinBox& f = *panel.findChild<QDoubleSpinBox*>("pointF");
  QCheckBox& monotone = *panel.findChild<QCheckBox*>("monotone");
  ProblemLine& line = *panel.findChild<ProblemLine*>("curveLine");
  QSignalSpy started{&editor, &FusionCurveEditor::moveStarted};
  QSignalSpy moved{&editor, &FusionCurveEditor::moved};
  QSignalSpy finished{&editor, &FusionCurveEditor::moveFinished};

  Shown() {
    panel.resize(320, 380);
    panel.setCurve(fivePoints());
    panel.show();
    panel.activateWindow();
  }
  [[nodiscard]] bool ready() {
    return QTest::qWaitForWindowExposed(&panel) && QTest::qWaitForWindowActive(&panel);
  }
  [[nodiscard]] QAbstractButton& button(const char* name) const {
    return *panel.findChild<QAbstractButton*>(name);
  }
};

void type(QDoubleSpinBox& box, const QString& text) {
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, text);
  QTest::keyClick(&box, Qt::Key_Return);
}

}  // namespace

class FusionCurvePanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachPresetHasItsButton() {
    Shown shown;
    QVERIFY(shown.ready());
    QSignalSpy chosen(&shown.panel, &FusionCurvePanel::presetChosen);
    const std::pair<const char*, FCF::Preset> presets[] = {
        {"presetLinear", FCF::Preset::Linear},
        {"presetPaste", FCF::Preset::Paste},
        {"presetKeepBaseSlope", FCF::Preset::KeepBaseSlope},
        {"presetHalf", FCF::Preset::Half}};
    for (const auto& [name, preset] : presets) {
      QTest::mouseClick(&shown.button(name), Qt::LeftButton);
      QCOMPARE(chosen.last().first().value<FCF::Preset>(), preset);
      QVERIFY(!shown.button(name).isChecked());  // a wish; the curve is not yet that preset
      shown.panel.setCurve(FCF::preset(preset));
      QVERIFY(shown.button(name).isChecked());
    }
    QCOMPARE(chosen.count(), 4);
  }

  void aPresetIsChosenByKeyboard() {
    Shown shown;
    QVERIFY(shown.ready());
    QSignalSpy chosen(&shown.panel, &FusionCurvePanel::presetChosen);
    shown.button("presetHalf").setFocus();
    QTest::keyClick(&shown.button("presetHalf"), Qt::Key_Space);
    QCOMPARE(chosen.count(), 1);
  }

  void theBoxesShowTheSelectedPointsNumbers() {
    Shown shown;
    QVERIFY(shown.ready());
    QVERIFY(!shown.s.isEnabled() && !shown.f.isEnabled());
    shown.editor.selectPoint(3);
    QCOMPARE(shown.s.text(), "0.750");
    QCOMPARE(shown.f.text(), "0.700");
    QVERIFY(shown.s.isEnabled() && shown.f.isEnabled());
    shown.editor.selectPoint(4);
    QVERIFY(!shown.s.isEnabled() && shown.f.isEnabled());
    QCOMPARE(shown.moved.count(), 0);
  }

  void aTypedNumberIsOneMoveOnEnter() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(2);
    shown.f.setFocus();
    shown.f.selectAll();
    QTest::keyClicks(&shown.f, "0.55");
    QCOMPARE(shown.moved.count(), 0);  // not yet complete
    QTest::keyClick(&shown.f, Qt::Key_Return);
    QCOMPARE(shown.started.count(), 1);
    QCOMPARE(shown.moved.count(), 1);
    QCOMPARE(shown.finished.count(), 1);
    QCOMPARE(shown.editor.curve().points()[2].f, 0.55);
    QCOMPARE(shown.editor.curve().points()[2].s, 1.0 / 3);  // not the 0.333 that its box shows
  }

  void aNumberBeyondTheNeighbourStopsThereAndSaysSo() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(2);
    type(shown.s, "0.9");
    QCOMPARE(shown.editor.curve().points()[2].s, 0.745);
    QCOMPARE(shown.s.text(), "0.745");
    QVERIFY(shown.line.problem().contains("0.205 to 0.745"));
  }

  void aStepOfABoxIsOneMove() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(3);
    shown.s.setFocus();
    QTest::keyClick(&shown.s, Qt::Key_Up);
    QCOMPARE(shown.started.count(), 1);
    QCOMPARE(shown.finished.count(), 1);
    QCOMPARE(shown.editor.curve().points()[3].s, 0.76);
  }

  void theWheelOverABoxWithoutFocusChangesNothing() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(3);
    shown.editor.setFocus();
    const QPointF at(5, 5);
    QWheelEvent wheel(at, shown.f.mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&shown.f, &wheel);
    QCOMPARE(shown.moved.count(), 0);
    QVERIFY(!wheel.isAccepted());
  }

  void monotoneIsAskedForWithTheSamePoints() {
    Shown shown;
    QVERIFY(shown.ready());
    QSignalSpy chosen(&shown.panel, &FusionCurvePanel::monotoneChosen);
    QVERIFY(shown.monotone.isChecked());
    QTest::mouseClick(&shown.monotone, Qt::LeftButton, {}, {8, shown.monotone.height() / 2});
    QCOMPARE(chosen.count(), 1);
    const FCF wanted = chosen.first().first().value<FCF>();
    QVERIFY(!wanted.monotone());
    QCOMPARE(wanted.points(), fivePoints().points());
    QVERIFY(shown.monotone.isChecked());  // until the owner agrees
    shown.panel.setCurve(wanted);
    QVERIFY(!shown.monotone.isChecked());
  }

  void aRefusalShowsUntilTheNextAction() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.editor.setFocus();
    shown.editor.selectPoint(0);
    QTest::keyClick(&shown.editor, Qt::Key_Delete);
    QVERIFY(shown.line.problem().contains("first point stays"));
    QTest::keyClick(&shown.editor, Qt::Key_Up);
    QVERIFY(shown.line.problem().isEmpty());
    QTest::keyClick(&shown.editor, Qt::Key_Delete);
    QTest::mouseClick(&shown.button("presetHalf"), Qt::LeftButton);
    QVERIFY(shown.line.problem().isEmpty());
  }

  void noTextIsCutOffAtThreeHundredAndTwentyPixels() {
    Shown shown;
    QVERIFY(shown.ready());
    QVERIFY2(shown.panel.minimumSizeHint().width() <= 320,
             qPrintable(QString::number(shown.panel.minimumSizeHint().width())));
    Q_EMIT shown.editor.refused(
        "A fusion curve has at least four points. Add another one before you remove this.");
    QCoreApplication::processEvents();
    for (const QWidget* child : shown.panel.findChildren<QWidget*>()) {
      if (child->isVisible() && child->parentWidget() == &shown.panel) {
        QVERIFY2(child->width() >= child->minimumSizeHint().width(), qPrintable(child->objectName()));
        QVERIFY2(shown.panel.rect().contains(child->geometry()), qPrintable(child->objectName()));
      }
    }
    const auto* text = shown.line.findChild<QLabel*>("problemText");
    QVERIFY(text->height() >= text->heightForWidth(text->width()));
  }

  void everyControlHasANameAndATooltip() {
    Shown shown;
    for (const QWidget* child : shown.panel.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (child->focusPolicy() != Qt::NoFocus) {
        QVERIFY(!child->objectName().isEmpty());
        QVERIFY2(!child->toolTip().isEmpty(), qPrintable(child->objectName()));
      }
    }
  }
};

QTEST_MAIN(FusionCurvePanelTest)
#include "fusion_curve_panel_test.moc"
