#include "core/base/progress.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace graftsman {

struct Progress::State {
  Report report;
  std::chrono::steady_clock::duration interval;
  std::mutex mutex;
  std::chrono::steady_clock::time_point last;
  double greatest = 0;
  std::atomic<bool> cancelled = false;
};

Progress::Progress(Report report, std::chrono::steady_clock::duration interval)
    : state_(std::make_shared<State>()) {
  state_->report = std::move(report);
  state_->interval = interval;
  state_->last = std::chrono::steady_clock::now() - interval;  // the first call reports
}

bool Progress::keepGoing(double done) const {
  if (!state_) {
    return true;
  }
  if (state_->cancelled) {
    return false;
  }
  const auto now = std::chrono::steady_clock::now();
  const std::unique_lock lock(state_->mutex, std::try_to_lock);
  const bool mustReport = state_->interval == std::chrono::steady_clock::duration::zero();
  if (!lock.owns_lock() || (!mustReport && now - state_->last < state_->interval)) {
    return !state_->cancelled;
  }
  state_->last = now;
  state_->greatest = std::max(state_->greatest, from_ + (to_ - from_) * std::clamp(done, 0.0, 1.0));
  if (!state_->report(state_->greatest)) {
    state_->cancelled = true;
  }
  return !state_->cancelled;
}

bool Progress::cancelled() const {
  return state_ && state_->cancelled;
}

Progress Progress::span(double from, double to) const {
  Progress part = *this;
  part.from_ = from_ + (to_ - from_) * from;
  part.to_ = from_ + (to_ - from_) * to;
  return part;
}

}  // namespace graftsman
