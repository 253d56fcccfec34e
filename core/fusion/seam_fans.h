#pragma once

#include <vector>

#include "core/fusion/seam_merge.h"

namespace graftsman::overlay_detail {

/// The interior edges that leave the seam's vertices, both layers' in one counter-clockwise order. A base
/// edge that overlaps a part's comes as if its other end were shifted by (ε, ε²).
struct SeamFans {
  /// An edge of the fan.
  struct Spoke {
    Index halfedge;  // the one that leaves the seam vertex
    Index beside;    // the other layer's halfedge that leaves it, in whose face the spoke starts
    bool ofPart;
  };
  std::vector<Spoke> spokes;     // of seam vertex 0, then of 1, …
  std::vector<Index> start;      // S + 1
  std::vector<Index> partSpoke;  // of each part halfedge that is a spoke, its index in `spokes`; else −1
  std::vector<Index> baseSpoke;  // likewise
};

[[nodiscard]] SeamFans mergeFans(const Layers& layers);

}  // namespace graftsman::overlay_detail
