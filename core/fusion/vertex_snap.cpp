#include "core/fusion/vertex_snap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/fusion/overlay_predicates.h"

namespace graftsman::overlay_detail {
namespace {

// Of the shortest edge at either vertex; as on the boundary (seam_snap).
constexpr double kVertexSnap = 1e-3;
// Of a triangle's area: what must be left of it.
constexpr double kAreaLeft = 0.5;

/// An interior vertex of the base and one of the part beside it.
struct Near {
  double distance;
  Index base;
  Index part;
};

/// Of each vertex of a layer, a halfedge that leaves it.
std::vector<Index> leavingHalfedges(const Layer& layer) {
  std::vector<Index> leaving(static_cast<std::size_t>(layer.vertexCount()), -1);
  for (Index h = 0; h < layer.halfedgeCount(); ++h) {
    leaving[static_cast<std::size_t>(layer.from(h))] = h;
  }
  return leaving;
}

/// For each halfedge that leaves the interior vertex from which `first` leaves, until `visit` returns false.
template <class Visit>
bool allRound(const Layer& layer, Index first, Visit visit) {
  Index h = first;
  do {
    if (!visit(h)) {
      return false;
    }
    h = layer.twin(Layer::prev(h));
  } while (h != first);
  return true;
}

double shortestEdge(const Layer& layer, Index first) {
  double shortest = std::numeric_limits<double>::infinity();
  allRound(layer, first, [&](Index h) {
    shortest = std::min(shortest, (layer.at(layer.to(h)) - layer.at(layer.from(h))).norm());
    return true;
  });
  return shortest;
}

/// The pairs that one look at the face round each base vertex finds, the nearest first.
std::vector<Near> findNear(const Layers& layers, const Trace& trace) {
  std::vector<Near> found;
  for (Index v = layers.base.seamSize(); v < layers.base.vertexCount(); ++v) {
    const Index face = trace.baseInPart[static_cast<std::size_t>(v)];
    const Face& corners = layers.part.faces[static_cast<std::size_t>(face)];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index w = corners[k];
      const Point2& p = layers.part.at(w);
      const double squared = (layers.base.at(v) - p).squaredNorm();
      const double edge = std::min((layers.part.at(corners[(k + 1) % 3]) - p).squaredNorm(),
                                   (layers.part.at(corners[(k + 2) % 3]) - p).squaredNorm());
      if (w >= layers.part.seamSize() && squared <= kVertexSnap * kVertexSnap * edge) {
        found.push_back({std::sqrt(squared), v, w});
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const Near& a, const Near& b) {
    return std::tie(a.distance, a.base, a.part) < std::tie(b.distance, b.base, b.part);
  });
  return found;
}

/// Moves the vertex from which `first` leaves, if its triangles bear that.
bool move(Layer& layer, Index first, const Point2& target) {
  Point2& position = layer.uv[static_cast<std::size_t>(layer.from(first))];
  const Point2 old = position;
  const bool valid = allRound(layer, first, [&](Index h) {
    const Point2& b = layer.at(layer.to(h));
    const Point2& c = layer.at(layer.from(Layer::prev(h)));
    return orient2d(target, b, c) > 0 && doubleArea(target, b, c) >= kAreaLeft * doubleArea(old, b, c);
  });
  if (valid) {
    position = target;
  }
  return valid;
}

// Whether it moved any, so that `trace` does not hold any longer.
bool snapVertices(Layers& layers, const Trace& trace) {
  const std::vector<Near> found = findNear(layers, trace);
  if (found.empty() || found.back().distance == 0) {
    return false;
  }
  const std::vector<Index> leavingPart = leavingHalfedges(layers.part);
  const std::vector<Index> leavingBase = leavingHalfedges(layers.base);
  std::vector<bool> takenPart(leavingPart.size(), false);
  std::vector<bool> takenBase(leavingBase.size(), false);
  bool moved = false;
  for (const auto& [distance, v, w] : found) {
    const auto base = static_cast<std::size_t>(v);
    const auto part = static_cast<std::size_t>(w);
    if (takenBase[base] || takenPart[part]) {
      continue;
    }
    const double reach = kVertexSnap * std::min(shortestEdge(layers.base, leavingBase[base]),
                                                shortestEdge(layers.part, leavingPart[part]));
    const bool moves =
        distance > 0 && distance <= reach && move(layers.part, leavingPart[part], layers.base.at(v));
    moved = moved || moves;
    takenBase[base] = takenPart[part] = moves || distance == 0;
  }
  return moved;
}

}  // namespace

Result<Trace> snapAndTrace(Layers& layers, const Progress& progress) {
  Result<Trace> trace = traceBase(layers, progress.span(0, 0.6));
  if (trace && snapVertices(layers, *trace)) {
    trace = Trace();
    trace = traceBase(layers, progress.span(0.6, 1));
  }
  return trace;
}

}  // namespace graftsman::overlay_detail
