#include "core/mesh/point_insertion.h"

#include <algorithm>
#include <cassert>

#include "core/mesh/barycentric.h"

namespace graftsman {

PointInsertion::PointInsertion(const Face& corners) : pieces_({{0, 1, 2}}) {
  for (int k = 0; k < 3; ++k) {
    sites_.push_back({corners[static_cast<std::size_t>(k)], Eigen::Vector3d::Unit(k)});
  }
}

Index PointInsertion::insert(Index id, const Eigen::Vector3d& weights) {
  const std::size_t site = sites_.size();
  const std::size_t count = pieces_.size();
  bool found = false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<std::size_t, 3> piece = pieces_[i];
    std::array<int, 3> turns;
    for (std::size_t k = 0; k < 3; ++k) {
      turns[k] = orientBarycentric(sites_[piece[k]].weights, sites_[piece[(k + 1) % 3]].weights, weights);
    }
    if (std::ranges::any_of(turns, [](int turn) { return turn < 0; })) {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (turns[k] == 0 && turns[(k + 2) % 3] == 0) {
        return sites_[piece[k]].id;
      }
    }
    // Each edge that the point is not on makes a piece with it; the first takes this piece's place. Of an
    // edge's two pieces both are met, as the walk goes on.
    bool first = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (turns[k] > 0) {
        const std::array<std::size_t, 3> made = {piece[k], piece[(k + 1) % 3], site};
        if (first) {
          pieces_[i] = made;
        } else {
          pieces_.push_back(made);
        }
        first = false;
      }
    }
    found = true;
  }
  assert(found);
  static_cast<void>(found);
  sites_.push_back({id, weights});
  return -1;
}

std::vector<Face> PointInsertion::pieces() const {
  std::vector<Face> faces;
  faces.reserve(pieces_.size());
  for (const auto& [a, b, c] : pieces_) {
    faces.push_back({sites_[a].id, sites_[b].id, sites_[c].id});
  }
  return faces;
}

}  // namespace graftsman
