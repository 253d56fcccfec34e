#include "core/fusion/overlay_trace.h"

#include <algorithm>
#include <cassert>

#include "core/fusion/part_chains.h"
#include "core/fusion/symbolic_shift.h"

namespace graftsman::overlay_detail {
namespace {

constexpr Index kUntraced = -2;
// Keeps the numbers of the combined faces' halfedges, at most 18 a crossing, within an Index.
constexpr std::size_t kMostCrossings = 100'000'000;
constexpr std::size_t kVerticesPerLook = 512;  // vertices between two looks at the clock

class Tracer {
 public:
  Tracer(const Layers& layers, Trace& trace)
      : layers_(layers),
        part_(layers.part),
        base_(layers.base),
        seam_(layers.base.seamSize()),
        trace_(trace) {
    trace_.firstOnBase.assign(static_cast<std::size_t>(base_.halfedgeCount()), kUntraced);
    trace_.baseInPart.assign(static_cast<std::size_t>(base_.vertexCount()), -1);
    trace_.crossings.reserve(static_cast<std::size_t>(base_.vertexCount() + part_.vertexCount()) * 2);
    queue_.reserve(static_cast<std::size_t>(base_.vertexCount() - seam_));
  }

  // False: the walk left the polygon, or ran out of numbers.
  bool traceFromSeam() {
    for (const SeamFans::Spoke& spoke : trace_.fans.spokes) {
      if (!spoke.ofPart && !traceSpoke(spoke.halfedge, spoke.beside)) {
        return false;
      }
    }
    return true;
  }

  Result<void> traceInterior(const Progress& progress) {
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      if (i % kVerticesPerLook == 0 &&
          !progress.keepGoing(static_cast<double>(i) / static_cast<double>(base_.vertexCount()))) {
        return fail(ErrorCode::Cancelled, "Cancelled.");
      }
      Index h = queue_[i];
      do {
        if (trace_.firstOnBase[static_cast<std::size_t>(h)] == kUntraced && !traceFromInside(h)) {
          return fail(tooFine());
        }
        h = base_.twin(Layer::prev(h));
      } while (h != queue_[i]);
    }
    return {};
  }

 private:
  bool traceSpoke(Index g, Index beside) {
    begin(g);
    const Index exit = Layer::next(beside);
    const Index face = exit / 3;
    if (to_ < seam_) {
      return false;  // an interior edge between two boundary vertices breaks the embedding's promise
    }
    const Sign side = sideOfPartEdge(layers_, exit, to_);
    if (side.shifted > 0) {
      finish(face);
      return true;
    }
    rightOnLine_ = sideOfBaseEdge(layers_, from_, to_, part_.from(exit)).exact0;
    leftOnLine_ = sideOfBaseEdge(layers_, from_, to_, part_.to(exit)).exact0;
    return cross(exit, side.exact0 ? to_ : -1);
  }

  bool traceFromInside(Index g) {
    begin(g);
    const Index face = trace_.baseInPart[static_cast<std::size_t>(from_)];
    std::array<Sign, 3> sides = {};
    for (Index k = 0; k < 3; ++k) {
      const Index w = part_.from(3 * face + k);
      if (w == to_) {
        if (w < seam_) {
          finish(face);
          return true;
        }
      }
      sides[static_cast<std::size_t>(k)] = sideOfBaseEdge(layers_, from_, to_, w);
    }
    std::size_t k = 0;
    while (k < 3 && !(sides[k].shifted < 0 && sides[(k + 1) % 3].shifted > 0)) {
      ++k;
    }
    if (k == 3) {
      return false;
    }
    const Index exit = 3 * face + static_cast<Index>(k);
    Index at = -1;
    if (to_ >= seam_) {
      const Sign side = sideOfPartEdge(layers_, exit, to_);
      if (side.shifted > 0) {
        finish(face);
        return true;
      }
      at = side.exact0 ? to_ : -1;
    }
    if (at < 0 && orientation(part_.at(part_.from(exit)), part_.at(part_.to(exit)), base_.at(from_)) == 0) {
      at = from_;
    }
    rightOnLine_ = sides[k].exact0;
    leftOnLine_ = sides[(k + 1) % 3].exact0;
    return cross(exit, at);
  }

  void begin(Index g) {
    halfedge_ = g;
    from_ = base_.from(g);
    to_ = base_.to(g);
    firstCrossing_ = trace_.crossings.size();
  }

