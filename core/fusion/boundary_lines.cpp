#include "core/fusion/boundary_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/fusion/rigid_fit.h"

namespace graftsman {
namespace {

// Sine of the angle at a CV between the line and the direction to the centroid from which on z is the
// paper's alone; below, the loop's normal takes over smoothly. 0.1 is 6°: wide enough that a CV dragged past
// does not make the frame jump, narrow enough that ordinary loops never see it.
constexpr double kPaperFrame = 0.1;

// Length, relative to a unit vector, below which a normal counts as rounding error.
constexpr double kNoNormal = 1e-9;

/// A loop's own directions.
struct LoopShape {
  Point centroid;
  Eigen::Vector3d normal;  // Newell's area vector over the loop's size squared; 0 for a loop without area
};

LoopShape shapeOf(std::span<const Point> cvs) {
  LoopShape shape{centroid(cvs), Eigen::Vector3d::Zero()};
  double size = 0;
  for (const Point& p : cvs) {
    size = std::max(size, (p - shape.centroid).norm());
  }
  if (!(size > 0)) {
    return shape;
  }
  for (std::size_t i = 0; i < cvs.size(); ++i) {
    const Eigen::Vector3d a = (cvs[i] - shape.centroid) / size;
    const Eigen::Vector3d b = (cvs[(i + 1) % cvs.size()] - shape.centroid) / size;
    shape.normal += a.cross(b);
  }
  return shape;
}

// z of the line that starts at `origin` and runs along the unit vector y; nothing where no normal is defined.
std::optional<Eigen::Vector3d> lineNormal(const LoopShape& shape, const Point& origin,
                                          const Eigen::Vector3d& y) {
  const Eigen::Vector3d loopNormal = shape.normal - shape.normal.dot(y) * y;
  const bool hasLoopNormal = loopNormal.norm() > kNoNormal;
  const Eigen::Vector3d outwards = (origin - shape.centroid).normalized();
  const Eigen::Vector3d cross = outwards.cross(y);
  const double sine = cross.norm();
  if (sine >= kPaperFrame || (!hasLoopNormal && sine > kNoNormal)) {
    return cross / sine;
  }
  if (!hasLoopNormal) {
    return std::nullopt;
  }
  const Eigen::Vector3d other = loopNormal.normalized();
  if (!(sine > kNoNormal)) {
    return other;
  }
  const double x = sine / kPaperFrame;
  const double share = x * x * (3 - 2 * x);
  const double sign = cross.dot(other) < 0 ? -1 : 1;  // towards each other, so that they cannot cancel
  const Eigen::Vector3d blended = share * (sign / sine) * cross + (1 - share) * other;
  return (blended - blended.dot(y) * y).normalized();
}

Eigen::Matrix3d frame(const Eigen::Vector3d& y, const Eigen::Vector3d& z) {
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

// The rotation from the line's frame on the part to that on the base.
Eigen::Matrix3d frameToFrame(const LoopShape& part, const Point& partOrigin, const Eigen::Vector3d& partY,
                             const LoopShape& base, const Point& baseOrigin, const Eigen::Vector3d& baseY,
                             const Eigen::Matrix3d& turn) {
  std::optional<Eigen::Vector3d> partZ = lineNormal(part, partOrigin, partY);
  std::optional<Eigen::Vector3d> baseZ = lineNormal(base, baseOrigin, baseY);
  if (!partZ && !baseZ) {
    partZ = perpendicularTo(partY);
  }
  const Eigen::Vector3d turnedY = turn * partY;
  if (!baseZ) {
    baseZ = smallestRotation(turnedY, baseY) * (turn * *partZ);
  } else if (!partZ) {
    partZ = turn.transpose() * (smallestRotation(baseY, turnedY) * *baseZ);
  }
  if ((turn * *partZ).dot(*baseZ) < 0) {
    *baseZ = -*baseZ;
  }
  return frame(baseY, *baseZ) * frame(partY, *partZ).transpose();
}

}  // namespace

std::vector<BoundaryLine> boundaryLines(std::span<const Point> partCvs, std::span<const Point> baseCvs,
                                        const Eigen::Matrix3d& turn) {
  assert(partCvs.size() == baseCvs.size());
  const LoopShape part = shapeOf(partCvs);
  const LoopShape base = shapeOf(baseCvs);
  std::vector<BoundaryLine> lines;
  lines.reserve(partCvs.size());
  for (std::size_t i = 0; i < partCvs.size(); ++i) {
    const std::size_t next = (i + 1) % partCvs.size();
    const Eigen::Vector3d partEdge = partCvs[next] - partCvs[i];
    const Eigen::Vector3d baseEdge = baseCvs[next] - baseCvs[i];
    const double partLength = partEdge.norm();
    const double baseLength = baseEdge.norm();
    if (!(partLength > 0 && baseLength > 0)) {
      continue;
    }
    const Eigen::Matrix3d rotation =
        frameToFrame(part, partCvs[i], partEdge / partLength, base, baseCvs[i], baseEdge / baseLength, turn);
    lines.push_back({partCvs[i], partEdge, (baseLength / partLength) * rotation, baseCvs[i]});
  }
  return lines;
}

}  // namespace graftsman
