#pragma once

#include "core/fusion/overlay_trace.h"
#include "core/fusion/overlay_vertices.h"

namespace graftsman::overlay_detail {

/// Fills the faces of `combined`, whose vertices are in place: every cell in which a base face meets a part
/// face, in triangles. Cells that have an area only by the shift vanish, as their corners are one or two
/// vertices. Errors: CombinedTileTooFine, Cancelled.
[[nodiscard]] Result<void> fillCells(const Layers& layers, const Trace& trace, const VertexNumbers& numbers,
                                     CombinedTile& combined, const Progress& progress);

}  // namespace graftsman::overlay_detail
