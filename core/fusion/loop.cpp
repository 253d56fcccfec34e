#include "core/fusion/loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>
#include <tuple>

#include "core/mesh/point_insertion.h"

namespace graftsman {
namespace {

/// How far the weights' sum may be from 1: what files with seven digits a weight are off.
constexpr double kWeightSumTolerance = 1e-6;

/// A CV that is not at a vertex, as a point of one face beside it; a point on an edge has one of each face.
struct PointInFace {
  Index face;
  Index vertex;  // its number in the divided mesh
  Eigen::Vector3d weights;
};

class Anchorer {
 public:
  Anchorer(const std::shared_ptr<const TriangleMesh>& mesh, const Loop& loop, Side side)
      : mesh_(*mesh), shared_(mesh), loop_(loop), side_(side) {}

  Result<AnchoredLoop> run() {
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      if (auto error = place(static_cast<int>(i))) {
        return fail(std::move(*error));
      }
    }
    if (auto error = findRepeatedVertex()) {
      return fail(std::move(*error));
    }
    if (inFaces_.empty()) {
      return AnchoredLoop{shared_, std::move(cvs_), {}};
    }
    return divide();
  }

 private:
  [[nodiscard]] Error error(ErrorCode code, int cv, const std::string& what) const {
    return {code, "CV " + std::to_string(cv) + " on the " + name(side_) + " " + what, side_, {cv}};
  }

  [[nodiscard]] Error repeated(int a, int b) const {
    const auto [first, second] = std::minmax({a, b});
    return {ErrorCode::LoopRepeatsPoint,
            "CV " + std::to_string(first) + " and CV " + std::to_string(second) + " on the " + name(side_) +
                " are the same point: move one of them, or remove its pair.",
            side_,
            {first, second}};
  }

  std::optional<Error> place(int cv) {
    const CVP& pair = loop_[static_cast<std::size_t>(cv)];
    const SurfacePoint& p = side_ == Side::Part ? pair.part : pair.base;
    if (p.vertex >= 0) {
      return placeAtVertex(cv, p.vertex);
    }
    if (p.face < 0 || p.face >= mesh_.faceCount()) {
      return error(ErrorCode::LoopIndexOutOfRange, cv,
                   "names face " + std::to_string(p.face) + ", but the mesh has " +
                       std::to_string(mesh_.faceCount()) + " faces, from 0. Pick it anew.");
    }
    const double sum = p.bary.sum();
    if (!p.bary.allFinite() || p.bary.minCoeff() < 0 || std::abs(sum - 1) > kWeightSumTolerance) {
      std::ostringstream what;
      what << "has barycentric coordinates " << p.bary.x() << ", " << p.bary.y() << ", " << p.bary.z()
           << " in face " << p.face << ": none may be negative, and their sum must be 1. Pick it anew.";
      return error(ErrorCode::LoopPointInvalid, cv, what.str());
    }
    const Eigen::Vector3d weights = p.bary / sum;
    for (int k = 0; k < 3; ++k) {
      if (weights[k] == 1) {
        return placeAtVertex(cv, mesh_.from(3 * p.face + k));
      }
    }
    for (int k = 0; k < 3; ++k) {
      if (weights[(k + 2) % 3] == 0) {
        return placeOnEdge(cv, 3 * p.face + k, weights[k], weights[(k + 1) % 3]);
      }
    }
    placeInFace(cv, p.face, weights);
    return {};
  }

  std::optional<Error> placeAtVertex(int cv, Index v) {
    if (v >= mesh_.vertexCount()) {
      return error(ErrorCode::LoopIndexOutOfRange, cv,
                   "names vertex " + std::to_string(v) + ", but the mesh has " +
                       std::to_string(mesh_.vertexCount()) + " vertices, from 0. Pick it anew.");
    }
    if (mesh_.singular(v)) {
      return error(ErrorCode::LoopPointSingular, cv,
                   "is at vertex " + std::to_string(v) +
                       (mesh_.outgoing(v) < 0 ? ", which belongs to no face. Pick another."
                                              : ", where the mesh is not manifold. Move it away from there, "
                                                "or repair the mesh."));
    }
    cvs_.push_back(v);
    return {};
  }

  // On the halfedge, with the weights of its start and end.
  std::optional<Error> placeOnEdge(int cv, Index h, double start, double end) {
    if (edgeHasManyFaces(h)) {
      return error(ErrorCode::LoopPointSingular, cv,
                   "is on the edge between vertices " + std::to_string(mesh_.from(h)) + " and " +
                       std::to_string(mesh_.to(h)) +
                       ", where the mesh is not manifold. Move it away from there, or repair the mesh.");
    }
    const auto weights = [](Index halfedge, double atStart, double atEnd) {
      Eigen::Vector3d w = Eigen::Vector3d::Zero();
      w[halfedge % 3] = atStart;
      w[TriangleMesh::next(halfedge) % 3] = atEnd;
      return w;
    };
    const Index vertex = addVertex(cv);
    const Index t = mesh_.twin(h);
    inFaces_.push_back({TriangleMesh::faceOf(h), vertex, weights(h, start, end)});
    if (t >= 0) {
      inFaces_.push_back({TriangleMesh::faceOf(t), vertex, weights(t, end, start)});
    }
    const bool turned = t >= 0 && t < h;  // so that the same point has the same bits from both faces
    const EdgePoint point = {-1, turned ? t : h, (turned ? start : end) / (start + end)};
    newPoints_.push_back(position(mesh_, point));
    return {};
  }

