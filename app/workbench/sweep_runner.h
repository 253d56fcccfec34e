#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "app/workbench/sweep_plan.h"
#include "core/base/progress.h"

namespace graftsman {

/// What came out of a sweep.
struct SweepOutcome {
  FusionId shown = 1;  // the fusion that was varied
  /// Those that fused, in the order of their numbers: the document's fusions with the result, and its name.
  std::vector<std::pair<FusionList, QString>> states;
  std::vector<std::pair<QString, QString>> failures;  // name and why it does not fuse
  std::size_t done = 0;                               // of `of`
  std::size_t of = 0;
  bool cancelled = false;
  std::optional<Error> error;  // what ended the sweep: of the upstream, or in writing the folder
};

/// Runs a sweep on a thread of its own. Lives in the GUI thread, which never waits for it (but in the
/// destructor, for the run to notice that it is to stop).
class SweepRunner : public QObject {
  Q_OBJECT

 public:
  explicit SweepRunner(QObject* parent = nullptr);
  ~SweepRunner() override;

  /// Precondition: not busy(), and check() has nothing against the plan.
  void start(SweepPlan plan);
  /// Stops; what is done is told by finished().
  void cancel();
  /// Stops; nothing is told any more.
  void abandon();
  /// From start() until the thread has ended.
  [[nodiscard]] bool busy() const { return busy_; }

 Q_SIGNALS:
  /// `done` results of `of` are there; `fraction`: of the whole run.
  void progressed(int done, int of, double fraction);
  void finished(const graftsman::SweepOutcome& outcome);
  /// busy() became false.
  void idle();

 private:
  [[nodiscard]] SweepOutcome run(const SweepPlan& plan);

  std::atomic<bool> stop_ = false;
  std::thread worker_;
  bool busy_ = false;
  bool abandoned_ = false;
};

}  // namespace graftsman
