#include "widgets/viewport/morph_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <numeric>

#include "widgets/viewport/morph_mapper.h"
#include "widgets/viewport/triangle_cells.h"

namespace graftsman {
namespace {

// VTK only reads what it is lent.
template <class Array, class Value>
void lend(Array& array, const Value* values, std::size_t count) {
  constexpr int kKeep = 1;  // the array does not free it
  array.SetArray(const_cast<Value*>(values), static_cast<vtkIdType>(count), kKeep);
  array.Modified();
}

void setColour(vtkProperty& property, const Rgba& colour) {
  const QColor c = toQColor(colour);
  property.SetColor(c.redF(), c.greenF(), c.blueF());
}

}  // namespace

struct SheetActor::Parts {
  vtkRenderer& renderer;
  vtkNew<vtkFloatArray> positions;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> corners;
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> mesh;
  vtkNew<MorphMapper> mapper;
  vtkNew<vtkActor> actor;
  std::vector<Index> coarseSources;
  vtkNew<vtkUnsignedCharArray> coarseColours;
  vtkNew<vtkPolyData> coarse;
  vtkNew<MorphMapper> coarseMapper;
  StandIn standIn;
  bool visible = true;
  bool shown = false;

  explicit Parts(vtkRenderer& scene)
      : renderer(scene), standIn(scene, *actor, vtkSmartPointer<MorphMapper>(coarseMapper)) {
    positions->SetNumberOfComponents(3);
    normals->SetNumberOfComponents(3);
    colours->SetNumberOfComponents(4);
    points->SetData(positions);
    mesh->SetPoints(points);
    mesh->GetPointData()->SetNormals(normals);
    mapper->SetInputData(mesh);
    mapper->SetScalarVisibility(false);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToPhong();
    actor->GetProperty()->SetAmbient(0.12);
    actor->GetProperty()->SetDiffuse(0.9);
    actor->GetProperty()->SetSpecular(0.08);
    actor->GetProperty()->SetSpecularPower(20);
    actor->SetForceOpaque(true);  // or every change would look through the colours for transparent ones
    actor->SetVisibility(false);
    coarseColours->SetNumberOfComponents(4);
    coarse->SetPoints(points);
    coarse->GetPointData()->SetNormals(normals);
    standIn.setInput(coarse);
    renderer.AddActor(actor);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() { renderer.RemoveActor(actor); }

  void forgetColours() {
    for (vtkPolyData* data : {mesh.Get(), coarse.Get()}) {
      data->GetPointData()->SetScalars(nullptr);
      data->GetCellData()->SetScalars(nullptr);
    }
  }
};

SheetActor::SheetActor(vtkRenderer& renderer) : parts_(std::make_unique<Parts>(renderer)) {}

SheetActor::~SheetActor() = default;

void SheetActor::show(const MorphSheet& sheet, const Point& centre) {
  const std::size_t faces = sheet.faces.size();
  const auto vertices = static_cast<std::size_t>(sheet.vertexCount);
  Parts& parts = *parts_;
  lend(*parts.positions, sheet.positions, 3 * vertices);
  lend(*parts.normals, sheet.normals, 3 * vertices);
  lend(*parts.corners, faces > 0 ? sheet.faces[0].data() : nullptr, 3 * faces);
  parts.offsets->SetNumberOfValues(static_cast<vtkIdType>(faces) + 1);
  for (std::size_t f = 0; f <= faces; ++f) {
    parts.offsets->SetValue(static_cast<vtkIdType>(f), static_cast<int>(3 * f));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(parts.offsets, parts.corners);
  parts.mesh->SetPolys(cells);
  parts.coarse->SetPolys(triangleCells(sheet.coarse != nullptr ? sheet.coarse->faces : std::vector<Face>()));
  parts.coarseSources = sheet.coarse != nullptr ? sheet.coarse->sources : std::vector<Index>();
  parts.forgetColours();
  parts.mapper->SetScalarVisibility(false);
  parts.mapper->setBox(sheet.box);
  parts.coarseMapper->setBox(sheet.box);
  parts.actor->SetPosition(centre.x(), centre.y(), centre.z());
  parts.shown = faces > 0;
  parts.actor->SetVisibility(parts.shown && parts.visible);
  moved();
}

void SheetActor::hide() {
  parts_->shown = false;
  parts_->actor->SetVisibility(false);
  parts_->forgetColours();
}

void SheetActor::moved() {
  parts_->positions->Modified();
  parts_->points->Modified();
  normalsChanged();
}

void SheetActor::normalsChanged() {
  parts_->normals->Modified();
  parts_->mesh->Modified();
  parts_->coarse->Modified();
}

void SheetActor::setColours(const SheetColours& colours) {
  Parts& parts = *parts_;
  setColour(*parts.actor->GetProperty(), colours.uniform);
  const bool perVertex = colours.per == SheetColours::Per::EachVertex && !colours.each.empty();
  const bool perFace = colours.per == SheetColours::Per::EachFace && !colours.each.empty();
  if (perVertex || perFace) {
    lend(*parts.colours, &colours.each[0].r, 4 * colours.each.size());
  }
  vtkUnsignedCharArray* const array = parts.colours;
  vtkUnsignedCharArray* const coarse = parts.coarseColours;
  if (perFace) {
    coarse->SetNumberOfTuples(static_cast<vtkIdType>(parts.coarseSources.size()));
    for (std::size_t f = 0; f < parts.coarseSources.size(); ++f) {
      const Rgba& colour = colours.each[static_cast<std::size_t>(parts.coarseSources[f])];
      coarse->SetTypedTuple(static_cast<vtkIdType>(f), &colour.r);
    }
    coarse->Modified();
  }
  parts.mesh->GetPointData()->SetScalars(perVertex ? array : nullptr);
  parts.mesh->GetCellData()->SetScalars(perFace ? array : nullptr);
  parts.coarse->GetPointData()->SetScalars(perVertex ? array : nullptr);
  parts.coarse->GetCellData()->SetScalars(perFace ? coarse : nullptr);
  parts.mapper->SetScalarVisibility(perVertex || perFace);
  if (perFace) {
    parts.mapper->SetScalarModeToUseCellData();
  } else {
    parts.mapper->SetScalarModeToUsePointData();
  }
}

StandIn& SheetActor::standIn() {
  return parts_->standIn;
}

void SheetActor::setVisible(bool visible) {
  parts_->visible = visible;
  parts_->actor->SetVisibility(parts_->shown && visible);
}

void SheetActor::setOpacity(double opacity) {
  parts_->actor->GetProperty()->SetOpacity(opacity);
  parts_->actor->GetProperty()->SetBackfaceCulling(opacity < 1);  // or its own far side shines through
  parts_->actor->SetForceOpaque(opacity >= 1);
}

void SheetActor::setWireframe(bool wireframe) {
  vtkProperty& property = *parts_->actor->GetProperty();
  if (wireframe) {
    property.SetRepresentationToWireframe();
  } else {
    property.SetRepresentationToSurface();
  }
}

void SheetActor::setEdges(double width, const Rgba& colour) {
  vtkProperty& property = *parts_->actor->GetProperty();
  const QColor c = toQColor(colour);
  property.SetEdgeVisibility(width > 0);
  property.SetEdgeColor(c.redF(), c.greenF(), c.blueF());
  if (width > 0) {
    property.SetLineWidth(static_cast<float>(width));
  }
}

}  // namespace graftsman
