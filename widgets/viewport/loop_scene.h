#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "core/base/error.h"
#include "core/fusion/tile.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/shown_mesh.h"
#include "widgets/viewport/stand_in.h"

class vtkActor;
class vtkPolyDataMapper;
class vtkRenderer;

namespace graftsman {

/// The tinted tile and the paths of a loop, as actors of a scene. They lie on the mesh exactly, so each frame
/// moves them a little towards the eye: scaled about it, they are seen at the same place.
class LoopScene {
 public:
  explicit LoopScene(vtkRenderer& renderer);
  ~LoopScene();

  /// Paths with a problem are dashed. Copies.
  void setPaths(const std::vector<PathMark>& paths);
  /// What drawTriangles() made of a tile; null: none.
  void setTile(const DrawnTriangles& tile);
  /// For the tile.
  [[nodiscard]] StandIn& standIn() { return standIn_; }
  void applyTheme(const Theme& theme, Side side);
  /// Before each frame.
  void prepare(const CameraView& view);

 private:
  struct Part {
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void add(vtkRenderer& renderer, Part& part);

  Part tile_;
  StandIn standIn_;
  Part sound_;    // paths without a problem
  Part problem_;  // dashes
  std::vector<std::vector<Point>> problemPaths_;
  double dash_ = 0;  // length of the dashes drawn; 0: none yet
};

}  // namespace graftsman
