#pragma once

#include <vector>

#include "core/fusion/embedding_layout.h"

namespace graftsman {

/// Squared girth radius: for each interior vertex of a squeezed region 1/R², where 2πR is the length of the
/// closed curve round its protrusion at its depth (in rings of vertices from where the region begins);
/// 0 elsewhere. Protrusions that part further out have curves of their own. uv: V'×2, the layout that
/// squeezes. N values.
[[nodiscard]] std::vector<double> inverseSquareGirths(const LayoutProblem& problem,
                                                      const std::vector<Point2>& uv);

/// φ per vertex (V'; 0 on the boundary): with the conductivity exp(−φ) in place of 1, a harmonic map spreads
/// each squeezed protrusion evenly, in proportion to length, instead of exponentially. Empty if cancelled.
///
/// On a tube of radius R and length H, a harmonic map shrinks rings like exp(−h/R). A map that shrinks them
/// like 1 − h/H is harmonic for conductivities exp(−φ) with φ' = (H − h)/R², that is Δφ = −1/R². So φ solves
/// that Poisson equation, with R of inverseSquareGirths(). A wrong R is forgiven: with φ off by a factor a
/// the rings shrink like (1 − h/H)^(1/a).
[[nodiscard]] std::vector<double> openingPotential(const LayoutProblem& problem,
                                                   const std::vector<Point2>& uv, const Progress& progress);

}  // namespace graftsman
