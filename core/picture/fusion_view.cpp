#include "core/picture/fusion_view.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/fusion/path_position.h"

namespace graftsman {
namespace {

// How far the first view is turned from the loop's normal, as parts of it: shapes show their depth.
constexpr double kBeside = 0.45;
constexpr double kAbove = 0.3;
// A normal within about 35° of the axis: seen from there, the axis could not be up.
constexpr double kAlong = 0.8;
// The surroundings of a tile, as a multiple of its size.
constexpr double kSurroundings = 1.9;

bool isOn(const TriangleMesh& mesh, const SurfacePoint& point) {
  return point.vertex >= 0 ? point.vertex < mesh.vertexCount()
                           : point.face >= 0 && point.face < mesh.faceCount();
}

std::vector<Point> loopPoints(const FusionInputs& inputs) {
  std::vector<Point> points;
  for (const CVP& pair : inputs.loop) {
    if (isOn(*inputs.base, pair.base)) {
      points.push_back(positionOf(*inputs.base, pair.base));
    }
  }
  return points;
}

// Of the polygon (Newell's), outward for a loop that is counter-clockwise; 0: none.
Eigen::Vector3d normalOf(std::span<const Point> polygon) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return normal.stableNormalized();
}

// The corners of faces alone: other vertices are not seen.
std::vector<Point> usedPoints(const TriangleMesh& mesh) {
  std::vector<Point> points;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.outgoing(v) >= 0) {
      points.push_back(mesh.point(v));
    }
  }
  return points;
}

std::vector<Point> tilePoints(const FusionResults& results) {
  if (!results.combined) {
    return loopPoints(results.inputs);
  }
  std::vector<Point> points = results.combined->base;
  points.insert(points.end(), results.combined->part.begin(), results.combined->part.end());
  return points;
}

Eigen::AlignedBox3d boxOf(const std::vector<Point>& points) {
  Eigen::AlignedBox3d box;
  for (const Point& p : points) {
    box.extend(p);
  }
  return box;
}

std::vector<Point> bothShapes(const FusionResults& results) {
  std::vector<bool> used(results.join->points.size(), false);
  for (const Face& face : results.join->faces) {
    for (const Index v : face) {
      used[static_cast<std::size_t>(v)] = true;
    }
  }
  std::vector<Point> points = results.combined->part;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) {
      points.push_back(results.join->points[v]);
    }
  }
  return points;
}

}  // namespace

bool guessYUp(std::span<const Point> loop, bool isObj) {
  return isObj && std::abs(normalOf(loop).y()) <= kAlong;
}

bool guessYUp(const FusionInputs& inputs, bool isObj) {
  return guessYUp(loopPoints(inputs), isObj);
}

ViewDirection firstDirection(std::span<const Point> loop, bool yUp) {
  const Eigen::Vector3d up = yUp ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  Eigen::Vector3d front = yUp ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(-Eigen::Vector3d::UnitY());
  const Eigen::Vector3d normal = normalOf(loop);
  if (std::abs(normal.dot(up)) > kAlong) {
    front = (front + 1.5 * normal).normalized();
  } else if (normal.norm() > 0.5) {
    front = normal;
  }
  const Eigen::Vector3d beside = up.cross(front);
  return {(front + kBeside * beside + kAbove * up).normalized(), up};
}

ViewDirection firstDirection(const FusionInputs& inputs, bool yUp) {
  return firstDirection(loopPoints(inputs), yUp);
}

std::vector<Point> shownPoints(const FusionResults& results, FusionView view) {
  std::vector<Point> tile = tilePoints(results);
  std::vector<Point> shown;
  if (results.fused) {
    shown = bothShapes(results);
  } else {
    shown = usedPoints(*results.inputs.base);
    shown.insert(shown.end(), tile.begin(), tile.end());
  }
  if (view == FusionView::Whole || tile.empty()) {
    return shown;
  }
  const Eigen::AlignedBox3d box = boxOf(shown);
  const Point centre = boxOf(tile).center();
  for (Point& p : tile) {
    p = (centre + kSurroundings * (p - centre)).cwiseMax(box.min()).cwiseMin(box.max());
  }
  return tile;
}

PictureCamera cameraFor(const FusionResults& results, FusionView view, const ViewDirection& direction,
                        double aspect) {
  PictureCamera whole = frame(shownPoints(results, FusionView::Whole), direction, aspect);
  if (view == FusionView::Whole) {
    return whole;
  }
  const PictureCamera near = frame(shownPoints(results, view), direction, aspect);
  // Of a tile that is most of the shape, the surroundings are more than the shape.
  const auto distance = [](const PictureCamera& camera) { return (camera.position - camera.pivot).norm(); };
  return distance(near) < distance(whole) ? near : whole;
}

std::vector<Point> morphed(const FusionResults& results, double weight) {
  std::vector<Point> points = results.join->points;
  const CombinedTile& combined = *results.combined;
  const std::vector<Index>& target = results.join->tileVertices;
  for (std::size_t i = 0; i < target.size(); ++i) {
    points[static_cast<std::size_t>(target[i])] = weight * combined.part[i] + (1 - weight) * combined.base[i];
  }
  return points;
}

}  // namespace graftsman
