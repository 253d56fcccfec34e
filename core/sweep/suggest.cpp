#include "core/sweep/suggest.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/sweep/sweep.h"
#include "core/sweep/tile_samples.h"

namespace graftsman {
namespace {

constexpr std::array kTriedPresets = {FCF::Preset::Linear, FCF::Preset::Paste, FCF::Preset::KeepBaseSlope,
                                      FCF::Preset::Half};
constexpr std::array kFalloffs = {2.0, 5.0, 10.0};
constexpr double kSameFalloff = 1.5;  // a factor that does not show
constexpr double kSameCurve = 0.05;   // greatest difference of f that does not show
constexpr int kCurveSamples = 64;
constexpr double kLeastUnit = 0.1;     // of what differences are measured in, in diameters of the base's loop
constexpr double kLowered = 0.6;       // of a curve's height
constexpr double kEquallyGood = 0.01;  // of the whole range of a measure
constexpr std::size_t kTileSamples = 256;
constexpr std::size_t kOtherValues = 2;  // of falloffs and of shifts, besides the present one
constexpr double kFusionShare = 0.7;     // of a setting's progress; the rest is measuring

// How much farther than the best shift another may leave the CVs, as a factor and in diameters of the base's
// loop; and what counts as equally near.
constexpr double kWorseFit = 1.5;
constexpr double kWorseFitDiameters = 0.02;
constexpr double kEqualFitDiameters = 0.01;

// How far apart those that are chosen are at best, down to what still shows.
constexpr std::array kApart = {0.6, 0.45, 0.35, 0.25, 0.2, 0.15, 0.1, kLookAlike};

// A curve with what it is called by.
struct TriedCurve {
  FCF curve;
  std::optional<FCF::Preset> preset = {};
  double height = 1;
};

double greatestDifference(const FCF& a, const FCF& b) {
  double greatest = 0;
  for (int i = 0; i <= kCurveSamples; ++i) {
    const double s = static_cast<double>(i) / kCurveSamples;
    greatest = std::max(greatest, std::abs(a(s) - b(s)));
  }
  return greatest;
}

FCF loweredCurve(const FCF& curve) {
  std::vector<FCFPoint> points = curve.points();
  for (FCFPoint& point : points) {
    point.f *= kLowered;
  }
  return FCF::through(std::move(points), curve.monotone()).value();
}

// The present one first.
std::vector<TriedCurve> curvesToTry(const FCF& present) {
  std::vector<TriedCurve> curves = {{present}};
  for (const FCF::Preset preset : kTriedPresets) {
    const FCF curve = FCF::preset(preset);
    if (curve.points() == present.points()) {
      curves.front().preset = preset;
    } else {
      curves.push_back({curve, preset});
    }
  }
  const auto add = [&curves](TriedCurve tried) {
    const bool another = std::all_of(curves.begin(), curves.end(), [&](const TriedCurve& other) {
      return greatestDifference(other.curve, tried.curve) > kSameCurve;
    });
    if (another) {
      curves.push_back(std::move(tried));
    }
  };
  const std::vector<TriedCurve> whole = curves;
  for (const TriedCurve& tried : whole) {
    if (tried.preset != FCF::Preset::Half) {
      add({loweredCurve(tried.curve), tried.preset, kLowered});
    }
  }
  for (const TriedCurve& tried : whole) {
    add({FCF::through(tried.curve.points(), !tried.curve.monotone()).value(), tried.preset});
  }
  return curves;
}

std::vector<double> falloffsToTry(double present) {
  std::vector<double> falloffs = {present};
  for (const double falloff : kFalloffs) {
    const bool other = falloff > kSameFalloff * present || present > kSameFalloff * falloff;
    if (other && falloffs.size() <= kOtherValues) {
      falloffs.push_back(falloff);
    }
  }
  return falloffs;
}

// None first, then those that fit best.
std::vector<int> shiftsToTry(const AnchoredLoop& part, const AnchoredLoop& base,
                             AdjustmentSettings settings) {
  settings.lineField = false;
  const std::size_t n = part.cvs.size();
  std::vector<Point> baseCvs;
  for (const Index cv : base.cvs) {
    baseCvs.push_back(base.mesh->point(cv));
  }
  struct Fit {
    int shift;
    double distance;  // mean, of the CVs, in diameters of the base's loop
  };
  std::vector<Fit> fits;
  double best = 0;
  for (std::size_t turned = 0; turned < n; ++turned) {
    std::vector<Point> partCvs(n);
    for (std::size_t i = 0; i < n; ++i) {
      partCvs[(i + turned) % n] = part.mesh->point(part.cvs[i]);
    }
    if (const Result<Adjustment> adjusted = adjust({}, partCvs, baseCvs, settings, {})) {
      const AdjustmentReport& report = adjusted->report;
      const int shift = static_cast<int>(turned) - (turned > n / 2 ? static_cast<int>(n) : 0);
      fits.push_back({shift, report.distanceAfterScale / report.loopDiameter});
      best = fits.size() == 1 ? fits.back().distance : std::min(best, fits.back().distance);
    }
  }
  std::erase_if(fits, [&](const Fit& fit) {
    return fit.shift == 0 || !(fit.distance <= kWorseFit * best + kWorseFitDiameters);
  });
  const auto rank = [&](const Fit& fit) {
    return std::tuple(std::floor((fit.distance - best) / kEqualFitDiameters), std::abs(fit.shift),
                      fit.shift < 0);
  };
  std::sort(fits.begin(), fits.end(), [&](const Fit& a, const Fit& b) { return rank(a) < rank(b); });
  std::vector<int> shifts = {0};
  for (const Fit& fit : fits) {
    if (shifts.size() <= kOtherValues) {
      shifts.push_back(fit.shift);
    }
  }
  return shifts;
}

Result<std::shared_ptr<const AnchoredLoop>> anchoredSide(const FusionResults& results, Side side) {
  const auto& known = side == Side::Part ? results.part.anchored : results.base.anchored;
  if (known) {
    return known;
  }
  const FusionInputs& inputs = results.inputs;
  return anchorLoop(side == Side::Part ? inputs.part : inputs.base, inputs.loop, side)
      .map([](AnchoredLoop&& loop) { return std::make_shared<const AnchoredLoop>(std::move(loop)); });
}

// All that is tried; combination 0 are the present settings.
Sweep settingsToTry(const FusionInputs& present, const AnchoredLoop& part, const AnchoredLoop& base,
                    const std::vector<TriedCurve>& curves) {
  Sweep sweep;
  sweep.base = present;
  const AdjustmentSettings& adjustment = present.adjustment;
  sweep.shifts = shiftsToTry(part, base, adjustment);
  AdjustmentSettings everyStep = adjustment;
  everyStep.rigid = everyStep.scale = everyStep.lineField = everyStep.exactFit = true;
  if (everyStep == adjustment) {
    sweep.falloffs = falloffsToTry(adjustment.falloff);
  } else {
    sweep.adjustments = {{"present", adjustment}, {"every step", everyStep}};
  }
  for (const TriedCurve& curve : curves) {
    sweep.curves.push_back({{}, curve.curve});
  }
  return sweep;
}

// An error that other settings than the loop's cannot mend.
bool isHopeless(const FusionResults& results) {
  return results.failedAt <= Stage::Tile || results.error->code == ErrorCode::OutOfMemory ||
         (results.failedAt == Stage::Embed && results.error->side == Side::Base);
}

int changesOf(const FusionInputs& before, const FusionInputs& after) {
  return (before.fcf == after.fcf ? 0 : 1) + (before.fcf.monotone() == after.fcf.monotone() ? 0 : 1) +
         (before.adjustment == after.adjustment ? 0 : 1) + (before.loop == after.loop ? 0 : 1);
}

double suggestionKey(const Measures& measures, SuggestionOrder order) {
  const bool mostFirst = order == SuggestionOrder::GreatestDistance || order == SuggestionOrder::Quality;
  const double measure = measureOf(measures, order);
  return mostFirst ? -measure : measure;
}

// Of these, from the first on, those that differ from all taken before by at least `apart`.
std::vector<std::size_t> takeApart(const Suggestions& suggestions, const std::vector<std::size_t>& from,
                                   double apart) {
  std::vector<std::size_t> taken;
  for (const std::size_t i : from) {
    const bool differs = std::all_of(taken.begin(), taken.end(), [&](std::size_t other) {
      return suggestions.differences(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(other)) >= apart;
    });
    if (differs && taken.size() < kMostSuggestions) {
      taken.push_back(i);
    }
  }
  return taken;
}

}  // namespace

Result<Suggestions> suggest(const FusionResults& present, const NearestSurface& base,
                            const Progress& progress) {
  assert(base.mesh() == present.inputs.base);
  const std::vector<TriedCurve> curves = curvesToTry(present.inputs.fcf);
  const auto part = anchoredSide(present, Side::Part);
  const auto baseLoop = anchoredSide(present, Side::Base);
  if (!part || !baseLoop) {
    return fail(part ? baseLoop.error() : part.error());
  }
  const Sweep sweep = settingsToTry(present.inputs, **part, **baseLoop, curves);
  assert(sweep.count() <= kMostSettingsTried && sweep.count() <= kMostPlacementsTried * curves.size());

  Suggestions suggestions;
  suggestions.tried = sweep.count() - 1;
  FusionResults previous = present;
  std::optional<TileSamples> samples;
  std::optional<std::vector<Point>> presentPlaces;
  std::vector<std::vector<Point>> places;  // of each candidate
  double unit = 0;
  std::optional<std::size_t> failedPlacement;
  std::size_t done = 0;
  const auto count = static_cast<double>(sweep.count());
  for (const std::size_t combination : runOrder(sweep)) {
    const Progress step =
        progress.span(static_cast<double>(done) / count, static_cast<double>(done + 1) / count);
    ++done;
    const std::size_t placement = combination / curves.size();
    if (placement == failedPlacement) {
      continue;  // curves cannot mend it
    }
    previous = update(sweep.inputs(combination), previous, step.span(0, kFusionShare));
    if (previous.error && previous.error->code == ErrorCode::Cancelled) {
      return fail(*previous.error);
    }
    if (previous.error) {
      if (isHopeless(previous)) {
        return fail(*previous.error);
      }
      failedPlacement = placement;
      continue;
    }
    if (!samples) {
      samples.emplace(*previous.combined, kTileSamples);
      unit = std::max(samples->partDistance(previous), kLeastUnit * previous.adjustment->report.loopDiameter);
    }
    std::vector<Point> there = samples->positions(previous);
    if (combination == 0) {
      presentPlaces = std::move(there);
      continue;
    }
    if (presentPlaces && rootMeanSquareDistance(*presentPlaces, there) < kLookAlike * unit) {
      continue;
    }
    const Result<Measures> measures = measure(previous, base, step.span(kFusionShare, 1));
    if (!measures) {
      return fail(measures.error());
    }
    const SweepChoice choice = sweep.choice(combination);
    const TriedCurve& curve = curves[choice.curve];
    suggestions.candidates.push_back({previous.inputs, curve.preset, curve.height, sweep.shifts[choice.shift],
                                      changesOf(present.inputs, previous.inputs), *measures});
    places.push_back(std::move(there));
    if (!step.keepGoing(1)) {
      return fail(ErrorCode::Cancelled, "The search for suggestions was cancelled.");
    }
  }

  const auto size = static_cast<Eigen::Index>(places.size());
  suggestions.differences = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      suggestions.differences(i, j) = suggestions.differences(j, i) =
          rootMeanSquareDistance(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(j)]) /
          unit;
    }
  }
  return suggestions;
}

