#include "core/fusion/seam_fans.h"

#include "core/fusion/symbolic_shift.h"

namespace graftsman::overlay_detail {
namespace {

// The halfedges of interior edges that leave seam vertex s, counter-clockwise.
void gatherSpokes(const Layer& layer, Index s, std::vector<Index>& spokes) {
  spokes.clear();
  Index h = layer.twin(Layer::prev(layer.boundaryHalfedges[static_cast<std::size_t>(s)]));
  while (h >= 0) {
    spokes.push_back(h);
    h = layer.twin(Layer::prev(h));
  }
}

}  // namespace

SeamFans mergeFans(const Layers& layers) {
  const Index seamSize = layers.part.seamSize();
  SeamFans fans;
  fans.start.reserve(static_cast<std::size_t>(seamSize) + 1);
  fans.start.push_back(0);
  fans.partSpoke.assign(static_cast<std::size_t>(layers.part.halfedgeCount()), -1);
  fans.baseSpoke.assign(static_cast<std::size_t>(layers.base.halfedgeCount()), -1);
  std::vector<Index> ofPart;
  std::vector<Index> ofBase;
  for (Index s = 0; s < seamSize; ++s) {
    gatherSpokes(layers.part, s, ofPart);
    gatherSpokes(layers.base, s, ofBase);
    std::size_t p = 0;
    std::size_t b = 0;
    Index lastPart = layers.part.boundaryHalfedges[static_cast<std::size_t>(s)];
    Index lastBase = layers.base.boundaryHalfedges[static_cast<std::size_t>(s)];
    while (p < ofPart.size() || b < ofBase.size()) {
      // Each of the two is less than a half turn from the spoke taken last, by the angles of triangles, so
      // that the side of one tells the order. This holds even where rounding makes the boundary reflex.
      const bool takesPart =
          b == ofBase.size() ||
          (p < ofPart.size() &&
           sideOfBaseEdge(layers, s, layers.base.to(ofBase[b]), layers.part.to(ofPart[p])).shifted < 0);
      const Index h = takesPart ? ofPart[p++] : ofBase[b++];
      auto& slots = takesPart ? fans.partSpoke : fans.baseSpoke;
      slots[static_cast<std::size_t>(h)] = static_cast<Index>(fans.spokes.size());
      fans.spokes.push_back({h, takesPart ? lastBase : lastPart, takesPart});
      (takesPart ? lastPart : lastBase) = h;
    }
    fans.start.push_back(static_cast<Index>(fans.spokes.size()));
  }
  return fans;
}

}  // namespace graftsman::overlay_detail
