#include "widgets/viewport/surface_pane.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <numeric>

#include "widgets/theme/theme.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/colouring_scale.h"
#include "widgets/viewport/shading.h"
#include "widgets/viewport/shown_mesh.h"
#include "widgets/viewport/stand_in.h"
#include "widgets/viewport/surface_between.h"
#include "widgets/viewport/triangle_cells.h"

namespace graftsman {

struct DrawnSurface {
  std::shared_ptr<const TriangleMesh> mesh;
  Shading shading;
  DrawnTriangles triangles;
};

struct DrawnBetween {
  std::shared_ptr<const DrawnSurface> a;
  std::shared_ptr<const DrawnSurface> b;
  BetweenLayout layout;
  vtkSmartPointer<vtkCellArray> cells;
  CoarseFaces coarse;
};

namespace {

constexpr double kLightInShadow = 0.1;
constexpr int kScaleSteps = 20;  // of the legend's bar

vtkSmartPointer<vtkFloatArray> normalsArray(std::size_t count) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

vtkSmartPointer<vtkPoints> pointsArray(std::size_t count) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  return points;
}

vtkSmartPointer<vtkUnsignedCharArray> distanceColours(const Shading& shading,
                                                      std::span<const double> distances, double range) {
  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(shading.meshVertices.size()));
  for (std::size_t i = 0; i < shading.meshVertices.size(); ++i) {
    const Rgba colour = divergingColour(distances[static_cast<std::size_t>(shading.meshVertices[i])] / range);
    const std::array<unsigned char, 3> rgb = {colour.r, colour.g, colour.b};
    colours->SetTypedTuple(static_cast<vtkIdType>(i), rgb.data());
  }
  return colours;
}

}  // namespace

std::shared_ptr<const DrawnSurface> drawSurface(std::shared_ptr<const TriangleMesh> mesh,
                                                std::span<const double> distances, double range) {
  auto drawn = std::make_shared<DrawnSurface>();
  drawn->mesh = std::move(mesh);
  drawn->shading = shade(*drawn->mesh);
  drawn->triangles = drawTriangles(*drawn->mesh, drawn->shading, boxOf(*drawn->mesh));
  if (!distances.empty()) {
    const auto colours = distanceColours(drawn->shading, distances, range);
    for (vtkPolyData* data : {drawn->triangles.all.Get(), drawn->triangles.few.Get()}) {
      if (data != nullptr) {
        data->GetPointData()->SetScalars(colours);
      }
    }
  }
  return drawn;
}

std::shared_ptr<const DrawnBetween> drawBetween(std::shared_ptr<const DrawnSurface> a,
                                                std::shared_ptr<const DrawnSurface> b) {
  auto drawn = std::make_shared<DrawnBetween>();
  drawn->layout = layOutBetween(*a->mesh, a->shading, b->shading);
  drawn->cells = triangleCells(drawn->layout.faces);
  std::vector<Eigen::Vector3f> normals;
  for (const auto& shaded : drawn->layout.shaded) {
    normals.push_back(a->shading.normals[static_cast<std::size_t>(shaded[0])]);
  }
  drawn->coarse =
      coarsen(*a->mesh, drawn->layout.meshVertices, normals, drawn->layout.faces, boxOf(*a->mesh));
  drawn->a = std::move(a);
  drawn->b = std::move(b);
  return drawn;
}

Legend distanceLegend(const QString& title, double range, bool beyond, const QString& note) {
  Legend legend;
  legend.title = title;
  for (int i = 0; i <= kScaleSteps; ++i) {
    legend.bar.push_back(toQColor(divergingColour(2.0 * i / kScaleSteps - 1)));
  }
  const QString end = QLocale().toString(range, 'g', 3);
  legend.ticks = {{0, (beyond ? QStringLiteral("≤ −") : QStringLiteral("−")) + end},
                  {0.5, QStringLiteral("0")},
                  {1, (beyond ? QStringLiteral("≥ +") : QStringLiteral("+")) + end}};
  legend.note = note;
  return legend;
}

struct SurfacePane::Content {
  std::shared_ptr<const DrawnSurface> surface;  // shown; between two, the first
  // What lies between, and the arrays of its last frame, written anew for the next.
  std::shared_ptr<const DrawnBetween> between;
  vtkNew<vtkPolyData> betweenData;
  vtkSmartPointer<vtkPolyData> betweenFew;
  std::vector<Eigen::Vector3f> areas;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  StandIn standIn;
  Legend legend;

