#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/parallel.h"
#include "core/fusion/combined_tile.h"
#include "core/fusion/overlay_cells.h"
#include "core/fusion/overlay_vertices.h"
#include "core/fusion/seam_merge.h"
#include "core/fusion/vertex_snap.h"

namespace graftsman {
namespace {

constexpr std::size_t kLocationGrain = 16384;  // vertices a thread takes at a time
constexpr Index kFewSides = 12;                // all of them are sooner looked at than an angle is computed

Point2 outward(Index sides, Index side) {
  const double angle = std::numbers::pi * (2 * side + 1) / sides;
  return {std::cos(angle), std::sin(angle)};
}

// The side in whose sector the point lies. On the ray between two sectors both sides are equally near.
Index sectorOf(Index sides, const Point2& uv) {
  const double turns = std::atan2(uv.y(), uv.x()) / (2 * std::numbers::pi);
  const auto sector = static_cast<Index>(std::floor(turns * sides));
  return ((sector % sides) + sides) % sides;
}

// s of a point that lies this far from the centre, at right angles to the nearest side.
double distanceFromSide(double apothem, double along) {
  return std::clamp((apothem - along) / apothem, 0.0, 1.0);
}

// seamDistance(), by the sides' outward directions.
template <class Outward>
double distanceFromSeam(Index sides, double apothem, const Outward& outwards, const Point2& uv) {
  if (sides > kFewSides) {
    return distanceFromSide(apothem, outwards(sectorOf(sides, uv)).dot(uv));
  }
  double along = 0;
  for (Index i = 0; i < sides; ++i) {
    along = std::max(along, outwards(i).dot(uv));
  }
  return distanceFromSide(apothem, along);
}

double apothemOf(Index sides) {
  return std::cos(std::numbers::pi / sides);
}

void fillSeamDistances(Index sides, CombinedTile& combined) {
  std::vector<Point2> outwards;
  outwards.reserve(static_cast<std::size_t>(sides));
  for (Index i = 0; i < sides; ++i) {
    outwards.push_back(outward(sides, i));
  }
  const auto outwardsOf = [&](Index i) -> const Point2& { return outwards[static_cast<std::size_t>(i)]; };
  const double apothem = apothemOf(sides);
  combined.s.assign(combined.uv.size(), 0);
  parallelRanges(combined.uv.size(), kLocationGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = std::max(begin, static_cast<std::size_t>(combined.seamSize)); v < end; ++v) {
      combined.s[v] = distanceFromSeam(sides, apothem, outwardsOf, combined.uv[v]);
    }
  });
}

}  // namespace

double seamDistance(Index sides, const Point2& uv) {
  return distanceFromSeam(
      sides, apothemOf(sides), [&](Index i) { return outward(sides, i); }, uv);
}

Result<CombinedTile> overlay(const EmbeddedTile& part, const EmbeddedTile& base, const Progress& progress) {
  using namespace overlay_detail;
  const auto cancelled = [] { return fail(ErrorCode::Cancelled, "Cancelled."); };
  if (!progress.keepGoing(0)) {
    return cancelled();
  }
  Result<Layers> layers = mergeSeams(part.embedding, base.embedding);
  if (!layers) {
    return fail(layers.error());
  }
  if (!progress.keepGoing(0.2)) {
    return cancelled();
  }
  Result<Trace> trace = snapAndTrace(*layers, progress.span(0.2, 0.5));
  if (!trace) {
    return fail(trace.error());
  }
  CombinedTile combined;
  VertexNumbers numbers = numberVertices(*layers, *trace);
  if (!progress.keepGoing(0.5)) {
    return cancelled();
  }
  placeVertices(part, base, *layers, *trace, numbers, combined);
  numbers.baseOnPart = {};  // of no more use, and the faces want memory
  numbers.partOnBase = {};
  if (auto filled = fillCells(*layers, *trace, numbers, combined, progress.span(0.7, 1)); !filled) {
    return fail(filled.error());
  }
  *trace = {};  // so does s
  fillSeamDistances(part.embedding.sides, combined);
  return combined;
}

}  // namespace graftsman
