#pragma once

#include <QString>
#include <tl/expected.hpp>

#include "core/fusion/fcf.h"

namespace graftsman {

/// What stays between two neighbouring points' s: enough to see and to grab them apart.
inline constexpr double kPointGap = 0.005;

/// The values of s that a point may take between its neighbours; from = to where it cannot move.
struct AllowedS {
  double from = 0;
  double to = 1;
};

/// 0 ≤ point < number of points.
[[nodiscard]] AllowedS allowedS(const FCF& curve, int point);

/// The curve with `point` as near to `wanted` as is allowed: end points keep their s, the others stay between
/// their neighbours, f in [0, 1].
[[nodiscard]] FCF withPointMoved(const FCF& curve, int point, const FCFPoint& wanted);

/// A curve with one more point, and which one that is.
struct AddedPoint {
  FCF curve;
  int point = 0;
};

/// The curve with a point more. Error: why there is no room for it, as a sentence.
[[nodiscard]] tl::expected<AddedPoint, QString> withPointAdded(const FCF& curve, const FCFPoint& at);

/// The curve without `point`. Error: why it must stay, as a sentence.
[[nodiscard]] tl::expected<FCF, QString> withPointRemoved(const FCF& curve, int point);

}  // namespace graftsman
