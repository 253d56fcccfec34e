#pragma once

#include <span>

#include "core/fusion/update.h"
#include "core/picture/picture_camera.h"

namespace graftsman {

/// What a picture of a fusion shows: all of the result, or the tile with its surroundings.
enum class FusionView { Whole, Tile };

/// Whether y is up, rather than z: a guess, as is usual in OBJ files (`isObj`) unless the loop lies on top of
/// such a mesh, since the front is a loop's usual place. loop: N×3, the CVs' positions on the mesh; N may be
/// 0.
[[nodiscard]] bool guessYUp(std::span<const Point> loop, bool isObj);
/// The same of a fusion's base.
[[nodiscard]] bool guessYUp(const FusionInputs& inputs, bool isObj);

/// Where to look at a mesh from: at the loop, from a little beside and above; without a loop (of three points
/// at least) from the front.
[[nodiscard]] ViewDirection firstDirection(std::span<const Point> loop, bool yUp);
/// The same of a fusion's base, without the points that it lacks.
[[nodiscard]] ViewDirection firstDirection(const FusionInputs& inputs, bool yUp);

/// The camera that has a fusion in view at every setting of its curve: the base and the combined tile in both
/// its shapes; of a fusion without a combined tile, the base with the loop. `aspect`: width / height.
[[nodiscard]] PictureCamera cameraFor(const FusionResults& results, FusionView view,
                                      const ViewDirection& direction, double aspect);

/// The result's positions at a curve that has one value everywhere: the base's shape at weight 0, the part's
/// at weight 1. Precondition: `results.fused`.
[[nodiscard]] std::vector<Point> morphed(const FusionResults& results, double weight);

/// The points that cameraFor() frames: of the whole, the result in both its shapes (or the base with the
/// loop); of a tile, it with its surroundings.
[[nodiscard]] std::vector<Point> shownPoints(const FusionResults& results, FusionView view);

}  // namespace graftsman
