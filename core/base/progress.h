#pragma once

#include <chrono>
#include <functional>
#include <memory>

namespace graftsman {

/// Reports how far a stage is and carries the wish to stop back into it.
///
/// Copies share one state. A default-constructed Progress reports nothing and never stops anything.
/// Thread-safe: a stage's workers may all call keepGoing(); the report runs under a lock, one call at a time.
class Progress {
 public:
  /// Called with a fraction in [0, 1] that never falls; returns false to ask the stage to stop soon.
  using Report = std::function<bool(double)>;

  Progress() = default;

  /// Calls `report` at most once every `interval`; an interval of zero reports every call (for tests).
  explicit Progress(Report report,
                    std::chrono::steady_clock::duration interval = std::chrono::milliseconds(50));

  /// Tells that the fraction `done` of this Progress's span is finished. False: stop soon, return Cancelled.
  /// Cheap enough (a clock read) to be called every few microseconds of work.
  [[nodiscard]] bool keepGoing(double done) const;

  /// True once a report has returned false.
  [[nodiscard]] bool cancelled() const;

  /// The Progress of a sub-task that spans the fractions `from` to `to` of this one.
  [[nodiscard]] Progress span(double from, double to) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
  double from_ = 0;
  double to_ = 1;
};

}  // namespace graftsman
