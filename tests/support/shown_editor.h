#pragma once

#include <QSignalSpy>
#include <QtTest>

#include "widgets/curve/fusion_curve_editor.h"

namespace graftsman {

inline FCF fivePoints() {
  return FCF::through({{0, 0}, {0.2, 0.1}, {0.5, 0.8}, {0.75, 0.7}, {1, 1}}).value();
}

inline FCFPoint at(const FusionCurveEditor& editor, int point) {
  return editor.curve().points()[static_cast<std::size_t>(point)];
}

/// An editor on the screen with the focus, its signals caught.
struct ShownEditor {
  FusionCurveEditor editor;
  QSignalSpy started{&editor, &FusionCurveEditor::moveStarted};
  QSignalSpy moved{&editor, &FusionCurveEditor::moved};
  QSignalSpy finished{&editor, &FusionCurveEditor::moveFinished};
  QSignalSpy cancelled{&editor, &FusionCurveEditor::moveCancelled};
  QSignalSpy added{&editor, &FusionCurveEditor::pointAdded};
  QSignalSpy removed{&editor, &FusionCurveEditor::pointRemoved};
  QSignalSpy selection{&editor, &FusionCurveEditor::selectionChanged};
  QSignalSpy hovered{&editor, &FusionCurveEditor::sHovered};
  QSignalSpy refused{&editor, &FusionCurveEditor::refused};

  explicit ShownEditor(const FCF& curve = fivePoints(), QSize size = {560, 420}) {
    editor.resize(size);
    editor.setCurve(curve);
    editor.show();
    editor.activateWindow();
    editor.setFocus();
  }
  [[nodiscard]] bool ready() {
    return QTest::qWaitForWindowExposed(&editor) && QTest::qWaitFor([&] { return editor.hasFocus(); });
  }
  [[nodiscard]] QPoint pixel(const FCFPoint& point) const { return editor.position(point).toPoint(); }
  [[nodiscard]] QPoint pixelOf(int point) const { return pixel(at(editor, point)); }
  void press(const QPoint& where) { QTest::mousePress(&editor, Qt::LeftButton, {}, where); }
  void release(const QPoint& where) { QTest::mouseRelease(&editor, Qt::LeftButton, {}, where); }
  // QTest::mouseMove knows no modifiers.
  void move(const QPoint& to, Qt::KeyboardModifiers modifiers = {},
            Qt::MouseButtons buttons = Qt::LeftButton) {
    QMouseEvent event(QEvent::MouseMove, to, editor.mapToGlobal(to), Qt::NoButton, buttons, modifiers);
    QApplication::sendEvent(&editor, &event);
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&editor, key, modifiers); }
};

}  // namespace graftsman
