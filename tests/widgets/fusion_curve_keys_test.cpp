#include <QAction>
#include <QMainWindow>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/shown_editor.h"
#include "widgets/curve/fusion_curve_editor.h"

using namespace graftsman;

class FusionCurveKeysTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void insertAddsAPointAfterTheSelectedOne() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(1);
    shown.key(Qt::Key_Insert);
    QCOMPARE(shown.added.count(), 1);
    QCOMPARE(shown.editor.selectedPoint(), 2);
    QCOMPARE(at(shown.editor, 2).s, 0.35);
  }

  void thereIsNoRoomForAPointRightBesideAnother() {
    ShownEditor shown(FCF::through({{0, 0}, {0.5, 0.5}, {0.507, 0.6}, {1, 1}}).value());
    QVERIFY(shown.ready());
    shown.editor.selectPoint(1);
    shown.key(Qt::Key_Insert);
    QCOMPARE(shown.added.count(), 0);
    QCOMPARE(shown.refused.count(), 1);
    QVERIFY(shown.refused.first().first().toString().contains("room"));
  }

  void deleteAndBackspaceRemoveTheSelectedPoint() {
    for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
      ShownEditor shown;
      QVERIFY(shown.ready());
      shown.editor.selectPoint(2);
      shown.key(key);
      QCOMPARE(shown.removed.count(), 1);
      QCOMPARE(shown.removed.first().at(0).toInt(), 2);
      QCOMPARE(shown.editor.curve().points().size(), 4U);
      QCOMPARE(at(shown.editor, 2).s, 0.75);
    }
  }

  void fewerThanFourPointsAreRefusedWithASentence() {
    ShownEditor shown{FCF()};
    QVERIFY(shown.ready());
    shown.editor.selectPoint(1);
    shown.key(Qt::Key_Delete);
    QCOMPARE(shown.removed.count(), 0);
    QCOMPARE(shown.refused.count(), 1);
    QVERIFY(shown.refused.first().first().toString().contains("four points"));
    QVERIFY(shown.editor.curve() == FCF());
  }

  void anEndPointIsNeitherRemovedNorMovedSideways() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    for (const int end : {0, 4}) {
      shown.editor.selectPoint(end);
      shown.key(Qt::Key_Delete);
      shown.key(end == 0 ? Qt::Key_Right : Qt::Key_Left);
    }
    QCOMPARE(shown.removed.count(), 0);
    QCOMPARE(shown.moved.count(), 0);
    QCOMPARE(shown.refused.count(), 4);
    QVERIFY(shown.refused.at(0).first().toString().contains("first point stays"));
    QVERIFY(shown.refused.at(3).first().toString().contains("only its f can change"));
  }

  void arrowKeysMoveByOneHundredthATenthOrAThousandth() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(2);
    shown.key(Qt::Key_Right);
    QCOMPARE(at(shown.editor, 2).s, 0.51);
    shown.key(Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(at(shown.editor, 2).f, 0.7);
    shown.key(Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(at(shown.editor, 2).s, 0.509);
    shown.key(Qt::Key_Up);
    QCOMPARE(at(shown.editor, 2).f, 0.71);
    QCOMPARE(shown.started.count(), 4);
    QCOMPARE(shown.finished.count(), 4);
  }

  void aHeldArrowKeyIsOneMove() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(2);
    const auto repeat = [&](QEvent::Type type, bool again) {
      QKeyEvent event(type, Qt::Key_Right, {}, {}, again);
      QApplication::sendEvent(&shown.editor, &event);
    };
    repeat(QEvent::KeyPress, false);
    for (int i = 0; i < 5; ++i) {
      repeat(QEvent::KeyRelease, true);  // as X11 reports a repeated key
      repeat(QEvent::KeyPress, true);
    }
    QCOMPARE(shown.started.count(), 1);
    QCOMPARE(shown.moved.count(), 6);
    QCOMPARE(shown.finished.count(), 0);
    repeat(QEvent::KeyRelease, false);
    QCOMPARE(shown.finished.count(), 1);
    QCOMPARE(at(shown.editor, 2).s, 0.56);
  }

  void losingTheFocusEndsAKeysMove() {
    QWidget window;
    auto* editor = new FusionCurveEditor(&window);
    auto* other = new QWidget(&window);
    other->setFocusPolicy(Qt::StrongFocus);
    window.resize(500, 400);
    editor->resize(400, 400);
    window.show();
    window.activateWindow();
    editor->setFocus();
    QVERIFY(QTest::qWaitFor([&] { return editor->hasFocus(); }));
    editor->selectPoint(1);
    QSignalSpy finished(editor, &FusionCurveEditor::moveFinished);
    QTest::keyPress(editor, Qt::Key_Up);
    QCOMPARE(finished.count(), 0);
    other->setFocus();
    QCOMPARE(finished.count(), 1);
  }

  void escapeTakesAHeldKeysMoveBack() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(2);
    QTest::keyPress(&shown.editor, Qt::Key_Up);
    shown.key(Qt::Key_Escape);
    QCOMPARE(shown.cancelled.count(), 1);
    QVERIFY(shown.editor.curve() == fivePoints());
  }

  void keysGoFromPointToPoint() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    std::vector<int> seen;
    for (const Qt::Key key :
         {Qt::Key_Home, Qt::Key_PageDown, Qt::Key_PageDown, Qt::Key_PageUp, Qt::Key_End, Qt::Key_PageDown}) {
      shown.key(key);
      seen.push_back(shown.editor.selectedPoint());
    }
    QCOMPARE(seen, (std::vector<int>{0, 1, 2, 1, 4, 4}));
    QCOMPARE(shown.selection.count(), 5);
  }

  void aShortcutOfTheWindowDoesNotTakeDeleteAway() {
    QMainWindow window;
    auto* editor = new FusionCurveEditor;
    window.setCentralWidget(editor);
    QAction remove("Delete");
    remove.setShortcut(Qt::Key_Delete);
    window.addAction(&remove);
    window.show();
    window.activateWindow();
    editor->setFocus();
    QVERIFY(QTest::qWaitFor([&] { return editor->hasFocus(); }));
    editor->setCurve(fivePoints());
    editor->selectPoint(2);
    QSignalSpy removed(editor, &FusionCurveEditor::pointRemoved);
    QSignalSpy triggered(&remove, &QAction::triggered);
    QTest::keyClick(window.windowHandle(), Qt::Key_Delete);
    QCOMPARE(removed.count(), 1);
    QCOMPARE(triggered.count(), 0);
  }

  void aMoveByNumbersIsWhole() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.editor.movePoint(2, {0.5, 0.25});
    QCOMPARE(shown.started.count(), 1);
    QCOMPARE(shown.moved.count(), 1);
    QCOMPARE(shown.finished.count(), 1);
    QCOMPARE(at(shown.editor, 2).f, 0.25);
    shown.editor.movePoint(2, {0.9, 0.25});
    QCOMPARE(at(shown.editor, 2).s, 0.745);
    QCOMPARE(shown.refused.count(), 1);
    QVERIFY(shown.refused.first().first().toString().contains("0.205 to 0.745"));
  }

  void theSelectedPointsNumbersAreReadOut() {
    ShownEditor shown;
    QVERIFY(shown.ready());
    shown.editor.selectPoint(2);
    QCOMPARE(shown.editor.accessibleDescription(), "5 points, point 2 selected: s 0.500, f 0.800");
    shown.key(Qt::Key_Right);
    QVERIFY(shown.editor.accessibleDescription().contains("s 0.510"));
  }
};

QTEST_MAIN(FusionCurveKeysTest)
#include "fusion_curve_keys_test.moc"
