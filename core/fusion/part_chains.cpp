#include "core/fusion/part_chains.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

namespace graftsman::overlay_detail {
namespace {

constexpr std::size_t kFewCrossings = 12;  // on one edge: comparing them beats stamping the faces

/// Orders the crossings of one part edge along one of its halfedges.
class ChainSorter {
 public:
  ChainSorter(const Layers& layers, const std::vector<Crossing>& crossings)
      : base_(layers.base), crossings_(crossings) {}

  // Reorders `chain`, crossings of the part's halfedge h, along h.
  bool sort(std::span<Index> chain, Index h) {
    if (chain.size() < 2) {
      return true;
    }
    if (chain.size() == 2) {
      if (after(chain[1], h) == before(chain[0], h)) {
        std::swap(chain[0], chain[1]);
      }
      return after(chain[0], h) == before(chain[1], h);
    }
    return chain.size() <= kFewCrossings ? sortByComparing(chain, h) : sortByStamps(chain, h);
  }

  // The base face in which the part edge is just before (after) crossing c when one goes along h.
  [[nodiscard]] Index before(Index c, Index h) const { return beside(c, h, false); }
  [[nodiscard]] Index after(Index c, Index h) const { return beside(c, h, true); }

 private:
  // The base halfedge crosses `part` from left to right, hence `part` crosses it from right to left.
  [[nodiscard]] Index beside(Index c, Index h, bool afterwards) const {
    const Crossing& crossing = crossings_[static_cast<std::size_t>(c)];
    const bool onLeft = (crossing.part == h) == afterwards;
    return (onLeft ? crossing.base : base_.twin(crossing.base)) / 3;
  }

  bool sortByComparing(std::span<Index> chain, Index h) const {
    const auto first = std::find_if(chain.begin(), chain.end(), [&](Index c) {
      return std::none_of(chain.begin(), chain.end(), [&](Index d) { return after(d, h) == before(c, h); });
    });
    if (first == chain.end()) {
      return false;
    }
    std::swap(chain[0], *first);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const Index face = after(chain[i - 1], h);
      const auto next = std::find_if(chain.begin() + static_cast<std::ptrdiff_t>(i), chain.end(),
                                     [&](Index c) { return before(c, h) == face; });
      if (next == chain.end()) {
        return false;
      }
      std::swap(chain[i], *next);
    }
    return true;
  }

  bool sortByStamps(std::span<Index> chain, Index h) {
    startingIn_.resize(static_cast<std::size_t>(base_.faceCount()), -1);
    endsIn_.resize(static_cast<std::size_t>(base_.faceCount()), false);
    for (const Index c : chain) {
      startingIn_[static_cast<std::size_t>(before(c, h))] = c;
      endsIn_[static_cast<std::size_t>(after(c, h))] = true;
    }
    ordered_.clear();
    for (const Index c : chain) {
      if (!endsIn_[static_cast<std::size_t>(before(c, h))]) {
        for (Index d = c; d >= 0 && ordered_.size() < chain.size();
             d = startingIn_[static_cast<std::size_t>(after(d, h))]) {
          ordered_.push_back(d);
        }
        break;
      }
    }
    for (const Index c : chain) {
      startingIn_[static_cast<std::size_t>(before(c, h))] = -1;
      endsIn_[static_cast<std::size_t>(after(c, h))] = false;
    }
    if (ordered_.size() != chain.size()) {
      return false;
    }
    std::copy(ordered_.begin(), ordered_.end(), chain.begin());
    return true;
  }

  const Layer& base_;
  const std::vector<Crossing>& crossings_;
  std::vector<Index> startingIn_;  // of each base face, the crossing before which the part edge is in it
  std::vector<bool> endsIn_;
  std::vector<Index> ordered_;
};

// `chain`: crossings of the part's halfedge h in order along it.
void link(std::vector<Crossing>& crossings, std::span<const Index> chain, Index h) {
  for (std::size_t i = 1; i < chain.size(); ++i) {
    Crossing& before = crossings[static_cast<std::size_t>(chain[i - 1])];
    Crossing& after = crossings[static_cast<std::size_t>(chain[i])];
    (before.part == h ? before.partNext : before.partPrev) = chain[i];
    (after.part == h ? after.partPrev : after.partNext) = chain[i - 1];
  }
}

}  // namespace

bool chainAlongPart(const Layers& layers, Trace& trace) {
  const Layer& part = layers.part;
  const auto halfedges = static_cast<std::size_t>(part.halfedgeCount());
  const auto edge = [&](const Crossing& crossing) {
    return static_cast<std::size_t>(std::min(crossing.part, part.twin(crossing.part)));
  };
  std::vector<Index> start(halfedges + 2, 0);
  for (const Crossing& crossing : trace.crossings) {
    ++start[edge(crossing) + 2];
  }
  for (std::size_t i = 2; i < start.size(); ++i) {
    start[i] += start[i - 1];
  }
  std::vector<Index> grouped(trace.crossings.size());
  for (std::size_t c = 0; c < trace.crossings.size(); ++c) {
    grouped[static_cast<std::size_t>(start[edge(trace.crossings[c]) + 1]++)] = static_cast<Index>(c);
  }
  ChainSorter sorter(layers, trace.crossings);
  trace.firstOnPart.assign(halfedges, -1);
  for (std::size_t i = 0; i < halfedges; ++i) {
    const auto h = static_cast<Index>(i);
    const auto chain = std::span(grouped).subspan(static_cast<std::size_t>(start[i]),
                                                  static_cast<std::size_t>(start[i + 1] - start[i]));
    if (chain.empty()) {
      continue;
    }
    if (!sorter.sort(chain, h)) {
      return false;
    }
    link(trace.crossings, chain, h);
    trace.firstOnPart[i] = chain.front();
    trace.firstOnPart[static_cast<std::size_t>(part.twin(h))] = chain.back();
  }
  return true;
}

void locatePartVertices(const Layers& layers, Trace& trace) {
  const Layer& part = layers.part;
  const Index seam = part.seamSize();
  const ChainSorter chains(layers, trace.crossings);
  std::vector<Index>& located = trace.partInBase;
  located.assign(static_cast<std::size_t>(part.vertexCount()), -1);
  std::vector<Index> leaving;  // halfedges that leave located vertices which may have others hanging on them
  const auto locate = [&](Index h, Index face) {
    if (part.from(h) >= seam && located[static_cast<std::size_t>(part.from(h))] < 0) {
      located[static_cast<std::size_t>(part.from(h))] = face;
      leaving.push_back(h);
    }
  };
  for (Index h = 0; h < part.halfedgeCount(); ++h) {
    const Index first = trace.firstOnPart[static_cast<std::size_t>(h)];
    if (first >= 0 && located[static_cast<std::size_t>(part.from(h))] < 0) {
      locate(h, chains.before(first, h));
    }
  }
  for (const SeamFans::Spoke& spoke : trace.fans.spokes) {
    if (spoke.ofPart && trace.firstOnPart[static_cast<std::size_t>(spoke.halfedge)] < 0) {
      locate(part.twin(spoke.halfedge), spoke.beside / 3);
    }
  }
  // Whoever is left hangs on these by edges without a crossing, hence lies in the same face.
  while (!leaving.empty()) {
    const Index start = leaving.back();
    leaving.pop_back();
    Index h = start;
    do {
      const Index back = part.twin(h);
      if (trace.firstOnPart[static_cast<std::size_t>(h)] < 0) {
        locate(back, located[static_cast<std::size_t>(part.from(h))]);
      }
      h = part.twin(Layer::prev(h));
    } while (h != start);
  }
}

}  // namespace graftsman::overlay_detail
