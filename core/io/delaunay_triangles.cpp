#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <utility>

#include "core/io/triangulate.h"

namespace graftsman {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<bool, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

// Marks what lies outside of the polygon, from the infinite face up to the constraints.
void markOutside(Triangulation& triangulation) {
  for (const auto face : triangulation.all_face_handles()) {
    face->info() = false;
  }
  std::vector<Triangulation::Face_handle> pending = {triangulation.infinite_face()};
  pending.front()->info() = true;
  while (!pending.empty()) {
    const auto face = pending.back();
    pending.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto neighbour = face->neighbor(i);
      if (!face->is_constrained(i) && !neighbour->info()) {
        neighbour->info() = true;
        pending.push_back(neighbour);
      }
    }
  }
}

}  // namespace

std::vector<Face> delaunayTriangles(const std::vector<Eigen::Vector2d>& polygon) {
  std::vector<std::pair<Kernel::Point_2, Index>> points;
  std::vector<Kernel::Point_2> outline;
  for (const Eigen::Vector2d& p : polygon) {
    outline.emplace_back(p.x(), p.y());
    points.emplace_back(outline.back(), static_cast<Index>(points.size()));
  }
  if (!CGAL::is_simple_2(outline.begin(), outline.end(), Kernel())) {
    return {};
  }
  Triangulation triangulation;
  triangulation.insert(points.begin(), points.end());
  std::vector<Triangulation::Vertex_handle> corners(polygon.size());
  for (const auto vertex : triangulation.finite_vertex_handles()) {
    corners[static_cast<std::size_t>(vertex->info())] = vertex;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }
  markOutside(triangulation);
  std::vector<Face> triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    if (!face->info()) {
      Face triangle = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      triangles.push_back(triangle);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace graftsman
