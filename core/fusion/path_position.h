#pragma once

#include <optional>

#include "core/fusion/loop.h"
#include "core/fusion/paths.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

/// The position of a surface point of `mesh`.
[[nodiscard]] Point positionOf(const TriangleMesh& mesh, const SurfacePoint& point);

/// How far along the path its point nearest to `point` lies, as a fraction of its length, in [0, 1].
[[nodiscard]] double fractionNearest(const Path& path, const TriangleMesh& mesh, const Point& point);

/// A surface point that is `fraction` of the length along the path, or near it: the nearest vertex of the
/// edges that the path meets there, where no CV is, otherwise the very point. `anchored` is the mesh that the
/// path runs on, made from one of `vertices` vertices; the point is one of the latter. nullopt: between the
/// path's ends there is nothing that the given mesh has, too (the path lies within one divided face).
[[nodiscard]] std::optional<SurfacePoint> pointAlong(const Path& path, const AnchoredLoop& anchored,
                                                     Index vertices, double fraction);

}  // namespace graftsman
