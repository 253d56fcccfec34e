#include "core/sweep/sweep_run.h"

namespace graftsman {

SweepResult SweepRun::run(std::size_t combination, const Progress& progress) {
  constexpr double kFusionShare = 0.9;
  SweepResult result;
  result.combination = combination;
  result.results = update(sweep_->inputs(combination), previous_, progress.span(0, kFusionShare));
  previous_ = result.results;
  if (result.results.fused && !result.results.error) {
    if (!base_) {
      base_ = std::make_unique<const NearestSurface>(sweep_->base.base);
    }
    Result<Measures> measures = measure(result.results, *base_, progress.span(kFusionShare, 1));
    if (measures) {
      result.measures = *measures;
    } else {
      result.results.fused = nullptr;
      result.results.error = std::move(measures.error());
    }
  }
  return result;
}

}  // namespace graftsman
