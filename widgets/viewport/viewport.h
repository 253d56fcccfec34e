#pragma once

#include <Eigen/Core>
#include <QOpenGLWidget>
#include <memory>
#include <optional>

#include "core/mesh/triangle_mesh.h"

class vtkRenderer;

namespace graftsman {

/// Which buttons orbit, pan and zoom. The left button alone always picks and drags; the right one only ever
/// opens the context menu; the wheel zooms to the cursor in all of them.
enum class Navigation {
  Blender,  // middle: orbit; Shift+middle: pan; Ctrl+middle: zoom
  Cad,      // middle: pan; Shift+middle: orbit; Ctrl+middle: zoom (as FreeCAD's CAD style and its kin)
  Maya,     // Alt+left: orbit; Alt+middle: pan; Alt+right: zoom (middle alone: orbit)
};

/// A view along an axis; z is up. Front looks along +y.
enum class AxisView { Front, Back, Left, Right, Top, Bottom };

/// Where a pane looks from. Model length; not part of the document and never undone.
struct Camera {
  Point position = {0, -1, 0};
  Point pivot = Point::Zero();  // what the camera looks at and orbits about
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  friend bool operator==(const Camera&, const Camera&) = default;
};

/// A pane with a VTK scene and a camera (INTERFACE.md, DISPLAY.md). Its subclasses fill the scene.
class Viewport : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  [[nodiscard]] Camera camera() const;
  /// Sets it without cameraChanged().
  void setCamera(const Camera& camera);
  void setNavigation(Navigation navigation);

  /// Moves the camera along its direction until all of the scene is in view. F.
  void frameAll();
  void lookFrom(AxisView view);

  /// Something is being computed for what is shown: dimmed by 10 %, with a thin progress line at the top.
  /// nullopt: done.
  void setBusy(std::optional<double> progress);

  /// Where a point of the scene is seen, in the widget's device-independent coordinates (for tests and
  /// pictures).
  [[nodiscard]] QPointF screenPosition(const Point& point) const;

  /// A picture of the pane as shown, `size` in pixels (the pane's own without it).
  [[nodiscard]] QImage picture(std::optional<QSize> size = {});

 Q_SIGNALS:
  /// The person moved the camera.
  void cameraChanged(const graftsman::Camera& camera);
  /// The right button was clicked, not dragged.
  void contextMenuWanted(const QPoint& globalPosition);
  /// A file was dropped on the pane.
  void fileDropped(const QString& path);

 protected:
  [[nodiscard]] vtkRenderer* renderer() const;
  /// Asks for a new frame.
  void renderLater();

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace graftsman
