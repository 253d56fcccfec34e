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
    result.measures = measure(result.results, *base_);
  }
  return result;
}

}  // namespace graftsman
