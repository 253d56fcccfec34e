#include "core/base/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace graftsman {

int orient2dExact(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Eigen::Vector2d& p) { return Kernel::Point_2(p.x(), p.y()); };
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

}  // namespace graftsman
