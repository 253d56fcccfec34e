#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace graftsman {

/// Number of a vertex, face or halfedge; −1 stands for none.
using Index = std::int32_t;
/// A position, in the model's unit.
using Point = Eigen::Vector3d;
/// The three vertices of a triangle, counter-clockwise seen from outside.
using Face = std::array<Index, 3>;

/// A triangle mesh and who is beside whom. Immutable; share it by shared_ptr<const TriangleMesh>.
///
/// Halfedge h = 3f + k leads from corner k of face f to corner (k + 1) mod 3, with f on its left.
/// Any connectivity is allowed. An edge is *regular* if it has two faces that run through it in opposite
/// directions; an edge with one face is a border edge; any other edge (three faces, or two that disagree) has
/// no twins and its vertices are singular. A vertex is *singular* if its faces do not form exactly one fan,
/// closed or open (an isolated vertex is singular, too). Stages walk only over vertices that are not
/// singular.
class TriangleMesh {
 public:
  TriangleMesh() = default;

  /// points: V×3; faces: F×3. Precondition: every index is in [0, V), no face repeats a vertex, 3F < 2³¹.
  TriangleMesh(std::vector<Point> points, std::vector<Face> faces);

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] Index vertexCount() const { return static_cast<Index>(points_.size()); }
  [[nodiscard]] Index faceCount() const { return static_cast<Index>(faces_.size()); }
  [[nodiscard]] Index halfedgeCount() const { return 3 * faceCount(); }

  [[nodiscard]] const Point& point(Index v) const { return points_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] const Face& face(Index f) const { return faces_[static_cast<std::size_t>(f)]; }

  [[nodiscard]] static Index faceOf(Index h) { return h / 3; }
  [[nodiscard]] static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] Index from(Index h) const { return (&faces_[0][0])[h]; }
  [[nodiscard]] Index to(Index h) const { return from(next(h)); }

  /// The halfedge of the neighbouring face along the same edge, or −1 (border, or not a regular edge).
  [[nodiscard]] Index twin(Index h) const { return twins_[static_cast<std::size_t>(h)]; }

  /// A halfedge that leaves v, or −1 if v is isolated. If v lies on the border, the one that has no twin, so
  /// that h → twin(prev(h)) visits the whole fan counter-clockwise before it meets −1.
  [[nodiscard]] Index outgoing(Index v) const { return outgoing_[static_cast<std::size_t>(v)]; }

  /// True where the mesh is not manifold at v; see the class comment.
  [[nodiscard]] bool singular(Index v) const { return singular_[static_cast<std::size_t>(v)]; }

  /// True if some edge at v has no twin.
  [[nodiscard]] bool onBorder(Index v) const { return outgoing(v) < 0 || twin(outgoing(v)) < 0; }

  /// The halfedge from vertex a to vertex b, or −1. Costs the number of faces at a. Precondition: a is not
  /// singular.
  [[nodiscard]] Index halfedgeBetween(Index a, Index b) const;

  /// The length of the diagonal of the axis-aligned bounding box of the vertices that faces use; 0 without
  /// faces.
  [[nodiscard]] double diagonal() const { return diagonal_; }

 private:
  void pairHalfedges();
  void findFans();

  std::vector<Point> points_;
  std::vector<Face> faces_;
  std::vector<Index> twins_;
  std::vector<Index> outgoing_;
  std::vector<bool> singular_;
  double diagonal_ = 0;
};

}  // namespace graftsman