double measureOf(const Measures& measures, SuggestionOrder order) {
  switch (order) {
    case SuggestionOrder::MeanSeamAngle:
      return measures.meanSeamAngle;
    case SuggestionOrder::GreatestSeamAngle:
      return measures.greatestSeamAngle;
    case SuggestionOrder::LeastDistance:
    case SuggestionOrder::GreatestDistance:
      return measures.greatestDistance;
    case SuggestionOrder::Quality:
      return measures.lowQuality;
  }
  return 0;
}

std::vector<std::size_t> choose(const Suggestions& suggestions, SuggestionOrder order) {
  const std::vector<Suggestion>& candidates = suggestions.candidates;
  if (candidates.empty()) {
    return {};
  }
  const auto key = [&](std::size_t i) { return suggestionKey(candidates[i].measures, order); };
  std::vector<std::size_t> all(candidates.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto byKey = [&](std::size_t a, std::size_t b) { return key(a) < key(b); };
  std::stable_sort(all.begin(), all.end(), byKey);
  const double best = key(all.front());
  const double equal = kEquallyGood * (key(all.back()) - best);
  const auto rank = [&](std::size_t i) {
    return std::pair(equal > 0 ? std::floor((key(i) - best) / equal) : 0.0, candidates[i].changes);
  };
  std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });

  std::vector<std::size_t> good = all;
  good.resize(std::min(all.size(), std::max(kMostSuggestions, all.size() - all.size() / 4)));
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < kApart.size() && taken.size() < kMostSuggestions; ++i) {
    taken = takeApart(suggestions, good, kApart[i]);
  }
  if (taken.size() < kFewestSuggestions) {
    taken = takeApart(suggestions, all, kLookAlike);
  }
  std::stable_sort(taken.begin(), taken.end(), byKey);
  return taken;
}

}  // namespace graftsman
