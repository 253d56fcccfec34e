#include "core/fusion/low_stretch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fusion/embedding_weights.h"
#include "core/fusion/opening_potential.h"
#include "core/mesh/at.h"

namespace graftsman {
namespace {

/// One opening does for a protrusion, however long; further ones reach those that sit on it.
constexpr int kMostOpenings = 5;

/// Steps after Yoshizawa et al.: the first ones bring nearly all, and each has to earn its solution.
constexpr int kMostStretchSteps = 5;
constexpr double kEnough = 0.99;

/// Squared length in the unit circle that is nothing but rounding.
constexpr double kNoLength = 1e-32;

/// Mean square stretch of the map from the layout to the tile (Sander et al. 2001, L²), lowest 1 / n-gon's
/// area for an even layout of area 1; infinite if the layout is not valid.
double stretch(const EmbeddingTile& tile, const Layout& layout) {
  if (!layout.check.valid()) {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0;
  for (std::size_t f = 0; f < tile.faces.size(); ++f) {
    const auto [i, j, k] = tile.faces[f];
    const Point2 a = layout.uv[at(j)] - layout.uv[at(i)];
    const Point2 b = layout.uv[at(k)] - layout.uv[at(i)];
    const double det = std::max(a.x() * b.y() - a.y() * b.x(), kNoLength);
    const Point along = tile.points[at(j)] - tile.points[at(i)];
    const Point across = tile.points[at(k)] - tile.points[at(i)];
    const Point du = (b.y() * along - a.y() * across) / det;
    const Point dv = (a.x() * across - b.x() * along) / det;
    sum += tile.areas[f] * (du.squaredNorm() + dv.squaredNorm()) / 2;
  }
  return sum;
}

/// Log of each vertex's stretch: root mean square length of the edges round it on the tile over that in the
/// layout. Defined for any layout, even a collapsed one.
std::vector<double> logStretches(const EmbeddingTile& tile, const std::vector<Point2>& uv) {
  std::vector<double> onTile(tile.points.size(), kNoLength);
  std::vector<double> inLayout(tile.points.size(), kNoLength);
  for (const Face& face : tile.faces) {
    double lengths = 0;
    double layoutLengths = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = at(face[k]);
      const auto j = at(face[(k + 1) % 3]);
      lengths += (tile.points[i] - tile.points[j]).squaredNorm();
      layoutLengths += (uv[i] - uv[j]).squaredNorm();
    }
    for (const Index v : face) {
      onTile[at(v)] += lengths;
      inLayout[at(v)] += layoutLengths;
    }
  }
  std::vector<double> out(onTile.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    out[v] = std::log(onTile[v] / inLayout[v]) / 2;
  }
  return out;
}

/// The weights for the conductivity exp(−potential), with its exact mean along each edge (Scharfetter &
/// Gummel 1969): a plain mean would let a steep potential cut the inner vertices off from each other.
SlotWeights weightsInPotential(const LayoutProblem& problem, const SlotWeights& base,
                               const std::vector<double>& potential) {
  constexpr double kSteepest = 100;  // exp(−100) is as good as 0, and far from underflow
  SlotWeights weights = base;
  for (std::size_t r = 0; r + 1 < problem.stars.offsets.size(); ++r) {
    const double own = potential[r + problem.boundary.size()];
    for (auto slot = at(problem.stars.offsets[r]); slot < at(problem.stars.offsets[r + 1]); ++slot) {
      const double rise = potential[at(problem.stars.ring[slot])] - own;
      const double x = std::clamp(rise, -kSteepest, kSteepest);
      weights[slot] *= x == 0 ? 1 : x / std::expm1(x);
    }
  }
  return weights;
}

}  // namespace

std::optional<Layout> lowStretchLayout(const LayoutProblem& problem, const SlotWeights& base, Layout start,
                                       const Progress& progress) {
  std::vector<double> potential(problem.tile.points.size(), 0);
  Layout layout = std::move(start);
  const auto solve = [&](const Progress& part) {
    return layOut(problem, weightsInPotential(problem, base, potential), MatrixKind::Drifting, layout.uv,
                  Effort::Full, part);
  };
  for (int i = 0; i < kMostOpenings && (layout.check.squeezes() || !layout.check.valid()); ++i) {
    const Progress part = progress.span(0.1 * i, 0.1 * (i + 1));
    const std::vector<double> opening = openingPotential(problem, layout.uv, part.span(0, 0.5));
    if (opening.empty()) {
      return {};
    }
    std::transform(opening.begin(), opening.end(), potential.begin(), potential.begin(), std::plus<>());
    std::optional<Layout> opened = solve(part.span(0.5, 1));
    if (!opened) {
      return {};
    }
    layout = std::move(*opened);
  }
  double least = stretch(problem.tile, layout);
  for (int i = 0; i < kMostStretchSteps; ++i) {
    const std::vector<double> stretches = logStretches(problem.tile, layout.uv);
    for (std::size_t v = 0; v < potential.size(); ++v) {
      potential[v] += 2 * stretches[v];  // weights w / σ of both ends: a conductivity σ⁻²
    }
    std::optional<Layout> next = solve(progress.span(0.5 + 0.1 * i, 0.6 + 0.1 * i));
    if (!next) {
      return {};
    }
    const double reached = stretch(problem.tile, *next);
    if (!(reached < kEnough * least)) {
      break;
    }
    least = reached;
    layout = std::move(*next);
  }
  return layout;
}

}  // namespace graftsman
