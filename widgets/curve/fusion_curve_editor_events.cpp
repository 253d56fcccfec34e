#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>

#include "widgets/curve/curve_plot.h"
#include "widgets/curve/fusion_curve_editor.h"

// What a mouse and a keyboard say, turned into the editor's edits.

namespace graftsman {
namespace {

constexpr double kSnapToCurve = 12;  // pixels; a point added closer to the curve than this lies on it

bool isArrowKey(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool isOurs(const QKeyEvent& event, bool moving) {
  switch (event.key()) {
    case Qt::Key_Escape:
      return moving;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_Insert:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Home:
    case Qt::Key_End:
      return (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    default:
      return isArrowKey(event.key()) && !event.modifiers().testFlag(Qt::AltModifier);
  }
}

}  // namespace

bool FusionCurveEditor::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      isOurs(*static_cast<QKeyEvent*>(event), move_.has_value())) {
    event->accept();  // or a shortcut of the window ("Delete") would take the key
    return true;
  }
  if (event->type() == QEvent::ToolTip && guide_) {
    return true;  // it would cover the curve under the pointer; beside the plot it shows
  }
  return QWidget::event(event);
}

void FusionCurveEditor::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    QWidget::mousePressEvent(event);
    return;
  }
  press(pointAt(event->position()), event->position());
  hover(event->position());
}

void FusionCurveEditor::mouseMoveEvent(QMouseEvent* event) {
  if (move_ && !move_->byKeys) {
    if (event->buttons().testFlag(Qt::LeftButton)) {
      drag(event->position(), event->modifiers());
    } else {
      endMove();  // the release went elsewhere
    }
  }
  hover(event->position());
}

void FusionCurveEditor::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    QWidget::mouseReleaseEvent(event);
    return;
  }
  if (move_ && !move_->byKeys) {
    endMove();
  }
  hover(event->position());
}

void FusionCurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    return;
  }
  const QPointF at = event->position();
  if (const int point = pointAt(at); point >= 0) {
    press(point, at);
    return;
  }
  const CurvePlot plot = plotIn(size(), font());
  if (!plot.area.contains(at)) {
    return;
  }
  const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
  FCFPoint wanted = plot.toCurve(at);
  const double onCurve = curve_(wanted.s);
  if (std::abs(onCurve - wanted.f) * plot.area.height() < kSnapToCurve) {
    wanted.f = onCurve;
  }
  if (addPoint({rounded(wanted.s), rounded(wanted.f)})) {
    press(selected_, at);  // it can be dragged on without letting go
    hover(at);
  }
}

void FusionCurveEditor::leaveEvent(QEvent* event) {
  leave();
  QWidget::leaveEvent(event);
}

void FusionCurveEditor::keyPressEvent(QKeyEvent* event) {
  if (!isOurs(*event, move_.has_value())) {
    QWidget::keyPressEvent(event);
    return;
  }
  const int last = static_cast<int>(curve_.points().size()) - 1;
  const double step = event->modifiers().testFlag(Qt::ControlModifier) ? 0.001
                      : event->modifiers().testFlag(Qt::ShiftModifier) ? 0.1
                                                                       : 0.01;
  switch (event->key()) {
    case Qt::Key_Escape:
      return cancelMove();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return selected_ >= 0 ? removeSelectedPoint() : void();
    case Qt::Key_Insert:
      return addPointAfterSelected();
    case Qt::Key_PageUp:
      return selectPoint(selected_ > 0 ? selected_ - 1 : 0);
    case Qt::Key_PageDown:
      return selectPoint(selected_ < last ? selected_ + 1 : last);
    case Qt::Key_Home:
      return selectPoint(0);
    case Qt::Key_End:
      return selectPoint(last);
    case Qt::Key_Left:
      return nudge(-step, 0);
    case Qt::Key_Right:
      return nudge(step, 0);
    case Qt::Key_Up:
      return nudge(0, step);
    default:
      return nudge(0, -step);
  }
}

void FusionCurveEditor::keyReleaseEvent(QKeyEvent* event) {
  if (isArrowKey(event->key()) && !event->isAutoRepeat() && move_ && move_->byKeys) {
    endMove();
    return;
  }
  QWidget::keyReleaseEvent(event);
}

void FusionCurveEditor::focusInEvent(QFocusEvent* event) {
  const bool byKey = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  if (byKey && selected_ < 0) {
    selectPoint(0);
  }
  QWidget::focusInEvent(event);
}

void FusionCurveEditor::focusOutEvent(QFocusEvent* event) {
  if (move_ && move_->byKeys) {
    endMove();
  }
  QWidget::focusOutEvent(event);
}

void FusionCurveEditor::hideEvent(QHideEvent* event) {
  endMove();
  leave();
  QWidget::hideEvent(event);
}

void FusionCurveEditor::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange && !isEnabled()) {
    endMove();
    leave();
  }
  QWidget::changeEvent(event);
}

}  // namespace graftsman
