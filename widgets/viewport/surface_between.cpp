#include "widgets/viewport/surface_between.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/base/parallel.h"
#include "core/mesh/at.h"

namespace graftsman {
namespace {

constexpr std::size_t kGrain = 4096;  // vertices or faces of one thread's turn

using Pair = std::array<Index, 2>;

// Gives each mesh vertex's corners their drawn vertices: one for each pair of shaded vertices.
class Divider {
 public:
  Divider(const TriangleMesh& mesh, const Shading& a, const Shading& b) : mesh_(mesh), a_(a), b_(b) {}

  BetweenLayout run() {
    const Index count = mesh_.vertexCount();
    layout_.faces = mesh_.faces();
    layout_.meshVertices.resize(at(count));
    std::iota(layout_.meshVertices.begin(), layout_.meshVertices.end(), 0);
    layout_.shaded.resize(at(count));
    layout_.firstExtra.reserve(at(count) + 1);
    const VertexFans fans = findFans(mesh_.faces(), count);
    for (Index v = 0; v < count; ++v) {
      layout_.firstExtra.push_back(static_cast<Index>(layout_.meshVertices.size()) - count);
      divide(v, std::span(fans.faces)
                    .subspan(at(fans.first[at(v)]), at(fans.first[at(v) + 1] - fans.first[at(v)])));
    }
    layout_.firstExtra.push_back(static_cast<Index>(layout_.meshVertices.size()) - count);
    layout_.fans = findFans(layout_.faces, static_cast<Index>(layout_.meshVertices.size()));
    return std::move(layout_);
  }

 private:
  void divide(Index v, std::span<const Index> fan) {
    const std::size_t firstExtra = layout_.meshVertices.size();
    layout_.shaded[at(v)] = {v, v};
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const std::size_t f = at(fan[i]);
      const Face& face = mesh_.faces()[f];
      const auto corner = static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
      const Pair pair = {a_.faces[f][corner], b_.faces[f][corner]};
      if (i == 0) {
        layout_.shaded[at(v)] = pair;
      } else if (pair != layout_.shaded[at(v)]) {
        layout_.faces[f][corner] = extra(v, pair, firstExtra);
      }
    }
  }

  Index extra(Index v, const Pair& pair, std::size_t first) {
    const auto begin = layout_.shaded.begin() + static_cast<std::ptrdiff_t>(first);
    const auto found = std::find(begin, layout_.shaded.end(), pair);
    const auto drawn = static_cast<Index>(found - layout_.shaded.begin());
    if (found == layout_.shaded.end()) {
      layout_.meshVertices.push_back(v);
      layout_.shaded.push_back(pair);
    }
    return drawn;
  }

  const TriangleMesh& mesh_;
  const Shading& a_;
  const Shading& b_;
  BetweenLayout layout_;
};

// The normals of one mesh vertex's drawn vertices.
class NormalsOf {
 public:
  NormalsOf(const BetweenLayout& layout, std::span<const Eigen::Vector3f> areas)
      : layout_(layout), areas_(areas) {}

  [[nodiscard]] Eigen::Vector3f single(Index drawn) const { return sum(drawn).normalized(); }

  // Among the drawn vertices of mesh vertex v.
  [[nodiscard]] Eigen::Vector3f mixed(Index v, Index drawn, float t) const {
    Eigen::Vector3f first = Eigen::Vector3f::Zero();
    Eigen::Vector3f second = Eigen::Vector3f::Zero();
    const Pair& own = layout_.shaded[at(drawn)];
    const auto add = [&](Index other) {
      const Pair& pair = layout_.shaded[at(other)];
      const Eigen::Vector3f area = sum(other);
      if (pair[0] == own[0]) {
        first += area;
      }
      if (pair[1] == own[1]) {
        second += area;
      }
    };
    add(v);
    const Index vertices = static_cast<Index>(layout_.firstExtra.size()) - 1;
    for (Index i = layout_.firstExtra[at(v)]; i < layout_.firstExtra[at(v) + 1]; ++i) {
      add(vertices + i);
    }
    return ((1 - t) * first.normalized() + t * second.normalized()).normalized();
  }

 private:
  [[nodiscard]] Eigen::Vector3f sum(Index drawn) const {
    Eigen::Vector3f result = Eigen::Vector3f::Zero();
    for (Index i = layout_.fans.first[at(drawn)]; i < layout_.fans.first[at(drawn) + 1]; ++i) {
      result += areas_[at(layout_.fans.faces[at(i)])];
    }
    return result;
  }

  const BetweenLayout& layout_;
  std::span<const Eigen::Vector3f> areas_;
};

}  // namespace

BetweenLayout layOutBetween(const TriangleMesh& mesh, const Shading& a, const Shading& b) {
  return Divider(mesh, a, b).run();
}

void writeBetween(const BetweenLayout& layout, const TriangleMesh& a, const TriangleMesh& b, double t,
                  std::span<double> points, std::span<float> normals, std::span<Eigen::Vector3f> areas) {
  const std::size_t drawn = layout.meshVertices.size();
  assert(points.size() == 3 * drawn && normals.size() == 3 * drawn && areas.size() == layout.faces.size());
  const auto place = [points](std::size_t i) { return Eigen::Map<Point>(points.data() + 3 * i); };
  parallelRanges(drawn, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = layout.meshVertices[i];
      place(i) = (1 - t) * a.point(v) + t * b.point(v);
    }
  });
  const double unit = a.diagonal() > 0 ? 1 / a.diagonal() : 1;  // lengths that floats hold
  parallelRanges(areas.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Face& face = layout.faces[f];
      const Point corner = place(at(face[0]));
      const Eigen::Vector3d ab = unit * (place(at(face[1])) - corner);
      const Eigen::Vector3d ac = unit * (place(at(face[2])) - corner);
      areas[f] = ab.cross(ac).cast<float>();
    }
  });
  const NormalsOf normalsOf(layout, areas);
  const auto write = [normals](Index i, const Eigen::Vector3f& normal) {
    Eigen::Map<Eigen::Vector3f>(normals.data() + 3 * at(i)) = normal;
  };
  const std::size_t vertices = layout.firstExtra.size() - 1;
  parallelRanges(vertices, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      if (layout.firstExtra[i] == layout.firstExtra[i + 1]) {
        write(v, normalsOf.single(v));
        continue;
      }
      write(v, normalsOf.mixed(v, v, static_cast<float>(t)));
      for (Index extra = layout.firstExtra[i]; extra < layout.firstExtra[i + 1]; ++extra) {
        const Index drawnAs = static_cast<Index>(vertices) + extra;
        write(drawnAs, normalsOf.mixed(v, drawnAs, static_cast<float>(t)));
      }
    }
  });
}

}  // namespace graftsman