  // Crosses `exit`, and what comes behind it, as far as to_. `at`: the base vertex exactly on `exit`, or −1.
  bool cross(Index exit, Index at) {
    for (;;) {
      const Index enter = part_.twin(exit);
      if (enter < 0 || trace_.crossings.size() >= kMostCrossings) {
        return false;
      }
      const Index partVertex = rightOnLine_ ? part_.from(exit) : (leftOnLine_ ? part_.to(exit) : -1);
      trace_.crossings.push_back(
          {exit, halfedge_, -1, -1, partVertex >= 0 ? partVertex - seam_ + base_.vertexCount() : at});
      const Index face = enter / 3;
      const Index apex = part_.from(Layer::prev(enter));
      if (apex == to_ && to_ < seam_) {
        finish(face);
        return true;
      }
      const Sign side = sideOfBaseEdge(layers_, from_, to_, apex);
      if (side.shifted == 0) {
        return false;
      }
      const bool apexIsLeft = side.shifted > 0;
      (apexIsLeft ? leftOnLine_ : rightOnLine_) = side.exact0;
      exit = apexIsLeft ? Layer::next(enter) : Layer::prev(enter);
      at = -1;
      if (to_ >= seam_) {
        const Sign beyond = sideOfPartEdge(layers_, exit, to_);
        if (beyond.shifted > 0) {
          finish(face);
          return true;
        }
        at = beyond.exact0 ? to_ : -1;
      }
    }
  }

  // The traced edge ends in `face` of the part.
  void finish(Index face) {
    const bool crossed = trace_.crossings.size() > firstCrossing_;
    const Index twin = base_.twin(halfedge_);
    trace_.firstOnBase[static_cast<std::size_t>(halfedge_)] =
        crossed ? static_cast<Index>(firstCrossing_) : -1;
    trace_.firstOnBase[static_cast<std::size_t>(twin)] =
        crossed ? static_cast<Index>(trace_.crossings.size()) - 1 : -1;
    if (to_ >= seam_) {
      Index& known = trace_.baseInPart[static_cast<std::size_t>(to_)];
      assert(known < 0 || known == face);
      if (known < 0) {
        known = face;
        queue_.push_back(twin);
      }
    }
  }

  const Layers& layers_;
  const Layer& part_;
  const Layer& base_;
  const Index seam_;
  Trace& trace_;
  std::vector<Index> queue_;  // halfedges that leave located vertices
  Index halfedge_ = -1;       // of the base: the one being traced, from from_ to to_
  Index from_ = -1;
  Index to_ = -1;
  std::size_t firstCrossing_ = 0;
  bool rightOnLine_ = false;  // whether the exit's start, or end, lies exactly on the base edge's line
  bool leftOnLine_ = false;
};

// Puts the crossings into the order of the base's halfedges. The walk left them in rings from the seam
// inwards; the base's own order keeps near together what the steps after this one use together.
void orderByBase(const Layer& base, Trace& trace) {
  std::vector<Crossing> ordered;
  ordered.reserve(trace.crossings.size());
  for (Index h = 0; h < base.halfedgeCount(); ++h) {
    const Index twin = base.twin(h);
    const Index first = trace.firstOnBase[static_cast<std::size_t>(h)];
    if (h > twin || first < 0) {
      continue;
    }
    const auto begin = static_cast<Index>(ordered.size());
    const bool traced = trace.crossings[static_cast<std::size_t>(first)].base == h;
    const Index last = trace.firstOnBase[static_cast<std::size_t>(twin)];
    for (Index c = std::min(first, last); c <= std::max(first, last); ++c) {
      ordered.push_back(trace.crossings[static_cast<std::size_t>(c)]);
    }
    const auto end = static_cast<Index>(ordered.size()) - 1;
    trace.firstOnBase[static_cast<std::size_t>(h)] = traced ? begin : end;
    trace.firstOnBase[static_cast<std::size_t>(twin)] = traced ? end : begin;
  }
  trace.crossings = std::move(ordered);
}

}  // namespace

Error tooFine() {
  return {ErrorCode::CombinedTileTooFine,
          "The tiles cannot be combined: their triangles are too fine, or cross each other too often, to be "
          "divided in double precision. Choose smaller tiles, or add pairs between the present ones."};
}

Result<Trace> traceBase(const Layers& layers, const Progress& progress) {
  Trace trace;
  trace.fans = mergeFans(layers);
  Tracer tracer(layers, trace);
  if (!tracer.traceFromSeam()) {
    return fail(tooFine());
  }
  if (auto traced = tracer.traceInterior(progress.span(0, 0.8)); !traced) {
    return fail(traced.error());
  }
  orderByBase(layers.base, trace);
  if (!progress.keepGoing(0.8)) {
    return fail(ErrorCode::Cancelled, "Cancelled.");
  }
  if (!chainAlongPart(layers, trace)) {
    return fail(tooFine());
  }
  locatePartVertices(layers, trace);
  return trace;
}

}  // namespace graftsman::overlay_detail
