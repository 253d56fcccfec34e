#pragma once

#include <QObject>
#include <QString>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "core/base/progress.h"

namespace graftsman {

/// Runs what takes long and is no stage (reading, writing, exporting) on a thread of its own, in order, one
/// at a time. The destructor waits for the jobs that are to be finished (a file being written is written).
class JobQueue : public QObject {
  Q_OBJECT

 public:
  explicit JobQueue(QObject* parent = nullptr);
  ~JobQueue() override;

  /// What is done with a job's result, in the GUI thread.
  using Continuation = std::function<void()>;

  /// What becomes of a job when the queue ends before it: it is finished all the same, or asked to stop.
  enum class AtEnd { Finish, Stop };

  /// Runs `work` on the queue's thread, then the continuation that it returns in the GUI thread. `what` is
  /// shown meanwhile ("Reading head.obj").
  void start(const QString& what, std::function<Continuation(const Progress&)> work,
             AtEnd atEnd = AtEnd::Finish);

  /// As above for work that gives a value.
  template <class T>
  void start(const QString& what, std::function<T(const Progress&)> work, std::function<void(T)> done,
             AtEnd atEnd = AtEnd::Finish) {
    start(
        what,
        [work = std::move(work), done = std::move(done)](const Progress& progress) -> Continuation {
          auto result = std::make_shared<T>(work(progress));
          return [result, done] { done(std::move(*result)); };
        },
        atEnd);
  }

  /// Asks the job under way to stop. Its continuation runs all the same.
  void cancel();
  [[nodiscard]] bool busy() const { return unfinished_ > 0; }

 Q_SIGNALS:
  void busyChanged(bool busy);
  void progressed(const QString& what, double done);

 private:
  struct Job {
    QString what;
    std::function<Continuation(const Progress&)> work;
    AtEnd atEnd = AtEnd::Finish;
  };
  void work();

  std::mutex mutex_;  // of the next four
  std::deque<Job> waiting_;
  AtEnd running_ = AtEnd::Finish;  // of the job under way
  bool stop_ = false;
  bool quit_ = false;
  std::condition_variable wake_;
  int unfinished_ = 0;  // the GUI thread's
  std::thread worker_;
};

}  // namespace graftsman
