#pragma once

#include "core/fusion/update.h"
#include "core/picture/picture_camera.h"

namespace graftsman {

/// What a picture of a fusion shows: all of the result, or the tile with its surroundings.
enum class FusionView { Whole, Tile };

/// Where to look at a fusion's base from: at the loop, from a little beside and above; without a loop (of
/// three points that the base has) from the front. `yUp`: y is up, as is usual in OBJ files, otherwise z;
/// where the loop says otherwise (it lies on top of such a mesh) z.
[[nodiscard]] ViewDirection firstDirection(const FusionInputs& inputs, bool yUp);

/// The camera that has a fusion in view at every setting of its curve: the base and the combined tile in both
/// its shapes; of a fusion without a combined tile, the base with the loop. `aspect`: width / height.
[[nodiscard]] PictureCamera cameraFor(const FusionResults& results, FusionView view,
                                      const ViewDirection& direction, double aspect);

/// The result's positions at a curve that has one value everywhere: the base's shape at weight 0, the part's
/// at
/// 1. Precondition: `results.fused`.
[[nodiscard]] std::vector<Point> morphed(const FusionResults& results, double weight);

/// What cameraFor() frames when it shows the whole: R×3 positions of the result in both its shapes.
[[nodiscard]] std::vector<Point> bothShapes(const FusionResults& results);

}  // namespace graftsman
