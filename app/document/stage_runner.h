#pragma once

#include <QObject>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/fusion/open_paths.h"
#include "core/project/evaluate.h"

namespace graftsman {

/// What came out of a run. A closed loop has `results`, and one whose fusion is made of another that has none
/// (they say why); the paths of each mesh where the loop is open, or failed there.
struct Outcome {
  Fusion fusion;        // that it was computed from, resolved
  ResultAssets assets;  // the results that it is made of
  std::shared_ptr<const FusionResults> results;
  std::shared_ptr<const OpenPaths> openPart;
  std::shared_ptr<const OpenPaths> openBase;
  bool cancelled = false;  // by cancel(); what did finish is there
};

/// Where a run is.
struct RunProgress {
  std::optional<Stage> stage;  // none for an open loop
  std::optional<Side> side;
  double done = 0;  // of the whole run, in [0, 1]
};

/// Runs the stages on a thread of its own, one run at a time; the newest inputs win. Lives in the GUI thread,
/// which never waits for it (but in the destructor, for a run to notice that it is to stop).
class StageRunner : public QObject {
  Q_OBJECT

 public:
  explicit StageRunner(QObject* parent = nullptr);
  ~StageRunner() override;

  enum class Urgency {
    Edit,  // cancels a run under way, unless only the curve differs
    Drag,  // lets another drag's run finish first, so that something is always seen
  };

  /// Asks for fusion `id` and what it is made of. What was asked for before and has not begun is forgotten.
  void request(const Document& document, FusionId id, Urgency urgency);
  /// As request(Edit), and the adjustment runs even if nothing changed.
  void requestAdjustment(const Document& document, FusionId id);
  /// Stops the run under way and forgets what is asked for; finished() tells it. Without a run: nothing.
  void cancel();
  /// A run is under way or asked for.
  [[nodiscard]] bool busy() const { return busy_; }

 Q_SIGNALS:
  void busyChanged(bool busy);
  void progressed(const graftsman::RunProgress& progress);
  /// Not for a run that newer inputs overtook.
  void finished(const std::shared_ptr<const graftsman::Outcome>& outcome);

 private:
  struct Request {
    FusionList fusions;
    FusionId id = 0;
    Urgency urgency = Urgency::Edit;
    bool adjustAnew = false;
  };

  void enqueue(Request request);
  void work();
  [[nodiscard]] Outcome run(const Request& request);
  [[nodiscard]] Progress progress();
  /// Asks for deliver(): by its name, so that nothing of ours crosses the threads but what the mutex guards.
  /// Precondition: the mutex is held.
  void notify();
  Q_INVOKABLE void deliver();

  // Shared with the worker, under the mutex.
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Request> pending_;
  std::optional<Request> running_;
  std::optional<Outcome> outcome_;
  RunProgress progress_;
  bool stop_ = false;     // the run under way
  bool dismiss_ = false;  // by cancel()
  bool quit_ = false;
  bool notified_ = false;

  // The worker's own: what the next run starts from.
  Evaluated known_;
  OpenPaths openPart_;
  OpenPaths openBase_;

  bool busy_ = false;  // the GUI thread's
  std::thread worker_;
};

}  // namespace graftsman