  explicit Content(vtkRenderer& renderer)
      : standIn(renderer, *actor, vtkSmartPointer<vtkPolyDataMapper>::New()) {}
};

SurfacePane::SurfacePane(QWidget* parent)
    : Viewport(parent), content_(std::make_unique<Content>(*renderer())) {
  setObjectName(QStringLiteral("surfacePane"));
  setAccessibleName(tr("Surface"));
  content_->mapper->SetColorModeToDirectScalars();
  content_->actor->SetMapper(content_->mapper);
  content_->actor->GetProperty()->SetAmbient(kLightInShadow);
  content_->actor->GetProperty()->SetDiffuse(1 - kLightInShadow);
  content_->actor->SetVisibility(false);
  renderer()->AddActor(content_->actor);
  SurfacePane::applyTheme(themeFor(palette()));
}

SurfacePane::~SurfacePane() = default;

void SurfacePane::showSurface(std::shared_ptr<const DrawnSurface> surface) {
  Content& content = *content_;
  content.surface = std::move(surface);
  content.actor->SetVisibility(content.surface != nullptr);
  if (content.surface) {
    const DrawnTriangles& triangles = content.surface->triangles;
    content.mapper->SetInputData(triangles.all);
    content.standIn.setInput(triangles.few);
    content.mapper->SetScalarVisibility(triangles.all->GetPointData()->GetScalars() != nullptr);
    keepFramed();
  }
  renderLater();
}

void SurfacePane::showBetween(const std::shared_ptr<const DrawnBetween>& between, double t) {
  if (t <= 0 || t >= 1) {
    showSurface(t <= 0 ? between->a : between->b);
    return;
  }
  Content& content = *content_;
  const BetweenLayout& layout = between->layout;
  const std::size_t count = layout.meshVertices.size();
  vtkPolyData& drawn = *content.betweenData;
  if (content.between != between) {
    content.between = between;
    content.areas.resize(layout.faces.size());
    drawn.SetPolys(between->cells);
    drawn.SetPoints(pointsArray(count));
    drawn.GetPointData()->SetNormals(normalsArray(count));
    content.betweenFew = onSamePoints(drawn, between->coarse);
  }
  vtkPoints& points = *drawn.GetPoints();
  vtkDataArray& normals = *drawn.GetPointData()->GetNormals();
  writeBetween(layout, *between->a->mesh, *between->b->mesh, t,
               {static_cast<double*>(points.GetVoidPointer(0)), 3 * count},
               {static_cast<float*>(normals.GetVoidPointer(0)), 3 * count}, content.areas);
  points.Modified();
  normals.Modified();
  drawn.Modified();
  if (content.betweenFew) {
    content.betweenFew->Modified();
  }
  content.surface = between->a;
  content.mapper->SetInputData(&drawn);
  content.standIn.setInput(content.betweenFew);
  content.mapper->SetScalarVisibility(false);
  content.actor->SetVisibility(true);
  renderLater();
}

void SurfacePane::setLegend(Legend legend) {
  content_->legend = std::move(legend);
  setAccessibleDescription(content_->legend.text());
  repaintLater();
}

std::vector<Point> SurfacePane::shownPoints() const {
  std::vector<Point> points;
  if (content_->surface && content_->actor->GetVisibility() != 0) {
    // The first shaded vertices are the mesh's own, in order.
    points.resize(static_cast<std::size_t>(content_->surface->mesh->vertexCount()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      content_->mapper->GetInput()->GetPoint(static_cast<vtkIdType>(i), points[i].data());
    }
  }
  return points;
}

std::vector<StandIn*> SurfacePane::standIns() const {
  return {&content_->standIn};
}

void SurfacePane::paintOver(QPainter& painter, const CameraView& view) {
  if (!content_->legend.title.isEmpty()) {
    painter.setFont(font());
    paintLegend(painter, content_->legend, QRectF(QPointF(), view.size), palette());
  }
}

void SurfacePane::applyTheme(const Theme& theme) {
  content_->actor->GetProperty()->SetColor(theme.mesh.redF(), theme.mesh.greenF(), theme.mesh.blueF());
}

}  // namespace graftsman

#include "moc_surface_pane.cpp"  // NOLINT(bugprone-suspicious-include)
