#pragma once

#include <Eigen/Core>

namespace graftsman {

/// +1 if the points with these weights of a triangle's corners turn counter-clockwise, as the corners do, −1
/// if clockwise, 0 if they lie on one line: exact for all finite weights. The weights need not sum to 1;
/// precondition: each sum is positive.
[[nodiscard]] int orientBarycentric(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                    const Eigen::Vector3d& c);

}  // namespace graftsman
