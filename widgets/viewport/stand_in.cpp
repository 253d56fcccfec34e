#include "widgets/viewport/stand_in.h"

#include <vtkActor.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <utility>

#include "widgets/viewport/triangle_cells.h"

namespace graftsman {

StandIn::StandIn(vtkRenderer& renderer, vtkActor& actor, vtkSmartPointer<vtkPolyDataMapper> mapper)
    : renderer_(renderer), actor_(actor), mapper_(std::move(mapper)) {
  standIn_->SetMapper(mapper_);
  standIn_->SetVisibility(false);
  standIn_->SetUseBounds(false);
  renderer_.AddActor(standIn_);
}

StandIn::~StandIn() {
  renderer_.RemoveActor(standIn_);
}

void StandIn::setInput(vtkPolyData* few) {
  mapper_->SetInputData(few);
}

bool StandIn::useful() const {
  vtkPolyData* const few = mapper_->GetInput();
  return few != nullptr && few->GetNumberOfPolys() > 0 && actor_.GetVisibility() != 0;
}

void StandIn::replace() {
  if (!useful()) {
    return;
  }
  mapper_->SetScalarVisibility(actor_.GetMapper()->GetScalarVisibility());
  mapper_->SetScalarMode(actor_.GetMapper()->GetScalarMode());
  standIn_->GetProperty()->DeepCopy(actor_.GetProperty());
  standIn_->GetProperty()->SetEdgeVisibility(false);  // they would be other edges
  standIn_->SetForceOpaque(actor_.GetForceOpaque());
  standIn_->SetPosition(actor_.GetPosition());
  standIn_->SetUserMatrix(actor_.GetUserMatrix());
  standIn_->SetVisibility(true);
  actor_.SetVisibility(false);
}

void StandIn::restore() {
  if (standIn_->GetVisibility() != 0) {
    standIn_->SetVisibility(false);
    actor_.SetVisibility(true);
  }
}

vtkSmartPointer<vtkPolyData> onSamePoints(vtkPolyData& all, const CoarseFaces& coarse) {
  if (coarse.faces.empty()) {
    return nullptr;
  }
  auto few = vtkSmartPointer<vtkPolyData>::New();
  few->SetPoints(all.GetPoints());
  few->GetPointData()->ShallowCopy(all.GetPointData());
  few->SetPolys(triangleCells(coarse.faces));
  few->ComputeBounds();
  few->BuildCells();
  return few;
}

}  // namespace graftsman
