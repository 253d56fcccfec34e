#pragma once

#include <optional>

#include "core/fusion/embedding_layout.h"

namespace graftsman {

/// A layout that spreads what `start` squeezes. First, protrusions squeezed exponentially are opened by
/// openingPotential(), then weights are divided by the local stretch as long as that lessens the total
/// (Yoshizawa, Belyaev & Seidel 2004, several steps). All weights stay positive, so that the layout cannot
/// flip but by rounding. No value: cancelled.
/// Differs: Yoshizawa et al. know no opening. Their step lessens the exponent of the squeeze on a tube from 1
/// to 0.41, 0.32, 0.27, … and needs hundreds for a long one, beyond the range of doubles at first.
/// base: positive weights, of mean value or uniform.
[[nodiscard]] std::optional<Layout> lowStretchLayout(const LayoutProblem& problem, const SlotWeights& base,
                                                     Layout start, const Progress& progress);

}  // namespace graftsman
