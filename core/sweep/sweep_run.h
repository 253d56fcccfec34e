#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/fusion/measures.h"
#include "core/sweep/sweep.h"

namespace graftsman {

/// One combination, computed.
struct SweepResult {
  std::size_t combination = 0;
  FusionResults results;             // with an error where it does not fuse
  std::optional<Measures> measures;  // of what fused
};

/// Runs a sweep's combinations one at a time. From one to the next it reuses what did not change, so that
/// runOrder() is the order that costs least; the results do not depend on it. One thread at a time.
class SweepRun {
 public:
  /// The sweep as check() wants it; it may not change while this lives.
  explicit SweepRun(std::shared_ptr<const Sweep> sweep) : sweep_(std::move(sweep)) {}

  /// Computes and measures a combination. Cancelled by the progress it has that error, and can be run again.
  [[nodiscard]] SweepResult run(std::size_t combination, const Progress& progress);

 private:
  std::shared_ptr<const Sweep> sweep_;
  FusionResults previous_;
  std::unique_ptr<const NearestSurface> base_;
};

}  // namespace graftsman
