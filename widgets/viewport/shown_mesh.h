#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "core/mesh/surface_point.h"
#include "widgets/viewport/camera_view.h"

class vtkPolyData;
class vtkStaticCellLocator;

namespace graftsman {

struct Shading;

/// Where a ray meets a mesh.
struct SurfaceHit {
  Index face = -1;
  Eigen::Vector3d bary = Eigen::Vector3d::Zero();  // each ≥ 0, sum 1
  Point point = Point::Zero();
};

/// Triangles with normals, as VTK draws them: smooth but for the creases.
struct DrawnTriangles {
  vtkSmartPointer<vtkPolyData> all;
  vtkSmartPointer<vtkPolyData> few;  // for quick frames; null: there are not so many
};

/// `shading`: of the mesh. `box` is divided for the few: two meshes that lie on each other share it. Made on
/// any thread.
[[nodiscard]] DrawnTriangles drawTriangles(const TriangleMesh& mesh, const Shading& shading,
                                           const Eigen::AlignedBox3d& box);

/// A mesh made ready to be drawn and picked from. Immutable; made on any thread.
class ShownMesh {
 public:
  explicit ShownMesh(std::shared_ptr<const TriangleMesh> mesh);
  ~ShownMesh();
  ShownMesh(const ShownMesh&) = delete;
  ShownMesh& operator=(const ShownMesh&) = delete;

  [[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh() const { return mesh_; }
  /// Its faces in the mesh's order, with normals. Several panes may draw it at once, each by its own mapper.
  [[nodiscard]] const DrawnTriangles& drawn() const { return drawn_; }
  [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }

  /// The first place where the ray meets the surface, from either side.
  [[nodiscard]] std::optional<SurfaceHit> firstHit(const Ray& ray) const;
  /// Whether nothing of the surface hides this point of it.
  [[nodiscard]] bool isVisible(const Point& point, const CameraView& view) const;
  /// The place of a point of the mesh; nullopt if the mesh has no such vertex or face.
  [[nodiscard]] std::optional<Point> place(const SurfacePoint& at) const;

 private:
  [[nodiscard]] std::optional<SurfaceHit> firstHit(const Point& from, const Point& to) const;

  std::shared_ptr<const TriangleMesh> mesh_;
  Eigen::AlignedBox3d box_;
  DrawnTriangles drawn_;
  vtkSmartPointer<vtkStaticCellLocator> locator_;
};

}  // namespace graftsman
