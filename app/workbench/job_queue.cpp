#include "app/workbench/job_queue.h"

#include <QMetaObject>
#include <utility>

namespace graftsman {

JobQueue::JobQueue(QObject* parent) : QObject(parent), worker_([this] { work(); }) {}

JobQueue::~JobQueue() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    std::erase_if(waiting_, [](const Job& job) { return job.atEnd == AtEnd::Stop; });
    stop_ = stop_ || running_ == AtEnd::Stop;
  }
  wake_.notify_one();
  worker_.join();
}

void JobQueue::start(const QString& what, std::function<Continuation(const Progress&)> work, AtEnd atEnd) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({what, std::move(work), atEnd});
  }
  wake_.notify_one();
  if (unfinished_++ == 0) {
    Q_EMIT busyChanged(true);
  }
}

void JobQueue::cancel() {
  const std::lock_guard lock(mutex_);
  stop_ = true;
}

void JobQueue::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return !waiting_.empty() || quit_; });
    if (waiting_.empty()) {
      return;
    }
    const Job job = std::move(waiting_.front());
    waiting_.pop_front();
    stop_ = false;
    running_ = job.atEnd;
    lock.unlock();
    const Progress progress([this, what = job.what](double done) {
      QMetaObject::invokeMethod(
          this, [this, what, done] { Q_EMIT progressed(what, done); }, Qt::QueuedConnection);
      const std::lock_guard guard(mutex_);
      return !stop_;
    });
    Continuation done = job.work(progress);
    QMetaObject::invokeMethod(
        this,
        [this, done = std::move(done)] {
          --unfinished_;
          if (done) {
            done();
          }
          if (unfinished_ == 0) {
            Q_EMIT busyChanged(false);
          }
        },
        Qt::QueuedConnection);
    lock.lock();
  }
}

}  // namespace graftsman
