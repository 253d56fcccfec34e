#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <QVariantAnimation>

#include "widgets/viewport/loop_scene.h"
#include "widgets/viewport/mark_pictures.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/newest_job.h"
#include "widgets/viewport/shown_mesh.h"
#include "widgets/viewport/stand_in.h"

namespace graftsman {

/// What is at a place of the pane, nearest to the person first.
struct MeshPane::Pointed {
  enum class Target { Nothing, CV, Path, Surface };
  Target target = Target::Nothing;
  int number = -1;  // of the CV or path
  SurfacePoint at;  // what a click takes: on a path or the surface

  [[nodiscard]] bool onSurface() const { return target == Target::Path || target == Target::Surface; }
  friend bool operator==(const Pointed&, const Pointed&) = default;
};

struct MeshPane::Content {
  Content(MeshPane& pane, Side meshSide);

  /// The mesh last set is shown, and marks of it mean something.
  [[nodiscard]] bool ready() const { return shown && shown->mesh() == wanted; }

  Side side;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  StandIn standIn;
  LoopScene loop;
  MarkPictures pictures;

  std::shared_ptr<const TriangleMesh> wanted;
  std::shared_ptr<const ShownMesh> shown;
  LoopMarks marks;
  std::vector<PathMark> drawnPaths;
  std::shared_ptr<const Tile> drawnTile;
  NewestJob<std::shared_ptr<const ShownMesh>> meshJob;
  NewestJob<DrawnTriangles> tileJob;

  bool picking = true;
  Pointed hovered;
  Index hoveredVertex = -1;  // as last told
  Index cursorVertex = -1;   // where the arrows start
  bool byKeyboard = false;   // the arrows have moved since the mouse did
  struct Press {
    QPointF position;
    Pointed pointed;
  };
  std::optional<Press> press;  // the left button went down there, and may become a click
  bool lastClickPicked = false;
  struct Drag {
    int number = 0;
    SurfacePoint at;
  };
  std::optional<Drag> drag;  // of a CV

  QVariantAnimation flash;
  int flashed = -1;
};

}  // namespace graftsman
