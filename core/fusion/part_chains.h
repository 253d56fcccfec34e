#pragma once

#include "core/fusion/overlay_trace.h"

namespace graftsman::overlay_detail {

/// Fills firstOnPart and links the crossings of each part edge in their order. No position is
/// compared: the part edge is in one base face before a crossing and in another after it, and in no base face
/// twice. False: they make no chain (the layers are not triangulations of one simple polygon).
[[nodiscard]] bool chainAlongPart(const Layers& layers, Trace& trace);

/// Fills partInBase, from the base faces that the part's edges run through.
void locatePartVertices(const Layers& layers, Trace& trace);

}  // namespace graftsman::overlay_detail
