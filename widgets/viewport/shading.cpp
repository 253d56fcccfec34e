#include "widgets/viewport/shading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace graftsman {
namespace {

class Shader {
 public:
  Shader(const TriangleMesh& mesh, double creaseAngle)
      : mesh_(mesh), creaseCosine_(static_cast<float>(std::cos(creaseAngle))) {}

  Shading run() {
    findFaceNormals();
    const auto vertexCount = static_cast<std::size_t>(mesh_.vertexCount());
    result_.faces = mesh_.faces();
    result_.meshVertices.resize(vertexCount);
    std::iota(result_.meshVertices.begin(), result_.meshVertices.end(), 0);
    result_.normals.assign(vertexCount, Eigen::Vector3f::Zero());
    for (Index v = 0; v < mesh_.vertexCount(); ++v) {
      if (!mesh_.singular(v)) {
        shadeFan(v);
      }
    }
    shadeSingular();
    for (Eigen::Vector3f& normal : result_.normals) {
      normal.normalize();  // leaves 0 as it is
    }
    return std::move(result_);
  }

 private:
  /// Face normals as long as the faces' areas, in units that floats hold.
  void findFaceNormals() {
    const double unit = mesh_.diagonal() > 0 ? 1 / mesh_.diagonal() : 1;
    faceNormals_.reserve(static_cast<std::size_t>(mesh_.faceCount()));
    for (const Face& face : mesh_.faces()) {
      const Point& a = mesh_.point(face[0]);
      const Eigen::Vector3d ab = unit * (mesh_.point(face[1]) - a);
      const Eigen::Vector3d ac = unit * (mesh_.point(face[2]) - a);
      faceNormals_.emplace_back(ab.cross(ac).cast<float>());
    }
  }

  [[nodiscard]] const Eigen::Vector3f& normalAt(Index halfedge) const {
    return faceNormals_[static_cast<std::size_t>(TriangleMesh::faceOf(halfedge))];
  }

  [[nodiscard]] bool isCrease(Index halfedge, Index nextInFan) const {
    const Eigen::Vector3f& a = normalAt(halfedge);
    const Eigen::Vector3f& b = normalAt(nextInFan);
    return a.dot(b) < creaseCosine_ * std::sqrt(a.squaredNorm() * b.squaredNorm());
  }

  /// Divides the faces round v at the creases; the first group keeps the shaded vertex v.
  void shadeFan(Index v) {
    fan_.clear();
    const Index first = mesh_.outgoing(v);
    Index h = first;
    do {
      fan_.push_back(h);
      h = mesh_.twin(TriangleMesh::prev(h));
    } while (h >= 0 && h != first);
    if (h == first) {
      startAtCrease();
    }
    Index shaded = v;
    result_.normals[static_cast<std::size_t>(v)] = normalAt(fan_[0]);
    for (std::size_t i = 1; i < fan_.size(); ++i) {
      if (isCrease(fan_[i - 1], fan_[i])) {
        shaded = addShadedVertex(v);
      }
      result_.normals[static_cast<std::size_t>(shaded)] += normalAt(fan_[i]);
      setCorner(fan_[i], shaded);
    }
  }

  /// Turns a closed fan so that it begins after a crease, if it has one.
  void startAtCrease() {
    for (std::size_t i = 0; i < fan_.size(); ++i) {
      if (isCrease(fan_[i], fan_[(i + 1) % fan_.size()])) {
        std::rotate(fan_.begin(), fan_.begin() + static_cast<std::ptrdiff_t>((i + 1) % fan_.size()),
                    fan_.end());
        return;
      }
    }
  }

  /// Where the mesh is not manifold, each corner is flat.
  void shadeSingular() {
    for (Index h = 0; h < mesh_.halfedgeCount(); ++h) {
      const Index v = mesh_.from(h);
      if (mesh_.singular(v)) {
        const Index shaded = addShadedVertex(v);
        result_.normals.back() = normalAt(h);
        setCorner(h, shaded);
      }
    }
  }

  Index addShadedVertex(Index v) {
    result_.meshVertices.push_back(v);
    result_.normals.emplace_back(Eigen::Vector3f::Zero());
    return static_cast<Index>(result_.meshVertices.size()) - 1;
  }

  void setCorner(Index halfedge, Index shaded) {
    result_.faces[static_cast<std::size_t>(TriangleMesh::faceOf(halfedge))]
                 [static_cast<std::size_t>(halfedge % 3)] = shaded;
  }

  const TriangleMesh& mesh_;
  float creaseCosine_;
  std::vector<Eigen::Vector3f> faceNormals_;
  std::vector<Index> fan_;  // halfedges that leave the vertex at work
  Shading result_;
};

}  // namespace

Shading shade(const TriangleMesh& mesh, double creaseAngle) {
  return Shader(mesh, creaseAngle).run();
}

}  // namespace graftsman
