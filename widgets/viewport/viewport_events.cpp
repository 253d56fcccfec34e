// The mouse, the wheel, the keyboard's focus, drops and the palette of a Viewport.
#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QStyle>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/theme/theme.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/viewport_scene.h"

namespace graftsman {
namespace {

constexpr double kRadiansPerPixel = std::numbers::pi / 450;
constexpr double kZoomPerPixel = 0.008;      // natural logarithm of the factor
constexpr double kZoomPerNotch = 0.16;       // likewise
constexpr double kDegreesPerNotch = 15 * 8;  // QWheelEvent counts eighths
constexpr int kGlideMilliseconds = 150;

std::optional<CameraDrag> cameraDrag(Navigation navigation, Qt::MouseButton button,
                                     Qt::KeyboardModifiers modifiers) {
  if (navigation == Navigation::Maya && modifiers.testFlag(Qt::AltModifier)) {
    switch (button) {
      case Qt::LeftButton:
        return CameraDrag::Orbit;
      case Qt::MiddleButton:
        return CameraDrag::Pan;
      case Qt::RightButton:
        return CameraDrag::Zoom;
      default:
        return {};
    }
  }
  if (button != Qt::MiddleButton) {
    return {};
  }
  if (navigation == Navigation::Maya) {
    return CameraDrag::Orbit;
  }
  if (modifiers.testFlag(Qt::ControlModifier)) {
    return CameraDrag::Zoom;
  }
  const bool shift = modifiers.testFlag(Qt::ShiftModifier);
  return shift == (navigation == Navigation::Blender) ? CameraDrag::Pan : CameraDrag::Orbit;
}

/// The first file of this machine among what is dragged; empty: none.
QString localFile(const QMimeData& data) {
  for (const QUrl& url : data.urls()) {
    if (url.isLocalFile()) {
      return url.toLocalFile();
    }
  }
  return {};
}

bool draggedFar(const QPointF& from, const QPointF& to) {
  const QPointF moved = to - from;
  return std::hypot(moved.x(), moved.y()) > kDragDistance;
}

}  // namespace

void Viewport::prepareGlide() {
  scene_->glide.setStartValue(0.0);
  scene_->glide.setEndValue(1.0);
  connect(&scene_->glide, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    const double t = value.toDouble();
    const Camera& from = scene_->glideStart;
    const Camera& to = scene_->camera;
    scene_->shown = to;
    scene_->shown.position = (1 - t) * from.position + t * to.position;
    scene_->shown.pivot = (1 - t) * from.pivot + t * to.pivot;
    update();
  });
}

void Viewport::glideTo(const Camera& camera) {
  endGlide();
  scene_->glideStart = scene_->shown;
  scene_->camera = camera;
  scene_->framed = false;
  scene_->glide.setDuration(
      std::min(kGlideMilliseconds, style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this)));
  scene_->glide.start();
  Q_EMIT cameraChanged(camera);
}

void Viewport::endGlide() {
  if (scene_->glide.state() == QAbstractAnimation::Running) {
    scene_->glide.stop();
    scene_->shown = scene_->camera;
    update();
  }
}

void Viewport::moveCamera(const Camera& camera) {
  if (camera == scene_->camera) {
    return;
  }
  setCamera(camera);
  Q_EMIT cameraChanged(camera);
}

void Viewport::zoomAt(const QPointF& position, double factor) {
  std::optional<WheelAnchor>& anchor = scene_->wheelAnchor;
  if (!anchor || anchor->position != position) {
    const CameraView now = view();
    anchor = WheelAnchor{position, surfaceAt(position).value_or(now.onPlane(position, now.camera.pivot))};
  }
  const WheelAnchor kept = *anchor;
  moveCamera(zoomed(scene_->camera, kept.point, factor));
  scene_->wheelAnchor = kept;  // zooming about it leaves it under the pointer
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  endGlide();
  event->ignore();
  scene_->focusShown = false;
  update();
  if (scene_->navigating) {
    event->accept();
    return;
  }
  const auto drag = cameraDrag(scene_->navigation, event->button(), event->modifiers());
  if (drag) {
    const QPointF at = event->position();
    const CameraView now = view();
    scene_->navigating = Navigating{*drag, event->button(), now.camera, at,
                                    surfaceAt(at).value_or(now.onPlane(at, now.camera.pivot))};
    event->accept();
  } else if (event->button() == Qt::RightButton) {
    scene_->menuPress = event->position();
    event->accept();
  }
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  event->ignore();
  if (scene_->menuPress && draggedFar(*scene_->menuPress, event->position())) {
    scene_->menuPress.reset();
  }
  if (scene_->navigating) {
    navigate(event->position());
    event->accept();
  } else if (event->buttons().testFlag(Qt::RightButton)) {
    event->accept();
  }
}

