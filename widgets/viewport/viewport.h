#pragma once

#include <Eigen/Core>
#include <QOpenGLWidget>
#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/triangle_mesh.h"

class vtkRenderer;

namespace graftsman {

/// The pointer moved further than this, in device-independent pixels, is a drag and no click.
inline constexpr double kDragDistance = 3;

class StandIn;
struct CameraView;
struct Theme;

/// Which buttons orbit, pan and zoom. The left button alone always picks and drags; the right one only ever
/// opens the context menu; the wheel zooms to the cursor in all of them.
enum class Navigation {
  Blender,  // middle: orbit; Shift+middle: pan; Ctrl+middle: zoom
  Cad,      // middle: pan; Shift+middle: orbit; Ctrl+middle: zoom (as FreeCAD's CAD style and its kin)
  Maya,     // Alt+left: orbit; Alt+middle: pan; Alt+right: zoom (middle alone: orbit)
};

/// A view along an axis of the scene. Where z is the camera's axis, front looks along +y; where y is, along
/// −z.
enum class AxisView { Front, Back, Left, Right, Top, Bottom };

/// Where a pane looks from. Model length; not part of the document and never undone.
struct Camera {
  Point position = {0, -1, 0};
  Point pivot = Point::Zero();                    // what the camera looks at and orbits about
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  // on the screen, as far as it is not along the view
  Eigen::Vector3d axis =
      Eigen::Vector3d::UnitZ();  // of length 1; what orbiting turns about, and keeps upright
  friend bool operator==(const Camera&, const Camera&) = default;
};

/// A pane with a VTK scene and a camera (INTERFACE.md, DISPLAY.md). Its subclasses fill the scene. Places on
/// the pane are those of mouse events: device-independent, a whole device pixel meaning that pixel's centre.
///
/// A double-click (left or middle) on what is shown makes that place the pivot; the view glides there, while
/// camera() and all picks are at once those of its end, and any other input ends the glide.
class Viewport : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  [[nodiscard]] Camera camera() const;
  /// Sets it without cameraChanged(). It stays, also where the scene is filled later.
  void setCamera(const Camera& camera);
  /// Turns the camera to look like that one and frames all, now and whenever the scene is filled anew, until
  /// somebody moves or sets the camera. Without cameraChanged().
  void aim(const Camera& camera);
  void setNavigation(Navigation navigation);
  [[nodiscard]] Navigation navigation() const;

  /// Moves the camera along its direction until all of the scene is in view; nothing without a scene. F.
  /// Until the camera is moved otherwise, a resized pane frames again.
  void frameAll();
  void lookFrom(AxisView view);

  /// Something is being computed for what is shown: dimmed by 10 %, with a thin progress line at the top.
  /// Progress in [0, 1]; nullopt: done.
  void setBusy(std::optional<double> progress);

  /// Where a point of the scene is seen: at its rounded place a mouse event is on it (for tests and
  /// pictures). Precondition: the point is before the camera.
  [[nodiscard]] QPointF screenPosition(const Point& point) const;

  /// A picture of the pane with all its faces, without what tells of progress, focus or a drop. `size` in
  /// pixels (the pane's own without it); lines and marks keep their size in pixels. Also of a pane that was
  /// never shown. Null image: the machine gives no OpenGL context.
  [[nodiscard]] QImage picture(std::optional<QSize> size = {});

 Q_SIGNALS:
  /// The person moved the camera (also by frameAll() and lookFrom()).
  void cameraChanged(const graftsman::Camera& camera);
  /// The right button was clicked, not dragged, or the menu key pressed.
  void contextMenuWanted(const QPoint& globalPosition);
  /// A file was dropped on the pane.
  void fileDropped(const QString& path);

 protected:
  [[nodiscard]] vtkRenderer* renderer() const;
  /// Lets the view glide to a camera that is the person's from now on.
  void glideTo(const Camera& camera);
  /// Asks for a new frame: the scene is another one.
  void renderLater();
  /// The same where only what paintOver() paints is another: the scene, which may be large, is not drawn
  /// again.
  void repaintLater();
  /// The camera with the pane's size.
  [[nodiscard]] CameraView view() const;
  /// frameAll() by the program: without cameraChanged().
  void frameScene();
  /// To be called after the scene was filled anew: frames it if the camera is still where framing left it.
  void keepFramed();
  /// Dims the scene while it shows what is about to be replaced.
  void setPreparing(bool preparing);

  /// The nearest point of what is shown at a place of the pane, or nullopt. By the depth that was last drawn;
  /// a pane that can cast a ray overrides it.
  [[nodiscard]] virtual std::optional<Point> surfaceAt(const QPointF& position) const;
  /// Called before the scene is drawn, also for a picture, with the camera that it is drawn with.
  virtual void prepareFrame(const CameraView& view);
  /// What is drawn instead of surfaces of many faces while frames must be quick; nothing without it.
  [[nodiscard]] virtual std::vector<StandIn*> standIns() const;
  /// Paints over the scene, in device-independent pixels, under what tells of progress, focus and drops.
  /// There is no multisampling: draw images where edges must be smooth.
  virtual void paintOver(QPainter& painter, const CameraView& view);
  /// The palette changed; the background is done already. Not called for the palette at construction.
  virtual void applyTheme(const Theme& theme);

  // A mouse event that the camera or the context menu takes is accepted here, any other is ignored: a
  // subclass calls this first, and acts on what is left.
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

 private:
  /// The person moves the camera.
  void moveCamera(const Camera& camera);
  void prepareGlide();
  void endGlide();
  void zoomAt(const QPointF& position, double factor);
  void navigate(const QPointF& position);
  void setDropHighlighted(bool highlighted);
  void setBackground();
  void answerWindow();
  void releaseContext();
  enum class Detail { Quick, All };
  void paintFrame(const CameraView& shown, unsigned int framebuffer, Detail detail);
  void drawScene(const CameraView& shown, Detail detail);
  void paintState(QPainter& painter) const;

  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace graftsman
