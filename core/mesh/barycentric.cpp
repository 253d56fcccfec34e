#include "core/mesh/barycentric.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace graftsman {

// Weights are homogeneous coordinates of the triangle's plane, where the orientation is the sign of the
// determinant of the three: that of the tetrahedron that they span with the origin.
int orientBarycentric(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Eigen::Vector3d& w) { return Kernel::Point_3(w.x(), w.y(), w.z()); };
  return static_cast<int>(CGAL::orientation(Kernel::Point_3(0, 0, 0), point(a), point(b), point(c)));
}

}  // namespace graftsman
