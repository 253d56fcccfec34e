#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include "widgets/viewport/coarse_faces.h"

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace graftsman {

/// Stands in for an actor of many faces in frames that must be quick: looks like it, with fewer faces on the
/// same vertices. Both must be in the scene for as long as this lives.
class StandIn {
 public:
  /// `mapper` draws as the actor's does; it is this object's alone from now on.
  StandIn(vtkRenderer& renderer, vtkActor& actor, vtkSmartPointer<vtkPolyDataMapper> mapper);
  ~StandIn();
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;

  /// What it draws; null or without a face: nothing stands in, and the actor is drawn.
  void setInput(vtkPolyData* few);
  /// Whether there is something to replace in a frame.
  [[nodiscard]] bool useful() const;
  /// For one frame: takes the actor's place, and gives it back.
  void replace();
  void restore();

 private:
  vtkRenderer& renderer_;
  vtkActor& actor_;
  vtkSmartPointer<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> standIn_;
};

/// The coarse faces on the points, normals and colours of `all`. No face: null.
[[nodiscard]] vtkSmartPointer<vtkPolyData> onSamePoints(vtkPolyData& all, const CoarseFaces& coarse);

}  // namespace graftsman
