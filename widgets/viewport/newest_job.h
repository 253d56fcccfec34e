#pragma once

#include <QFutureWatcher>
#include <QtConcurrentRun>
#include <functional>
#include <optional>

namespace graftsman {

/// Runs jobs on a worker thread, one at a time; of those that come meanwhile only the newest runs. `done` is
/// called on the starting thread with the result of a job that no newer one has followed. A job owns what it
/// works on: it may outlive this object, whose end only means that `done` is not called any more.
template <class T>
class NewestJob {
 public:
  explicit NewestJob(std::function<void(T)> done) : done_(std::move(done)) {
    QObject::connect(&watcher_, &QFutureWatcherBase::finished, &watcher_, [this] { finish(); });
  }

  void start(std::function<T()> job) {
    if (busy_) {
      waiting_ = std::move(job);
      return;
    }
    busy_ = true;
    watcher_.setFuture(QtConcurrent::run(std::move(job)));
  }

  /// The running job's result is not wanted any more.
  void cancel() {
    waiting_.reset();
    unwanted_ = busy_;
  }

 private:
  void finish() {
    busy_ = false;
    const bool wanted = !unwanted_ && !waiting_;
    unwanted_ = false;
    if (waiting_) {
      start(*std::exchange(waiting_, std::nullopt));
    } else if (wanted) {
      done_(watcher_.result());
    }
  }

  std::function<void(T)> done_;
  std::optional<std::function<T()>> waiting_;
  bool busy_ = false;
  bool unwanted_ = false;
  QFutureWatcher<T> watcher_;
};

}  // namespace graftsman
