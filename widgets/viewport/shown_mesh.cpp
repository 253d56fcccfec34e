#include "widgets/viewport/shown_mesh.h"

#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>

#include <Eigen/Geometry>

#include "widgets/viewport/shading.h"
#include "widgets/viewport/stand_in.h"
#include "widgets/viewport/triangle_cells.h"

namespace graftsman {
namespace {

constexpr double kBeside = 1e-6;            // of a ray's length: far below a pixel
constexpr double kVisibleTolerance = 1e-6;  // × diagonal: a point hides not itself
constexpr double kWeightSnap = 1e-6;        // a pick this near to an edge or corner lies on it

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

DrawnTriangles drawTriangles(const TriangleMesh& mesh, const Shading& shading,
                             const Eigen::AlignedBox3d& box) {
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
  DrawnTriangles drawn;
  drawn.all = vtkSmartPointer<vtkPolyData>::New();
  drawn.all->SetPoints(points);
  drawn.all->SetPolys(triangleCells(shading.faces));
  drawn.all->GetPointData()->SetNormals(normals);
  // What VTK would otherwise find lazily, on the thread that draws or picks.
  drawn.all->ComputeBounds();
  drawn.all->BuildCells();
  drawn.few =
      onSamePoints(*drawn.all, coarsen(mesh, shading.meshVertices, shading.normals, shading.faces, box));
  return drawn;
}

ShownMesh::ShownMesh(std::shared_ptr<const TriangleMesh> mesh)
    : mesh_(std::move(mesh)),
      box_(boxOf(*mesh_)),
      drawn_(drawTriangles(*mesh_, shade(*mesh_), box_)),
      locator_(vtkSmartPointer<vtkStaticCellLocator>::New()) {
  locator_->SetDataSet(drawn_.all);
  locator_->BuildLocator();
}

ShownMesh::~ShownMesh() = default;

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
  const double reach = (box_.center() - ray.origin).norm() + mesh_->diagonal();
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
