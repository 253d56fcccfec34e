#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QMetaObject>
#include <QPointF>
#include <QTimer>
#include <QVariantAnimation>
#include <optional>

#include "widgets/viewport/viewport.h"

namespace graftsman {

/// What a drag with the mouse does to the camera.
enum class CameraDrag { Orbit, Pan, Zoom };

/// A drag of the camera under way.
struct Navigating {
  CameraDrag drag = CameraDrag::Orbit;
  Qt::MouseButton button = Qt::NoButton;  // its release ends the drag
  Camera start;
  QPointF pressedAt;
  Point anchor = Point::Zero();  // what was under the pointer
};

/// The point that the wheel zooms about, as long as the pointer stays there.
struct WheelAnchor {
  QPointF position;
  Point point = Point::Zero();
};

/// What a Viewport holds.
struct Viewport::Scene {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  QMetaObject::Connection contextEnds;
  bool painting = false;
  bool stale = true;                      // the scene is not what was drawn last
  Camera drawnFrom;                       // that frame
  bool drawnQuick = false;                // that frame has not all faces
  std::optional<double> allMilliseconds;  // what the last frame with all faces took
  QTimer rest;                            // since then nothing has changed
  bool rested = false;                    // the next frame is to have all faces

  Camera camera;
  Camera shown;        // differs from `camera` while the view glides to it
  bool framed = true;  // the camera is where frameAll() left it, or nobody has moved it yet
  QVariantAnimation glide;
  Camera glideStart;

  Navigation navigation = Navigation::Blender;
  std::optional<Navigating> navigating;
  std::optional<QPointF> menuPress;  // the right button went down there and has not been dragged
  std::optional<WheelAnchor> wheelAnchor;
  std::optional<double> progress;
  bool preparing = false;
  bool dropHighlighted = false;
  bool focusShown = false;  // the focus came by the keyboard
};

}  // namespace graftsman
