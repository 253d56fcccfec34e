#include "widgets/viewport/coarse_faces.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace graftsman {
namespace {

constexpr double kCellsAcross = 128;
constexpr std::uint64_t kMostCells = 1 << 20;  // along a side

std::uint64_t cellOf(double place) {
  return place > 0 ? static_cast<std::uint64_t>(std::min(place, static_cast<double>(kMostCells - 1))) : 0;
}

// Which of the six sides a normal looks to.
std::uint64_t sideOf(const Eigen::Vector3f& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return static_cast<std::uint64_t>(2 * axis + (normal[axis] < 0 ? 1 : 0));
}

/// Of each vertex whether its faces do not close round it.
std::vector<bool> findBorder(Index vertexCount, std::span<const Face> faces) {
  // Over a closed fan these differences cancel.
  std::vector<std::int64_t> sums(static_cast<std::size_t>(vertexCount), 0);
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      sums[static_cast<std::size_t>(face[k])] += face[(k + 1) % 3] - face[(k + 2) % 3];
    }
  }
  std::vector<bool> border(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    border[v] = sums[v] != 0;
  }
  return border;
}

class Coarsener {
 public:
  Coarsener(const float* positions, const float* normals, std::span<const Face> faces,
            const ClusterGrid& grid)
      : positions_(positions), normals_(normals), faces_(faces), grid_(grid) {}

  CoarseFaces run(Index vertexCount, const std::vector<bool>& kept) {
    cluster(vertexCount, kept);
    CoarseFaces coarse;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      Face face;
      for (std::size_t k = 0; k < 3; ++k) {
        face[k] = nearest_[static_cast<std::size_t>(clusters_[static_cast<std::size_t>(faces_[f][k])])];
      }
      if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) {
        turnOutward(face);
        coarse.faces.push_back(face);
        coarse.sources.push_back(static_cast<Index>(f));
      }
    }
    return coarse;
  }

 private:
  [[nodiscard]] Eigen::Vector3f position(Index v) const { return at(positions_, v); }
  [[nodiscard]] Eigen::Vector3f normal(Index v) const { return at(normals_, v); }
  static Eigen::Vector3f at(const float* values, Index v) {
    return Eigen::Vector3f::Map(values + std::ptrdiff_t{3} * v);
  }

  void cluster(Index vertexCount, const std::vector<bool>& kept) {
    clusters_.reserve(static_cast<std::size_t>(vertexCount));
    for (Index v = 0; v < vertexCount; ++v) {
      const Eigen::Vector3d place = (position(v).cast<double>() - grid_.origin) / grid_.cell;
      std::uint64_t key = ~static_cast<std::uint64_t>(v);
      if (kept.empty() || !kept[static_cast<std::size_t>(v)]) {
        key = ((cellOf(place.x()) * kMostCells + cellOf(place.y())) * kMostCells + cellOf(place.z())) * 6 +
              sideOf(normal(v));
      }
      const double distance = (place.array() - place.array().floor() - 0.5).square().sum();
      const auto [entry, added] = numbers_.try_emplace(key, static_cast<Index>(nearest_.size()));
      const auto number = static_cast<std::size_t>(entry->second);
      clusters_.push_back(entry->second);
      if (added) {
        nearest_.push_back(v);
        distances_.push_back(distance);
      } else if (distance < distances_[number]) {
        nearest_[number] = v;
        distances_[number] = distance;
      }
    }
  }

  /// A face that would be lit from behind is turned.
  void turnOutward(Face& face) const {
    const Eigen::Vector3f a = position(face[0]);
    const Eigen::Vector3f outward = normal(face[0]) + normal(face[1]) + normal(face[2]);
    if ((position(face[1]) - a).cross(position(face[2]) - a).dot(outward) < 0) {
      std::swap(face[1], face[2]);
    }
  }

  const float* positions_;
  const float* normals_;
  std::span<const Face> faces_;
  const ClusterGrid& grid_;
  std::unordered_map<std::uint64_t, Index> numbers_;  // of the clusters
  std::vector<Index> clusters_;                       // of each vertex, its cluster
  std::vector<Index> nearest_;                        // of each cluster, the vertex that stands for it,
  std::vector<double> distances_;                     // and its squared distance from the cube's middle
};

}  // namespace

ClusterGrid ClusterGrid::across(double size, const Eigen::Vector3d& origin) {
  return {origin, size > 0 ? size / kCellsAcross : 1};
}

CoarseFaces coarsen(const float* positions, const float* normals, Index vertexCount,
                    std::span<const Face> faces, const ClusterGrid& grid) {
  if (faces.size() <= kManyDrawnFaces) {
    return {};
  }
  const auto run = [&](const std::vector<bool>& kept) {
    return Coarsener(positions, normals, faces, grid).run(vertexCount, kept);
  };
  CoarseFaces coarse = run(findBorder(vertexCount, faces));
  // A surface of scraps is all border.
  return coarse.faces.size() <= kManyDrawnFaces ? std::move(coarse) : run({});
}

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Point& point : mesh.points()) {
    box.extend(point);
  }
  return box;
}

CoarseFaces coarsen(const TriangleMesh& mesh, std::span<const Index> meshVertices,
                    std::span<const Eigen::Vector3f> normals, std::span<const Face> faces,
                    const Eigen::AlignedBox3d& box) {
  if (faces.size() <= kManyDrawnFaces) {
    return {};
  }
  // Within [0, 1], whatever the model's unit.
  const double unit = 1 / std::max(box.sizes().maxCoeff(), std::numeric_limits<double>::min());
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(meshVertices.size());
  for (const Index v : meshVertices) {
    positions.emplace_back((unit * (mesh.point(v) - box.min())).cast<float>());
  }
  return coarsen(positions[0].data(), normals[0].data(), static_cast<Index>(positions.size()), faces,
                 ClusterGrid::across(1));
}

}  // namespace graftsman
