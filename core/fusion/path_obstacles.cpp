#include "core/fusion/path_obstacles.h"

#include <algorithm>
#include <cassert>

namespace graftsman {

PathObstacles::PathObstacles(const TriangleMesh& mesh, bool keepOffBorder)
    : mesh_(&mesh), keepOffBorder_(keepOffBorder) {}

void PathObstacles::allocate() {
  if (!vertexOwners_.allocated()) {
    vertexOwners_ = ZeroedArray<int>(static_cast<std::size_t>(mesh_->vertexCount()));
    edgeSlots_ = ZeroedArray<Index>(static_cast<std::size_t>(mesh_->halfedgeCount()));
    faceSlots_ = ZeroedArray<Index>(static_cast<std::size_t>(mesh_->faceCount()));
  }
}

PathObstacles::EdgeMarks& PathObstacles::marksToWrite(Index edge) {
  Index& slot = edgeSlots_[edge];
  if (slot == 0) {
    edges_.emplace_back();
    slot = static_cast<Index>(edges_.size());
  }
  return edges_[static_cast<std::size_t>(slot) - 1];
}

void PathObstacles::addCv(Index vertex, int cv) {
  allocate();
  vertexOwners_[vertex] = -cv - 1;
}

void PathObstacles::addPath(std::span<const EdgePoint> points, int path) {
  allocate();
  for (const EdgePoint& p : points) {
    if (p.isVertex()) {
      int& owner = vertexOwners_[p.vertex];
      owner = owner == 0 ? path + 1 : owner;  // a CV stays a CV
      continue;
    }
    auto& crossings = marksToWrite(p.halfedge).crossings;
    const auto at = std::find_if(crossings.begin(), crossings.end(),
                                 [&](const Crossing& crossing) { return crossing.t >= p.t; });
    crossings.insert(at, {p.t, path});
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto [edge, face] = sharedPlace(*mesh_, points[i], points[i + 1]);
    if (face < 0) {
      assert(edge >= 0);
      marksToWrite(edge).along = path;
      continue;
    }
    Index& slot = faceSlots_[face];
    if (slot == 0) {
      chords_.emplace_back();
      slot = static_cast<Index>(chords_.size());
    }
    chords_[static_cast<std::size_t>(slot) - 1].push_back(
        {perimeterPosition(*mesh_, face, points[i]), perimeterPosition(*mesh_, face, points[i + 1]), path});
  }
}

const PathObstacles::EdgeMarks* PathObstacles::marks(Index h) const {
  const Index slot = edgeSlots_.allocated() ? edgeSlots_[canonical(*mesh_, h)] : 0;
  return slot == 0 ? nullptr : &edges_[static_cast<std::size_t>(slot) - 1];
}

const std::vector<PathObstacles::Chord>* PathObstacles::chords(Index face) const {
  const Index slot = faceSlots_.allocated() ? faceSlots_[face] : 0;
  return slot == 0 ? nullptr : &chords_[static_cast<std::size_t>(slot) - 1];
}

// The interval below crossing k; that above the last for k = number of crossings.
PathObstacles::Interval PathObstacles::between(const EdgeMarks* marks, Index edge, std::size_t k) const {
  const std::size_t count = marks ? marks->crossings.size() : 0;
  Interval interval;
  interval.loBlocked = k > 0 || blocked(mesh_->from(edge));
  interval.hiBlocked = k < count || blocked(mesh_->to(edge));
  interval.lo = k > 0 ? marks->crossings[k - 1].t : 0;
  interval.hi = k < count ? marks->crossings[k].t : 1;
  return interval;
}

PathObstacles::Interval PathObstacles::intervalNear(Index h, Index v) const {
  const Index edge = canonical(*mesh_, h);
  const EdgeMarks* m = marks(h);
  return between(m, edge, m && v == mesh_->to(edge) ? m->crossings.size() : 0);
}

PathObstacles::Interval PathObstacles::intervalAround(Index h, double t) const {
  const EdgeMarks* m = marks(h);
  std::size_t k = 0;
  while (m && k < m->crossings.size() && m->crossings[k].t < t) {
    ++k;
  }
  return between(m, canonical(*mesh_, h), k);
}

std::vector<PathObstacles::Interval> PathObstacles::intervals(Index h) const {
  const EdgeMarks* m = marks(h);
  std::vector<Interval> result;
  if (m && m->along >= 0) {
    return result;
  }
  for (std::size_t k = 0; k <= (m ? m->crossings.size() : 0); ++k) {
    result.push_back(between(m, canonical(*mesh_, h), k));
  }
  return result;
}

bool PathObstacles::touches(Index h) const {
  return marks(h) != nullptr || blocked(mesh_->from(h)) || blocked(mesh_->to(h));
}

bool PathObstacles::permits(const EdgePoint& a, const EdgePoint& b) const {
  const SharedPlace place = sharedPlace(*mesh_, a, b);
  const Index edge = place.edge;
  if (edge < 0) {
    return place.face >= 0 && permitsIn(place.face, a, b);
  }
  const EdgeMarks* m = marks(edge);
  if (!m) {
    return true;
  }
  const auto t = [&](const EdgePoint& p) {
    return p.isVertex() ? (p.vertex == mesh_->to(edge) ? 1.0 : 0.0) : p.t;
  };
  const double low = std::min(t(a), t(b));
  const double high = std::max(t(a), t(b));
  return m->along < 0 && std::none_of(m->crossings.begin(), m->crossings.end(),
                                      [&](const Crossing& c) { return low <= c.t && c.t <= high; });
}

bool PathObstacles::permitsIn(Index face, const EdgePoint& a, const EdgePoint& b) const {
  const auto* inFace = chords(face);
  if (!inFace) {
    return true;
  }
  const PerimeterPosition p = perimeterPosition(*mesh_, face, a);
  const PerimeterPosition q = perimeterPosition(*mesh_, face, b);
  return std::none_of(inFace->begin(), inFace->end(),
                      [&](const Chord& chord) { return chordsCross(chord.a, chord.b, p, q); });
}

bool PathObstacles::permitsAlong(Index h) const {
  const EdgeMarks* m = marks(h);
  return !m || (m->along < 0 && m->crossings.empty());
}

std::optional<PathObstacles::Conflict> PathObstacles::conflictAt(const EdgePoint& p) const {
  if (p.isVertex()) {
    const int owner = vertexOwners_.allocated() ? vertexOwners_[p.vertex] : 0;
    return owner > 0   ? std::optional(Conflict{owner - 1, -1})
           : owner < 0 ? std::optional(Conflict{-1, -owner - 1})
                       : std::nullopt;
  }
  if (const EdgeMarks* m = marks(p.halfedge)) {
    if (m->along >= 0) {
      return Conflict{m->along, -1};
    }
    for (const Crossing& crossing : m->crossings) {
      if (crossing.t == p.t) {
        return Conflict{crossing.path, -1};
      }
    }
  }
  return std::nullopt;
}

std::optional<PathObstacles::Conflict> PathObstacles::conflictBetween(const EdgePoint& a,
                                                                      const EdgePoint& b) const {
  const auto [edge, face] = sharedPlace(*mesh_, a, b);
  if (edge >= 0) {
    const EdgeMarks* m = marks(edge);
    if (m && m->along >= 0) {
      return Conflict{m->along, -1};
    }
    if (m && !m->crossings.empty() && !permits(a, b)) {
      return Conflict{m->crossings.front().path, -1};
    }
    return std::nullopt;
  }
  if (const auto* inFace = chords(face)) {
    const PerimeterPosition p = perimeterPosition(*mesh_, face, a);
    const PerimeterPosition q = perimeterPosition(*mesh_, face, b);
    for (const Chord& chord : *inFace) {
      if (chordsCross(chord.a, chord.b, p, q)) {
        return Conflict{chord.path, -1};
      }
    }
  }
  return std::nullopt;
}

std::optional<PathObstacles::Conflict> PathObstacles::conflict(std::span<const EdgePoint> points) const {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (i > 0) {
      if (auto found = conflictAt(points[i])) {
        return found;
      }
    }
    if (auto found = conflictBetween(points[i], points[i + 1])) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace graftsman
