#include "core/mesh/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
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

// Buckets the halfedges by their smaller vertex, then matches within a bucket: linear, no hashing.
void TriangleMesh::pairHalfedges() {
  const auto smaller = [this](Index h) { return std::min(from(h), to(h)); };
  std::vector<Index> start(points_.size() + 1, 0);
  for (Index h = 0; h < halfedgeCount(); ++h) {
    ++start[static_cast<std::size_t>(smaller(h)) + 1];
  }
  for (std::size_t v = 1; v < start.size(); ++v) {
    start[v] += start[v - 1];
  }
  std::vector<std::pair<Index, Index>> bucketed(
      static_cast<std::size_t>(halfedgeCount()));  // (larger, halfedge)
  std::vector<Index> fill(start.begin(), start.end() - 1);
  for (Index h = 0; h < halfedgeCount(); ++h) {
    const Index low = smaller(h);
    const auto slot = static_cast<std::size_t>(fill[static_cast<std::size_t>(low)]++);
    bucketed[slot] = {from(h) == low ? to(h) : from(h), h};
  }
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    const auto begin = bucketed.begin() + start[v];
    const auto end = bucketed.begin() + start[v + 1];
    std::sort(begin, end);
    for (auto group = begin; group != end;) {
      const auto groupEnd = std::find_if(group, end, [&](const auto& e) { return e.first != group->first; });
      const auto count = groupEnd - group;
      if (count == 2 && from(group[0].second) != from(group[1].second)) {
        twins_[static_cast<std::size_t>(group[0].second)] = group[1].second;
        twins_[static_cast<std::size_t>(group[1].second)] = group[0].second;
      } else if (count > 1) {
        singular_[v] = true;
        singular_[static_cast<std::size_t>(group->first)] = true;
      }
      group = groupEnd;
    }
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