void Viewport::navigate(const QPointF& position) {
  const Navigating& drag = *scene_->navigating;
  const QPointF by = position - drag.pressedAt;
  switch (drag.drag) {
    case CameraDrag::Orbit:
      moveCamera(orbited(drag.start, by.x() * kRadiansPerPixel, by.y() * kRadiansPerPixel));
      break;
    case CameraDrag::Pan: {
      const CameraView start{drag.start, QSizeF(size()), devicePixelRatioF()};
      moveCamera(moved(drag.start, drag.anchor - start.onPlane(position, drag.anchor)));
      break;
    }
    case CameraDrag::Zoom:
      moveCamera(zoomed(drag.start, drag.anchor, std::exp(by.y() * kZoomPerPixel)));
      break;
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  event->ignore();
  if (scene_->navigating) {
    if (event->button() == scene_->navigating->button) {
      scene_->navigating.reset();
    }
    event->accept();
  } else if (event->button() == Qt::RightButton) {
    if (scene_->menuPress) {
      scene_->menuPress.reset();
      Q_EMIT contextMenuWanted(event->globalPosition().toPoint());
    }
    event->accept();
  }
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool plain = event->modifiers() == Qt::NoModifier;
  if (plain && (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton)) {
    endGlide();
    if (const auto point = surfaceAt(event->position())) {
      glideTo(moved(scene_->camera, *point - scene_->camera.pivot));
      event->accept();
      return;
    }
  }
  mousePressEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
  endGlide();
  const int turned = event->angleDelta().y();
  const double zoom =
      turned != 0 ? kZoomPerNotch * turned / kDegreesPerNotch : kZoomPerPixel * event->pixelDelta().y();
  if (zoom != 0 && !scene_->navigating) {
    zoomAt(event->position(), std::exp(-zoom));
  }
  event->accept();
}

bool Viewport::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
    if (gesture.gestureType() == Qt::ZoomNativeGesture && gesture.value() > -1) {
      endGlide();
      zoomAt(gesture.position(), 1 / (1 + gesture.value()));
      event->accept();
      return true;
    }
  }
  return QOpenGLWidget::event(event);
}

void Viewport::contextMenuEvent(QContextMenuEvent* event) {
  // The mouse's own comes with the release, after it is known that nothing was dragged.
  if (event->reason() == QContextMenuEvent::Keyboard) {
    Q_EMIT contextMenuWanted(mapToGlobal(rect().center()));
  }
  event->accept();
}

void Viewport::setDropHighlighted(bool highlighted) {
  scene_->dropHighlighted = highlighted;
  update();
}

void Viewport::dragEnterEvent(QDragEnterEvent* event) {
  if (!localFile(*event->mimeData()).isEmpty()) {
    event->acceptProposedAction();
    setDropHighlighted(true);
  }
}

void Viewport::dragLeaveEvent(QDragLeaveEvent* /*event*/) {
  setDropHighlighted(false);
}

void Viewport::dropEvent(QDropEvent* event) {
  setDropHighlighted(false);
  const QString path = localFile(*event->mimeData());
  if (!path.isEmpty()) {
    event->acceptProposedAction();
    Q_EMIT fileDropped(path);
  }
}

void Viewport::focusInEvent(QFocusEvent* event) {
  QOpenGLWidget::focusInEvent(event);
  scene_->focusShown = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
                       event->reason() == Qt::ShortcutFocusReason;
  update();
}

void Viewport::focusOutEvent(QFocusEvent* event) {
  QOpenGLWidget::focusOutEvent(event);
  scene_->focusShown = false;
  update();
}

void Viewport::changeEvent(QEvent* event) {
  QOpenGLWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) {
    setBackground();
    applyTheme(themeFor(palette()));
    renderLater();
  }
}

}  // namespace graftsman
