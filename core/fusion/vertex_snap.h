#pragma once

#include "core/fusion/overlay_trace.h"

namespace graftsman::overlay_detail {

/// traceBase() after interior vertices of the part that come very near to one of the base were put exactly
/// there, each only where the part's triangles round it stay counter-clockwise and keep half of their area.
/// An embedding is one of many valid ones, and a thousandth of an edge is nothing to anyone; but the slivers
/// between near vertices show, and two tiles that differ by rounding would have nothing else.
[[nodiscard]] Result<Trace> snapAndTrace(Layers& layers, const Progress& progress);

}  // namespace graftsman::overlay_detail
