#include "widgets/viewport/morph_lines.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "widgets/viewport/morph_mapper.h"

namespace graftsman {
namespace {

// How much nearer to the eye than the surface, in parts of the distance: enough for a line of 3 px on a
// slope, where a pixel's depth is the greater part of it.
constexpr double kLift = 4e-3;

}  // namespace

struct LineActor::Parts {
  vtkRenderer& renderer;
  vtkNew<vtkFloatArray> positions;
  vtkNew<vtkPoints> points;
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> ends;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkPolyData> lines;
  vtkNew<MorphMapper> mapper;
  vtkNew<vtkActor> actor;
  bool visible = true;
  bool shown = false;

  explicit Parts(vtkRenderer& scene) : renderer(scene) {
    positions->SetNumberOfComponents(3);
    colours->SetNumberOfComponents(4);
    points->SetData(positions);
    lines->SetPoints(points);
    mapper->SetInputData(lines);
    mapper->SetScalarVisibility(false);
    mapper->SetScalarModeToUseCellData();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLighting(false);
    actor->SetForceOpaque(true);
    actor->SetVisibility(false);
    renderer.AddActor(actor);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() { renderer.RemoveActor(actor); }
};

LineActor::LineActor(vtkRenderer& renderer) : parts_(std::make_unique<Parts>(renderer)) {}

LineActor::~LineActor() = default;

void LineActor::show(const float* positions, Index vertexCount, std::span<const Index> ends,
                     const Eigen::AlignedBox3d& box, const Point& centre) {
  Parts& parts = *parts_;
  constexpr int kKeep = 1;  // the array does not free it; VTK only reads it
  parts.positions->SetArray(const_cast<float*>(positions), vtkIdType{3} * vertexCount, kKeep);
  const auto segments = static_cast<vtkIdType>(ends.size() / 2);
  parts.ends->SetNumberOfValues(2 * segments);
  std::copy(ends.begin(), ends.end(), parts.ends->GetPointer(0));
  parts.offsets->SetNumberOfValues(segments + 1);
  for (vtkIdType i = 0; i <= segments; ++i) {
    parts.offsets->SetValue(i, static_cast<int>(2 * i));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(parts.offsets, parts.ends);
  parts.lines->SetLines(cells);
  parts.mapper->setBox(box);
  parts.actor->SetPosition(centre.x(), centre.y(), centre.z());
  parts.shown = segments > 0;
  parts.actor->SetVisibility(parts.shown && parts.visible);
  moved();
}

void LineActor::hide() {
  parts_->shown = false;
  parts_->actor->SetVisibility(false);
}

void LineActor::moved() {
  parts_->positions->Modified();
  parts_->points->Modified();
  parts_->lines->Modified();
}

void LineActor::liftTowards(const Point& eye) {
  vtkNew<vtkMatrix4x4> towardsEye;
  for (int i = 0; i < 3; ++i) {
    towardsEye->SetElement(i, i, 1 - kLift);
    towardsEye->SetElement(i, 3, kLift * eye[i]);
  }
  parts_->actor->SetUserMatrix(towardsEye);
}

void LineActor::setColour(const Rgba& colour) {
  const QColor c = toQColor(colour);
  parts_->actor->GetProperty()->SetColor(c.redF(), c.greenF(), c.blueF());
}

void LineActor::setColours(std::span<const Rgba> colours) {
  Parts& parts = *parts_;
  parts.mapper->SetScalarVisibility(!colours.empty());
  if (colours.empty()) {
    parts.lines->GetCellData()->SetScalars(nullptr);
    return;
  }
  parts.colours->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
  std::copy_n(&colours[0].r, 4 * colours.size(), parts.colours->GetPointer(0));
  parts.colours->Modified();
  parts.lines->GetCellData()->SetScalars(parts.colours);
}

void LineActor::setWidth(double width) {
  parts_->actor->GetProperty()->SetLineWidth(static_cast<float>(width));
}

void LineActor::setVisible(bool visible) {
  parts_->visible = visible;
  parts_->actor->SetVisibility(parts_->shown && visible);
}

}  // namespace graftsman
