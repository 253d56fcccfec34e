#include "widgets/viewport/viewport.h"

#include <vtkAutoInit.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkOpenGLState.h>

#include <QEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "widgets/theme/theme.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/stand_in.h"
#include "widgets/viewport/viewport_scene.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace graftsman {
namespace {

constexpr int kRestMilliseconds = 150;  // before a slow frame with all faces

QSurfaceFormat surfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);  // QPainter clips with it
  format.setSamples(0);            // FXAA instead: multisampling makes translucent actors vanish
  return format;
}

void addLight(vtkRenderer& renderer, double x, double y, double z, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();  // the camera stands at (0, 0, 1) and looks at the origin
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer.AddLight(light);
}

}  // namespace

Viewport::Viewport(QWidget* parent) : QOpenGLWidget(parent), scene_(std::make_unique<Scene>()) {
  setObjectName("viewport");
  setAccessibleName(tr("3D view"));
  setFormat(surfaceFormat());
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAcceptDrops(true);
  setMinimumSize(120, 90);

  auto* window = scene_->window.Get();
  window->SetReadyForRendering(false);
  window->SetOwnContext(0);
  window->SetFrameBlitModeToNoBlit();
  window->SetMultiSamples(0);
  // A forward-compatible context draws every line 1 px wide, whatever the driver says: VTK is to widen them.
  window->SetForceMaximumHardwareLineWidth(1);
  window->AddRenderer(scene_->renderer);
  answerWindow();

  vtkRenderer& renderer = *scene_->renderer;
  renderer.SetUseFXAA(true);
  renderer.SetGradientBackground(true);
  renderer.SetAutomaticLightCreation(false);
  addLight(renderer, -0.4, 0.5, 1, 0.8);
  addLight(renderer, 0.7, -0.5, 0.8, 0.35);
  renderer.GetActiveCamera()->SetViewAngle(CameraView::kAngle * 180 / std::numbers::pi);
  setBackground();

  scene_->rest.setSingleShot(true);
  scene_->rest.setInterval(kRestMilliseconds);
  connect(&scene_->rest, &QTimer::timeout, this, [this] {
    scene_->rested = true;
    update();
  });
  prepareGlide();
}

Viewport::~Viewport() {
  disconnect(scene_->contextEnds);
  scene_->glide.stop();
  releaseContext();
  scene_->window->RemoveAllObservers();
}

void Viewport::answerWindow() {
  vtkNew<vtkCallbackCommand> answer;
  answer->SetClientData(this);
  answer->SetCallback([](vtkObject*, unsigned long event, void* client, void* answered) {
    auto& self = *static_cast<Viewport*>(client);
    switch (event) {
      case vtkCommand::WindowMakeCurrentEvent:
        // Only when it is not: Qt would also bind its own framebuffer, in the middle of VTK's work.
        if (QOpenGLContext::currentContext() != self.context()) {
          self.makeCurrent();
        }
        break;
      case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool*>(answered) =
            self.context() != nullptr && QOpenGLContext::currentContext() == self.context();
        break;
      case vtkCommand::WindowSupportsOpenGLEvent:
      case vtkCommand::WindowIsDirectEvent:
        *static_cast<int*>(answered) = 1;
        break;
      default:  // WindowFrameEvent
        if (!self.scene_->painting) {
          self.renderLater();
        }
    }
  });
  for (const auto event : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                           vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowIsDirectEvent,
                           vtkCommand::WindowFrameEvent}) {
    scene_->window->AddObserver(event, answer);
  }
}

void Viewport::initializeGL() {
  disconnect(scene_->contextEnds);
  scene_->contextEnds =
      connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseContext);
  scene_->stale = true;
  scene_->window->SetReadyForRendering(true);
  scene_->window->OpenGLInit();
  scene_->window->GetState()->Reset();
  scene_->window->GetState()->vtkglDepthFunc(GL_LEQUAL);
}

void Viewport::releaseContext() {
  if (isValid()) {
    makeCurrent();
    scene_->window->Finalize();
    doneCurrent();
  }
  scene_->window->SetReadyForRendering(false);
}

void Viewport::resizeGL(int /*width*/, int /*height*/) {
  keepFramed();
}

Camera Viewport::camera() const {
  return scene_->camera;
}

void Viewport::setCamera(const Camera& camera) {
  scene_->glide.stop();
  scene_->camera = scene_->shown = camera;
  scene_->framed = false;
  scene_->wheelAnchor.reset();
  update();
}

void Viewport::setNavigation(Navigation navigation) {
  scene_->navigation = navigation;
}

Navigation Viewport::navigation() const {
  return scene_->navigation;
}

void Viewport::frameScene() {
  double b[6];
  scene_->renderer->ComputeVisiblePropBounds(b);
  if (b[0] > b[1]) {
    return;
  }
  setCamera(view().framing({Point(b[0], b[2], b[4]), Point(b[1], b[3], b[5])}));
  scene_->framed = true;
}

void Viewport::keepFramed() {
  if (scene_->framed) {
    frameScene();
  }
}

void Viewport::aim(const Camera& camera) {
  setCamera(camera);
  scene_->framed = true;
  frameScene();
}

void Viewport::frameAll() {
  frameScene();
  if (scene_->framed) {
    Q_EMIT cameraChanged(scene_->camera);
  }
}

void Viewport::lookFrom(AxisView view) {
  moveCamera(lookingFrom(scene_->camera, view));
}

void Viewport::setBusy(std::optional<double> progress) {
  scene_->progress = progress;
  update();
}

void Viewport::setPreparing(bool preparing) {
  scene_->preparing = preparing;
  update();
}

QPointF Viewport::screenPosition(const Point& point) const {
  return view().project(point);
}

vtkRenderer* Viewport::renderer() const {
  return scene_->renderer;
}

void Viewport::renderLater() {
  scene_->stale = true;
  update();
}

void Viewport::repaintLater() {
  update();
}

CameraView Viewport::view() const {
  return {scene_->camera, QSizeF(size()), devicePixelRatioF()};
}

std::optional<Point> Viewport::surfaceAt(const QPointF& position) const {
  if (!isValid()) {
    return {};
  }
  const CameraView now = view();
  const int x = static_cast<int>(std::floor(position.x() * now.ratio));
  const int y = scene_->window->GetSize()[1] - 1 - static_cast<int>(std::floor(position.y() * now.ratio));
  vtkGenericOpenGLRenderWindow& window = *scene_->window;
  window.MakeCurrent();
  window.GetState()->Reset();
  window.GetState()->Push();
  const double z = scene_->renderer->GetZ(x, y);
  window.GetState()->Pop();
  if (z >= 1) {
    return {};
  }
  double range[2];
  scene_->renderer->GetActiveCamera()->GetClippingRange(range);
  const double depth = range[0] * range[1] / (range[1] - z * (range[1] - range[0]));
  return now.onPlane(position, now.camera.position + depth * now.forward());
}

void Viewport::setBackground() {
  const Theme theme = themeFor(palette());
  const QColor& top = theme.backgroundTop;
  const QColor& bottom = theme.backgroundBottom;
  scene_->renderer->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  scene_->renderer->SetBackground2(top.redF(), top.greenF(), top.blueF());
}

void Viewport::prepareFrame(const CameraView& /*view*/) {}

std::vector<StandIn*> Viewport::standIns() const {
  return {};
}

void Viewport::paintOver(QPainter& /*painter*/, const CameraView& /*view*/) {}

void Viewport::applyTheme(const Theme& /*theme*/) {}

}  // namespace graftsman

#include "moc_viewport.cpp"  // NOLINT(bugprone-suspicious-include)
