#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/fusion/seam_fans.h"
#include "core/fusion/seam_merge.h"

namespace graftsman::overlay_detail {

/// An interior edge of the base crosses one of the part. One record, as a walk round a cell needs all of it.
struct Crossing {
  Index part;           // the part's halfedge that is crossed from its left to its right …
  Index base;           // … by this halfedge of the base
  Index partNext = -1;  // the next crossing along `part`, or −1
  Index partPrev = -1;  // the one before
  /// From traceBase(): −1, or the vertex exactly at which the edges meet without the shift, where vertex v of
  /// the base's layer is v and interior vertex w of the part's is w − seam size + vertices of the base's
  /// layer. From numberVertices() on: the combined vertex.
  Index vertex = -1;
};

/// How the two layers lie over each other, if the base's interior vertices are shifted by (ε, ε²): then no
/// vertex lies on an edge or a vertex of the other layer, apart from the seam's, which coincide.
struct Trace {
  SeamFans fans;
  /// Those of one base edge are consecutive, in the order along the halfedge `base`.
  std::vector<Crossing> crossings;
  std::vector<Index> firstOnBase;  // of each base halfedge, the first crossing along it, or −1
  std::vector<Index> firstOnPart;  // of each part halfedge, likewise
  std::vector<Index> baseInPart;  // of each interior vertex of the base, the part's face; −1 for the seam's
  std::vector<Index> partInBase;  // of each interior vertex of the part, the base's face

  /// The crossing after c along the halfedge h of the part (of the base), which both lie on; −1 after the
  /// last.
  [[nodiscard]] Index afterOnPart(Index c, Index h) const {
    const Crossing& crossing = crossings[static_cast<std::size_t>(c)];
    return crossing.part == h ? crossing.partNext : crossing.partPrev;
  }
  [[nodiscard]] Index afterOnBase(Index c, Index h) const {
    const Index base = crossings[static_cast<std::size_t>(c)].base;
    const Index next = base == h ? c + 1 : c - 1;
    const bool exists = next >= 0 && next < static_cast<Index>(crossings.size());
    return exists && crossings[static_cast<std::size_t>(next)].base == base ? next : -1;
  }
};

/// The error for layers that do not fit each other as exact triangulations of one polygon do, and for more
/// crossings than an Index can number.
[[nodiscard]] Error tooFine();

/// Walks every interior edge of the base through the part. Errors: CombinedTileTooFine, Cancelled.
[[nodiscard]] Result<Trace> traceBase(const Layers& layers, const Progress& progress);

}  // namespace graftsman::overlay_detail
