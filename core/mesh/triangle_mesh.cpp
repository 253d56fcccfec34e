#include "core/mesh/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <memory>
#include <span>
#include <utility>

namespace graftsman {

TriangleMesh::TriangleMesh(std::vector<Point> points, std::vector<Face> faces)
    : points_(std::move(points)),
      faces_(std::move(faces)),
      twins_(3 * faces_.size(), -1),
      outgoing_(points_.size(), -1),
      singular_(points_.size(), false) {
  Eigen::AlignedBox3d box;
  for (const Face& face : faces_) {
    for (const Index v : face) {
      assert(v >= 0 && v < vertexCount());
      box.extend(point(v));
    }
  }
  diagonal_ = faces_.empty() ? 0 : box.diagonal().norm();
  pairHalfedges();
  findFans();
}

namespace {

// A halfedge in the bucket of its smaller vertex.
struct Bucketed {
  Index larger;    // the other vertex
  Index halfedge;  // of the pair it may form
  auto operator<=>(const Bucketed&) const = default;
};

// Up to so many halfedges are matched by looking at all pairs; a bucket usually has six.
constexpr std::size_t kFewHalfedges = 16;

// Twins for the halfedges between v and greater vertices, of which each edge's are in `bucket`.
void pairBucket(Index v, std::span<Bucketed> bucket, const TriangleMesh& mesh, std::vector<Index>& twins,
                std::vector<bool>& singular) {
  const bool few = bucket.size() <= kFewHalfedges;
  if (!few) {
    std::sort(bucket.begin(), bucket.end());
  }
  for (std::size_t i = 0; i < bucket.size(); ++i) {
    const Index larger = bucket[i].larger;
    const Index halfedge = bucket[i].halfedge;
    // In a sorted bucket two neighbours on either side tell whether the edge has one, two or more.
    const std::size_t first = few ? 0 : i - std::min<std::size_t>(i, 2);
    const std::size_t last = few ? bucket.size() : std::min(bucket.size(), i + 3);
    std::size_t others = 0;
    Index other = -1;
    for (std::size_t j = first; j < last; ++j) {
      const bool same = bucket[j].larger == larger && j != i;
      others += same ? 1 : 0;
      other = same ? bucket[j].halfedge : other;
    }
    if (others == 1 && mesh.from(halfedge) != mesh.from(other)) {
      twins[static_cast<std::size_t>(halfedge)] = other;
    } else if (others > 0) {
      singular[static_cast<std::size_t>(v)] = true;
      singular[static_cast<std::size_t>(larger)] = true;
    }
  }
}

}  // namespace

// Buckets the halfedges by their smaller vertex, then matches within a bucket: linear, no hashing.
void TriangleMesh::pairHalfedges() {
  std::vector<Index> ends(points_.size() + 1, 0);  // of the buckets, once they are filled
  for (const Face& face : faces_) {
    ++ends[static_cast<std::size_t>(std::min(face[0], face[1]))];
    ++ends[static_cast<std::size_t>(std::min(face[1], face[2]))];
    ++ends[static_cast<std::size_t>(std::min(face[2], face[0]))];
  }
  Index sum = 0;
  for (Index& end : ends) {
    sum += std::exchange(end, sum);  // its beginning, until it is filled
  }
  const auto bucketed = std::make_unique_for_overwrite<Bucketed[]>(static_cast<std::size_t>(halfedgeCount()));
  Index halfedge = 0;
  for (const Face& face : faces_) {
    for (const auto& [a, b] :
         {std::pair(face[0], face[1]), std::pair(face[1], face[2]), std::pair(face[2], face[0])}) {
      Index& end = ends[static_cast<std::size_t>(std::min(a, b))];
      bucketed[static_cast<std::size_t>(end++)] = {std::max(a, b), halfedge++};
    }
  }
  Index begin = 0;
  for (Index v = 0; v < vertexCount(); ++v) {
    const Index end = ends[static_cast<std::size_t>(v)];
    pairBucket(v, {bucketed.get() + begin, static_cast<std::size_t>(end - begin)}, *this, twins_, singular_);
    begin = end;
  }
}

void TriangleMesh::findFans() {
  std::vector<Index> degree(points_.size(), 0);
  for (Index h = 0; h < halfedgeCount(); ++h) {
    const auto v = static_cast<std::size_t>(from(h));
    ++degree[v];
    if (outgoing_[v] < 0 || twin(h) < 0) {
      outgoing_[v] = h;
    }
  }
  for (Index v = 0; v < vertexCount(); ++v) {
    const Index first = outgoing(v);
    Index reached = 0;
    for (Index h = first; h >= 0;) {
      ++reached;
      h = twin(prev(h));
      if (h == first) {
        break;
      }
    }
    if (reached == 0 || reached != degree[static_cast<std::size_t>(v)]) {
      singular_[static_cast<std::size_t>(v)] = true;
    }
  }
}

Index TriangleMesh::halfedgeBetween(Index a, Index b) const {
  const Index first = outgoing(a);
  for (Index h = first; h >= 0;) {
    if (to(h) == b) {
      return h;
    }
    const Index last = prev(h);
    if (twin(last) < 0 && from(last) == b) {
      return -1;  // b → a exists on the border; a → b does not
    }
    h = twin(last);
    if (h == first) {
      break;
    }
  }
  return -1;
}

}  // namespace graftsman
