#pragma once

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Distances from points to one surface, by CGAL's AABB tree: independent of the code under test.
class SurfaceDistance {
 public:
  SurfaceDistance(std::span<const Point> points, std::span<const Face> faces) {
    std::vector<Mesh::Vertex_index> vertices;
    for (const Face& face : faces) {  // every face for itself: any connectivity will do
      std::array<Mesh::Vertex_index, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point& p = points[static_cast<std::size_t>(face[k])];
        corners[k] = mesh_.add_vertex({p.x(), p.y(), p.z()});
      }
      mesh_.add_face(corners[0], corners[1], corners[2]);
    }
    tree_.insert(mesh_.faces_begin(), mesh_.faces_end(), mesh_);
    tree_.accelerate_distance_queries();
  }

  [[nodiscard]] double operator()(const Point& p) const {
    const Kernel::Point_3 closest = tree_.closest_point({p.x(), p.y(), p.z()});
    return (Point(closest.x(), closest.y(), closest.z()) - p).norm();
  }

  /// The greatest distance of a sampled surface: vertices, edge midpoints and centroids of its faces.
  [[nodiscard]] double greatestTo(std::span<const Point> points, std::span<const Face> faces) const {
    double greatest = 0;
    for (const auto& [i, j, k] : faces) {
      const Point& a = points[static_cast<std::size_t>(i)];
      const Point& b = points[static_cast<std::size_t>(j)];
      const Point& c = points[static_cast<std::size_t>(k)];
      for (const Point& p : {a, Point((a + b) / 2), Point((a + b + c) / 3)}) {
        greatest = std::max(greatest, (*this)(p));
      }
    }
    return greatest;
  }

 private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

  Mesh mesh_;
  CGAL::AABB_tree<Traits> tree_;
};

}  // namespace graftsman
