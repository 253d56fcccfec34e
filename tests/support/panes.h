#pragma once

#include <QMouseEvent>
#include <QtTest>

#include "core/fusion/update.h"
#include "tests/support/samples.h"
#include "widgets/viewport/mesh_pane.h"

/// Panes with content, and the events that Qt Test lacks.
namespace graftsman::panes {

/// What a pane shows of one side of a finished fusion.
inline LoopMarks marksOf(const FusionResults& results, Side side) {
  const SideResults& made = side == Side::Part ? results.part : results.base;
  LoopMarks marks;
  int number = 0;
  for (const CVP& pair : results.inputs.loop) {
    marks.cvs.push_back({side == Side::Part ? pair.part : pair.base, number++});
  }
  if (made.paths) {
    number = 0;
    for (const auto& path : made.paths->paths) {
      PathMark mark{{}, number++};
      for (const EdgePoint& point : path->points) {
        mark.points.push_back(position(*made.anchored->mesh, point));
      }
      marks.paths.push_back(std::move(mark));
    }
  }
  marks.tile = made.tile;
  return marks;
}

/// Turns the wheel at a place of the pane; one notch is 120, away from the person.
inline void turnWheel(QWidget& pane, const QPointF& position, int angle) {
  QWheelEvent event(position, pane.mapToGlobal(position), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&pane, &event);
}

/// Moves the pointer with a button held down.
inline void moveHeld(QWidget& pane, const QPointF& position, Qt::MouseButton button,
                     Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QMouseEvent event(QEvent::MouseMove, position, pane.mapToGlobal(position), Qt::NoButton, button, modifiers);
  QApplication::sendEvent(&pane, &event);
}

/// Moves the pointer with no button down.
inline void moveTo(QWidget& pane, const QPointF& position, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  moveHeld(pane, position, Qt::NoButton, modifiers);
}

/// Presses at one place, moves in steps to another, and releases.
inline void drag(QWidget& pane, const QPoint& from, const QPoint& to, Qt::MouseButton button,
                 Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QTest::mousePress(&pane, button, modifiers, from);
  for (int i = 1; i <= 4; ++i) {
    moveHeld(pane, from + (to - from) * i / 4.0, button, modifiers);
  }
  QTest::mouseRelease(&pane, button, modifiers, to);
}

/// Sets the mesh and waits until it is shown.
inline bool showMesh(MeshPane& pane, std::shared_ptr<const TriangleMesh> mesh) {
  QSignalSpy shown(&pane, &MeshPane::meshShown);
  pane.setMesh(std::move(mesh));
  return !shown.isEmpty() || shown.wait(20000);
}

inline QPalette darkPalette() {
  QPalette palette;
  palette.setColor(QPalette::Window, QColor("#2B2D30"));
  palette.setColor(QPalette::WindowText, Qt::white);
  palette.setColor(QPalette::Highlight, QColor("#4C9BE8"));
  return palette;
}

}  // namespace graftsman::panes
