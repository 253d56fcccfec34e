#include "widgets/viewport/shown_mesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <cstring>

#include <Eigen/Geometry>

#include "widgets/viewport/shading.h"

namespace graftsman {
namespace {

constexpr double kBeside = 1e-6;            // of a ray's length: far below a pixel
constexpr double kVisibleTolerance = 1e-6;  // × diagonal: a point hides not itself
constexpr double kWeightSnap = 1e-6;        // a pick this near to an edge or corner lies on it

vtkSmartPointer<vtkCellArray> triangleCells(const std::vector<Face>& faces) {
  const auto count = static_cast<vtkIdType>(faces.size());
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * count);
  std::memcpy(corners->GetPointer(0), faces.data(), 3 * faces.size() * sizeof(Index));
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (std::size_t f = 0; f <= faces.size(); ++f) {
    offsets->SetValue(static_cast<vtkIdType>(f), static_cast<vtkTypeInt32>(3 * f));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, corners);
  return cells;
}

Eigen::Vector3d baryOf(const TriangleMesh& mesh, Index face, const Point& point) {
  const Face& corners = mesh.face(face);
  const Point& a = mesh.point(corners[0]);
  const Eigen::Vector3d ab = mesh.point(corners[1]) - a;
  const Eigen::Vector3d ac = mesh.point(corners[2]) - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double area = normal.squaredNorm();
  if (area <= 0) {
    return Eigen::Vector3d::UnitX();
  }
  const Eigen::Vector3d ap = point - a;
  Eigen::Vector3d bary;
  bary[1] = ap.cross(ac).dot(normal) / area;
  bary[2] = ab.cross(ap).dot(normal) / area;
  bary[0] = 1 - bary[1] - bary[2];
  for (double& weight : bary) {
    weight = weight < kWeightSnap ? 0 : weight;
  }
  return bary / bary.sum();
}

}  // namespace

vtkSmartPointer<vtkPolyData> drawnTriangles(const TriangleMesh& mesh) {
  const Shading shading = shade(mesh);
  const auto count = static_cast<vtkIdType>(shading.meshVertices.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    points->SetPoint(i, mesh.point(shading.meshVertices[at]).data());
    normals->SetTypedTuple(i, shading.normals[at].data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangleCells(shading.faces));
  data->GetPointData()->SetNormals(normals);
  // What VTK would otherwise find lazily, on the thread that draws or picks.
  data->ComputeBounds();
  data->BuildCells();
  return data;
}

ShownMesh::ShownMesh(std::shared_ptr<const TriangleMesh> mesh)
    : mesh_(std::move(mesh)),
      drawn_(drawnTriangles(*mesh_)),
      locator_(vtkSmartPointer<vtkStaticCellLocator>::New()) {
  locator_->SetDataSet(drawn_);
  locator_->BuildLocator();
}

ShownMesh::~ShownMesh() = default;

vtkPolyData* ShownMesh::drawn() const {
  return drawn_;
}

std::optional<SurfaceHit> ShownMesh::firstHit(const Point& from, const Point& to) const {
  double t = 0;
  double x[3];
  double weights[3];
  int part = 0;
  vtkIdType cell = -1;
  vtkNew<vtkGenericCell> scratch;
  if (locator_->IntersectWithLine(from.data(), to.data(), 0, t, x, weights, part, cell, scratch) == 0) {
    return {};
  }
  SurfaceHit hit;
  hit.face = static_cast<Index>(cell);
  hit.bary = baryOf(*mesh_, hit.face, Point(x));
  hit.point = *place({-1, hit.face, hit.bary});
  return hit;
}

std::optional<SurfaceHit> ShownMesh::firstHit(const Ray& ray) const {
  double b[6];
  drawn_->GetBounds(b);
  const Point middle((b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2);
  const double reach = (middle - ray.origin).norm() + mesh_->diagonal();
  // The locator lets a ray slip through an edge or a vertex that it meets exactly, to the far side: of the
  // ray and two beside it, the nearest hit counts.
  const Eigen::Vector3d beside = kBeside * ray.direction.unitOrthogonal();
  std::optional<SurfaceHit> nearest;
  for (const Eigen::Vector3d& off :
       {Eigen::Vector3d(Eigen::Vector3d::Zero()), beside, Eigen::Vector3d(-beside)}) {
    const auto hit = firstHit(ray.origin, ray.origin + reach * (ray.direction + off));
    const auto depth = [&](const SurfaceHit& h) { return (h.point - ray.origin).dot(ray.direction); };
    if (hit && (!nearest || depth(*hit) < depth(*nearest) - kVisibleTolerance * mesh_->diagonal())) {
      nearest = hit;
    }
  }
  return nearest;
}

bool ShownMesh::isVisible(const Point& point, const CameraView& view) const {
  if (view.depth(point) <= 0) {
    return false;
  }
  const Eigen::Vector3d way = point - view.camera.position;
  const double before = 1 - kVisibleTolerance * mesh_->diagonal() / way.norm();
  return before <= 0 || !firstHit(view.camera.position, view.camera.position + before * way);
}

std::optional<Point> ShownMesh::place(const SurfacePoint& at) const {
  if (at.vertex >= 0) {
    return at.vertex < mesh_->vertexCount() ? std::optional(mesh_->point(at.vertex)) : std::nullopt;
  }
  if (at.face < 0 || at.face >= mesh_->faceCount()) {
    return {};
  }
  const Face& corners = mesh_->face(at.face);
  return at.bary[0] * mesh_->point(corners[0]) + at.bary[1] * mesh_->point(corners[1]) +
         at.bary[2] * mesh_->point(corners[2]);
}

}  // namespace graftsman