  void placeInFace(int cv, Index face, const Eigen::Vector3d& weights) {
    const auto& [a, b, c] = mesh_.face(face);
    inFaces_.push_back({face, addVertex(cv), weights});
    const Point& origin = mesh_.point(a);  // differences keep the digits of a small model far from the origin
    newPoints_.push_back(origin + weights[1] * (mesh_.point(b) - origin) +
                         weights[2] * (mesh_.point(c) - origin));
  }

  Index addVertex(int cv) {
    const Index vertex = mesh_.vertexCount() + static_cast<Index>(newCvs_.size());
    newCvs_.push_back(cv);
    cvs_.push_back(vertex);
    return vertex;
  }

  // An edge without a twin that is no border edge. Its ends are singular, so nearly always this costs
  // nothing.
  [[nodiscard]] bool edgeHasManyFaces(Index h) const {
    if (mesh_.twin(h) >= 0 || !mesh_.singular(mesh_.from(h)) || !mesh_.singular(mesh_.to(h))) {
      return false;
    }
    const auto ends = std::minmax({mesh_.from(h), mesh_.to(h)});
    for (Index other = 0; other < mesh_.halfedgeCount(); ++other) {
      if (other != h && std::minmax({mesh_.from(other), mesh_.to(other)}) == ends) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] std::optional<Error> findRepeatedVertex() const {
    std::vector<std::pair<Index, int>> sorted;
    for (std::size_t i = 0; i < cvs_.size(); ++i) {
      sorted.emplace_back(cvs_[i], static_cast<int>(i));
    }
    std::sort(sorted.begin(), sorted.end());
    const auto at = std::adjacent_find(sorted.begin(), sorted.end(),
                                       [](const auto& a, const auto& b) { return a.first == b.first; });
    if (at == sorted.end()) {
      return {};
    }
    return repeated(at->second, (at + 1)->second);
  }

  Result<AnchoredLoop> divide() {
    std::sort(inFaces_.begin(), inFaces_.end(), [](const PointInFace& a, const PointInFace& b) {
      return std::tie(a.face, a.vertex) < std::tie(b.face, b.vertex);
    });
    std::vector<Point> points = mesh_.points();
    points.insert(points.end(), newPoints_.begin(), newPoints_.end());
    std::vector<Face> faces = mesh_.faces();
    std::vector<Index> parents(faces.size());
    for (Index f = 0; f < mesh_.faceCount(); ++f) {
      parents[static_cast<std::size_t>(f)] = f;
    }
    for (auto p = inFaces_.begin(); p != inFaces_.end();) {
      const Index face = p->face;
      PointInsertion pieces(mesh_.face(face));
      for (; p != inFaces_.end() && p->face == face; ++p) {
        if (const Index same = pieces.insert(p->vertex, p->weights); same >= 0) {
          return fail(repeated(cvAt(same), cvAt(p->vertex)));
        }
      }
      const std::vector<Face> made = pieces.pieces();
      faces[static_cast<std::size_t>(face)] = made[0];
      faces.insert(faces.end(), made.begin() + 1, made.end());
      parents.resize(faces.size(), face);
    }
    auto mesh = std::make_shared<const TriangleMesh>(std::move(points), std::move(faces));
    for (std::size_t i = 0; i < cvs_.size(); ++i) {
      if (mesh->singular(cvs_[i])) {  // two faces that share an edge and their third vertex, divided there
        return fail(
            error(ErrorCode::LoopPointSingular, static_cast<int>(i),
                  "is where two faces lie on each other. Move it away from there, or repair the mesh."));
      }
    }
    return AnchoredLoop{std::move(mesh), std::move(cvs_), std::move(parents)};
  }

  // Of a new vertex; weights of a new point are no corner's, so no other vertex is asked for.
  [[nodiscard]] int cvAt(Index vertex) const {
    assert(vertex >= mesh_.vertexCount());
    return newCvs_[static_cast<std::size_t>(vertex - mesh_.vertexCount())];
  }

  const TriangleMesh& mesh_;
  const std::shared_ptr<const TriangleMesh>& shared_;
  const Loop& loop_;
  const Side side_;
  std::vector<Index> cvs_;
  std::vector<int> newCvs_;       // the CV at each new vertex
  std::vector<Point> newPoints_;  // its position
  std::vector<PointInFace> inFaces_;
};

}  // namespace

Result<AnchoredLoop> anchorPoints(const std::shared_ptr<const TriangleMesh>& mesh, const Loop& pairs,
                                  Side side) {
  return Anchorer(mesh, pairs, side).run();
}

Result<AnchoredLoop> anchorLoop(const std::shared_ptr<const TriangleMesh>& mesh, const Loop& loop,
                                Side side) {
  if (loop.size() < 3) {
    return fail(Error{ErrorCode::LoopTooShort,
                      "The loop has " + std::to_string(loop.size()) +
                          (loop.size() == 1 ? " pair" : " pairs") + " and needs at least 3: pick more.",
                      side});
  }
  return anchorPoints(mesh, loop, side);
}

}  // namespace graftsman
