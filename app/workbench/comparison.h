#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/fusion/difference.h"
#include "core/project/evaluate.h"

namespace graftsman {

struct DrawnBetween;
struct DrawnSurface;

/// One of two states to be compared.
struct ComparedState {
  FusionList fusions;
  FusionId shown = 0;                               // of `fusions`
  std::shared_ptr<const FusionResults> known = {};  // results that it may have; or null
};

/// Two states computed, made ready to be shown.
struct Compared {
  struct One {
    std::shared_ptr<const TriangleMesh> mesh;  // the result; null: see `problem`
    std::shared_ptr<const DrawnSurface> drawn;
    QString problem;  // why there is no result
  };
  std::array<One, 2> sides;
  std::optional<SurfaceDifference> difference;   // of the second from the first; nullopt: one has no result
  std::shared_ptr<const DrawnSurface> coloured;  // the second, by its distances
  bool sameFaces = false;                        // one can become the other
  std::shared_ptr<const DrawnBetween> between;   // where it can
};

/// Computes and compares two states on a thread of its own. Lives in the GUI thread, which never waits for it
/// (but in the destructor, for a run to notice that it is to stop).
class Comparison : public QObject {
  Q_OBJECT

 public:
  explicit Comparison(QObject* parent = nullptr);
  ~Comparison() override;

  /// Compares these instead of those that were asked for before.
  void request(std::array<ComparedState, 2> states);
  /// compared() is still to come for what was requested last.
  [[nodiscard]] bool busy() const { return wanted_ != delivered_; }

 Q_SIGNALS:
  /// The fraction that is done.
  void progressed(double done);
  void compared(const std::shared_ptr<const graftsman::Compared>& compared);

 private:
  struct Job {
    int number = 0;
    std::array<ComparedState, 2> states;
  };
  void work();
  [[nodiscard]] Progress progressOf(int number);
  void deliver(int number, const std::shared_ptr<const Compared>& made);

  int wanted_ = 0;  // number of the last request; the GUI thread's, as the next
  int delivered_ = 0;

  std::mutex mutex_;  // of what follows, but the thread
  std::condition_variable wake_;
  std::optional<Job> waiting_;
  bool stop_ = false;
  bool quit_ = false;
  std::thread worker_;
};

}  // namespace graftsman
