// What a frame of a Viewport is made of, on the screen and as a picture.
#include <vtkCamera.h>
#include <vtkOpenGLState.h>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <algorithm>

#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/stand_in.h"
#include "widgets/viewport/viewport_scene.h"

namespace graftsman {
namespace {

constexpr double kDimming = 0.1;
constexpr int kProgressHeight = 2;
constexpr int kFrameWidth = 2;
// A frame that takes longer is felt: where one with all faces does, they come after a rest.
constexpr double kQuickMilliseconds = 30;

}  // namespace

void Viewport::paintGL() {
  CameraView shown = view();
  shown.camera = scene_->shown;
  const bool slow = !scene_->allMilliseconds || *scene_->allMilliseconds > kQuickMilliseconds;
  paintFrame(shown, defaultFramebufferObject(), slow && !scene_->rested ? Detail::Quick : Detail::All);
  scene_->rested = false;
  // Not on `this`: within grab() that would paint on the grabbed image, below this frame.
  QOpenGLPaintDevice device((shown.size * shown.ratio).toSize());
  device.setDevicePixelRatio(shown.ratio);
  QPainter painter(&device);
  paintOver(painter, shown);
  paintState(painter);
}

void Viewport::paintFrame(const CameraView& shown, unsigned int framebuffer, Detail detail) {
  scene_->painting = true;
  vtkGenericOpenGLRenderWindow& window = *scene_->window;
  const QSize pixels = (shown.size * shown.ratio).toSize();
  const bool resized = window.GetSize()[0] != pixels.width() || window.GetSize()[1] != pixels.height();
  if (resized) {
    window.SetSize(pixels.width(), pixels.height());
  }
  vtkOpenGLState& state = *window.GetState();
  state.Reset();
  state.Push();
  state.vtkglDepthFunc(GL_LEQUAL);
  state.vtkglEnable(GL_DEPTH_TEST);
  // The last frame is still there: a scene of a million faces is not drawn again for a mark on it.
  if (scene_->stale || resized || !(scene_->drawnFrom == shown.camera) ||
      (scene_->drawnQuick && detail == Detail::All)) {
    drawScene(shown, detail);
  }
  state.vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  window.BlitDisplayFramebuffer();
  state.Pop();

  // The desktop must not shine through where translucent actors left an alpha below 1.
  QOpenGLExtraFunctions& gl = *context()->extraFunctions();
  gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.glBindVertexArray(0);
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.glClearColor(0, 0, 0, 1);
  gl.glClear(GL_COLOR_BUFFER_BIT);
  gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.glDisable(GL_DEPTH_TEST);
  scene_->painting = false;
}

void Viewport::drawScene(const CameraView& shown, Detail detail) {
  prepareFrame(shown);
  vtkCamera& camera = *scene_->renderer->GetActiveCamera();
  camera.SetPosition(shown.camera.position.data());
  camera.SetFocalPoint(shown.camera.pivot.data());
  camera.SetViewUp(shown.up().data());
  scene_->renderer->ResetCameraClippingRange();
  std::vector<StandIn*> standIns = this->standIns();
  std::erase_if(standIns, [](const StandIn* standIn) { return !standIn->useful(); });
  scene_->drawnQuick = detail == Detail::Quick && !standIns.empty();
  if (scene_->drawnQuick) {
    std::ranges::for_each(standIns, &StandIn::replace);
    scene_->window->Render();
    std::ranges::for_each(standIns, &StandIn::restore);
    scene_->rest.start();
  } else {
    QElapsedTimer clock;
    clock.start();
    scene_->window->Render();
    if (!standIns.empty()) {
      context()->functions()->glFinish();
      scene_->allMilliseconds = static_cast<double>(clock.nsecsElapsed()) / 1e6;
    }
  }
  scene_->stale = false;
  scene_->drawnFrom = shown.camera;
}

void Viewport::paintState(QPainter& painter) const {
  const QColor highlight = palette().color(QPalette::Highlight);
  if (scene_->progress || scene_->preparing) {
    painter.fillRect(rect(), QColor::fromRgbF(0, 0, 0, kDimming));
  }
  if (scene_->progress) {
    painter.fillRect(QRectF(0, 0, width() * *scene_->progress, kProgressHeight), highlight);
  }
  if (scene_->dropHighlighted || scene_->focusShown) {
    const int w = scene_->dropHighlighted ? 2 * kFrameWidth : kFrameWidth;
    painter.fillRect(0, 0, width(), w, highlight);
    painter.fillRect(0, height() - w, width(), w, highlight);
    painter.fillRect(0, w, w, height() - 2 * w, highlight);
    painter.fillRect(width() - w, w, w, height() - 2 * w, highlight);
  }
  if (scene_->dropHighlighted) {
    QColor veil = highlight;
    veil.setAlphaF(0.15F);
    painter.fillRect(rect(), veil);
  }
}

QImage Viewport::picture(std::optional<QSize> size) {
  if (!isValid()) {
    (void)grabFramebuffer();  // makes the context
  }
  if (!isValid()) {
    return {};
  }
  CameraView shown = view();
  shown.camera = scene_->camera;
  const QSize pixels = size.value_or((shown.size * shown.ratio).toSize());
  shown.size = QSizeF(pixels) / shown.ratio;

  makeCurrent();
  QImage image;
  {
    QOpenGLFramebufferObject target(pixels, QOpenGLFramebufferObject::CombinedDepthStencil);
    paintFrame(shown, target.handle(), Detail::All);
    target.bind();
    {
      QOpenGLPaintDevice device(pixels);
      device.setDevicePixelRatio(shown.ratio);
      QPainter painter(&device);
      paintOver(painter, shown);
    }
    target.release();
    image = target.toImage().convertToFormat(QImage::Format_RGB32);
  }
  doneCurrent();
  update();
  return image;
}

}  // namespace graftsman
