#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "widgets/panels/elided_label.h"
#include "widgets/panels/pane_frame.h"
#include "widgets/panels/problem_line.h"
#include "widgets/theme/contrast.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/viewport.h"

using namespace graftsman;

namespace {

struct Shown {
  Viewport* viewport = new Viewport;
  PaneFrame frame{"Part", themeFor(QPalette()).part, viewport};
  QToolButton& enlarge = *frame.findChild<QToolButton*>("enlarge");
  QPushButton& remedy = *frame.findChild<QPushButton*>("remedy");
  ElidedLabel& title = *frame.findChild<ElidedLabel*>("paneTitle");
  ProblemLine& line = *frame.findChild<ProblemLine*>("paneLine");
  QSignalSpy enlarged{&frame, &PaneFrame::enlargeToggled};
  QSignalSpy mended{&frame, &PaneFrame::remedyClicked};

  Shown() {
    frame.resize(480, 360);
    frame.show();
    frame.activateWindow();
  }
  [[nodiscard]] bool ready() { return QTest::qWaitForWindowActive(&frame); }
  [[nodiscard]] QString footer() const { return line.findChild<QLabel*>("problemText")->text(); }
};

}  // namespace

class PaneFrameTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theViewportIsItsChildAndFillsTheMiddle() {
    Shown shown;
    QVERIFY(shown.ready());
    QCOMPARE(shown.frame.viewport(), shown.viewport);
    QCOMPARE(shown.viewport->parentWidget(), &shown.frame);
    QCOMPARE(shown.viewport->width(), 480);
    QVERIFY(shown.viewport->height() > 280);
  }

  void theRoleIsReadableInItsColour() {
    for (const QColor& window : {QColor("#efefef"), QColor("#2d2f32")}) {
      PaneFrame frame("Base", {}, new Viewport);
      QPalette palette;
      palette.setColor(QPalette::Window, window);
      palette.setColor(QPalette::WindowText, readableOn(window));
      frame.setPalette(palette);
      frame.setRoleColour(themeFor(palette).base);
      const auto* role = frame.findChild<QLabel*>("paneRole");
      const QColor colour = role->palette().color(QPalette::WindowText);
      QVERIFY(contrast(colour, window) >= 4.5);
      QVERIFY(colour.blue() > colour.red());
      frame.setRoleColour({});
      QCOMPARE(role->palette().color(QPalette::WindowText), readableOn(window));
    }
  }

  void aLongTitleIsShortened() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.frame.setTitle("a.obj · 12 faces");
    QCOMPARE(shown.title.shownText(), "a.obj · 12 faces");
    const QString longName = QString("a-very-long-name-").repeated(12) + ".obj · 6,720 faces";
    shown.frame.setTitle(longName);
    QVERIFY(shown.title.shownText().contains("…"));
    QVERIFY(shown.title.shownText().endsWith("faces"));
    QCOMPARE(shown.frame.width(), 480);
    QVERIFY(shown.frame.minimumSizeHint().width() < 300);
  }

  void theEnlargeButtonTogglesAndTells() {
    Shown shown;
    QVERIFY(shown.ready());
    const QString before = shown.enlarge.toolTip();
    QTest::mouseClick(&shown.enlarge, Qt::LeftButton);
    QCOMPARE(shown.enlarged.last().first().toBool(), true);
    QVERIFY(shown.enlarge.toolTip() != before);
    QTest::keyClick(&shown.enlarge, Qt::Key_Space);
    QCOMPARE(shown.enlarged.last().first().toBool(), false);
    shown.frame.setEnlarged(true);
    QVERIFY(shown.enlarge.isChecked());
    QCOMPARE(shown.enlarged.count(), 2);
    shown.frame.setEnlargeable(false);
    QVERIFY(!shown.enlarge.isVisible());
  }

  void aProblemStandsInTheHintsPlace() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.frame.setHint("Click the next point on the part");
    QCOMPARE(shown.footer(), "Click the next point on the part");
    shown.frame.setProblem("The loop runs clockwise.", "Reverse");
    QCOMPARE(shown.footer(), "The loop runs clockwise.");
    QVERIFY(shown.line.findChild<QLabel*>("problemIcon")->isVisible());
    QVERIFY(shown.remedy.isVisible());
    QCOMPARE(shown.remedy.text(), "Reverse");
    shown.frame.setProblem("The region encloses a handle.", {});
    QVERIFY(!shown.remedy.isVisible());
    shown.frame.setProblem({}, {});
    QCOMPARE(shown.footer(), "Click the next point on the part");
    QVERIFY(!shown.line.findChild<QLabel*>("problemIcon")->isVisible());
  }

  void theRemedyIsChosenByMouseAndByKeyboard() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.frame.setProblem("The loop runs clockwise.", "Reverse");
    QTest::mouseClick(&shown.remedy, Qt::LeftButton);
    shown.enlarge.setFocus();
    for (int i = 0; i < 5 && !shown.remedy.hasFocus(); ++i) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QVERIFY(shown.remedy.hasFocus());
    QTest::keyClick(&shown.remedy, Qt::Key_Space);
    QCOMPARE(shown.mended.count(), 2);
  }

  void thePaneKeepsItsSizeWhenAShortProblemComes() {
    Shown shown;
    QVERIFY(shown.ready());
    shown.frame.setHint("Click the next point on the part");
    QCoreApplication::processEvents();
    const QSize before = shown.viewport->size();
    shown.frame.setProblem("The loop runs clockwise.", "Reverse");
    QCoreApplication::processEvents();
    QCOMPARE(shown.viewport->size(), before);
  }

  void aHeaderWidgetStandsLeftOfTheEnlargeButton() {
    Shown shown;
    QVERIFY(shown.ready());
    auto* box = new QComboBox;
    shown.frame.addHeaderWidget(box);
    QTRY_VERIFY(box->isVisible());
    QTRY_VERIFY(box->geometry().right() < shown.enlarge.geometry().left());
    QVERIFY(box->geometry().left() > shown.title.geometry().left());
  }
};

QTEST_MAIN(PaneFrameTest)
#include "pane_frame_test.moc"
