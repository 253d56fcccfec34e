#include "app/document/stage_runner.h"

#include <QMetaObject>
#include <utility>

namespace graftsman {
namespace {

// The same but for the fusion curve: a run under way stays useful, what is missing is a blend.
bool onlyCurveDiffers(const FusionList& before, const FusionList& now, FusionId id) {
  if (find(before, id) == nullptr || before.size() != now.size()) {
    return false;
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    Fusion fusion = *before[i];
    if (fusion.id == id) {
      fusion.inputs.fcf = now[i]->inputs.fcf;
    }
    if (before[i] != now[i] && !(fusion == *now[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

StageRunner::StageRunner(QObject* parent) : QObject(parent), worker_([this] { work(); }) {}

StageRunner::~StageRunner() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = stop_ = true;
  }
  wake_.notify_one();
  worker_.join();
}

void StageRunner::request(const Document& document, FusionId id, Urgency urgency) {
  enqueue({document.fusions, id, urgency, false});
}

void StageRunner::requestAdjustment(const Document& document, FusionId id) {
  enqueue({document.fusions, id, Urgency::Edit, true});
}

void StageRunner::enqueue(Request request) {
  {
    const std::lock_guard lock(mutex_);
    const bool followsDrag =
        running_ && running_->urgency == Urgency::Drag && request.urgency == Urgency::Drag;
    if (running_ && !followsDrag &&
        (running_->id != request.id || !onlyCurveDiffers(running_->fusions, request.fusions, request.id))) {
      stop_ = true;
    }
    if (pending_ && pending_->adjustAnew) {
      request.adjustAnew = true;
    }
    pending_ = std::move(request);
  }
  wake_.notify_one();
  if (!std::exchange(busy_, true)) {
    Q_EMIT busyChanged(true);
  }
}

void StageRunner::cancel() {
  const std::lock_guard lock(mutex_);
  if (running_) {
    stop_ = dismiss_ = true;
  } else if (pending_) {
    outcome_ = Outcome{*find(pending_->fusions, pending_->id), {}, {}, {}, {}, true};
  }
  pending_.reset();
  notify();
}

void StageRunner::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return pending_ || quit_; });
    if (quit_) {
      return;
    }
    running_ = std::move(pending_);
    pending_.reset();
    stop_ = dismiss_ = false;
    const Request request = *running_;
    lock.unlock();
    Outcome outcome = run(request);
    lock.lock();
    const bool overtaken = stop_ && !dismiss_;
    outcome.cancelled = dismiss_;
    running_.reset();
    if (quit_) {
      return;
    }
    if (!overtaken) {
      outcome_ = std::move(outcome);
    }
    notify();
  }
}

void StageRunner::notify() {
  if (!std::exchange(notified_, true)) {
    QMetaObject::invokeMethod(this, "deliver", Qt::QueuedConnection);
  }
}

Outcome StageRunner::run(const Request& request) {
  const Progress whole = progress();
  if (request.adjustAnew) {
    known_.fusions[request.id].results.adjustment.reset();
  }
  Evaluation evaluation =
      evaluate(request.fusions, request.id, known_, whole, [this](Stage stage, std::optional<Side> side) {
        const std::lock_guard lock(mutex_);
        progress_.stage = stage;
        progress_.side = side;
      });
  Outcome outcome{std::move(evaluation.fusion), std::move(evaluation.assets), {}, {}, {}, false};
  const Fusion& fusion = outcome.fusion;
  const FusionInputs& inputs = fusion.inputs;
  if ((fusion.closed && fusion.part && fusion.base) || evaluation.results.error) {
    outcome.results = std::make_shared<const FusionResults>(std::move(evaluation.results));
  }
  // Of a loop that is open, or has no simple closed curve, a person sees each path as it is alone.
  const auto find = [&](Side side, OpenPaths& known,
                        const Progress& part) -> std::shared_ptr<const OpenPaths> {
    const auto& mesh = side == Side::Part ? inputs.part : inputs.base;
    if (outcome.results && (side == Side::Part ? outcome.results->part : outcome.results->base).paths) {
      return nullptr;
    }
    known =
        mesh ? findOpenPaths(mesh, inputs.loop, fusion.closed, side, inputs.paths, known, part) : OpenPaths{};
    return std::make_shared<const OpenPaths>(known);
  };
  outcome.openPart = find(Side::Part, openPart_, whole.span(0, 0.5));
  outcome.openBase = find(Side::Base, openBase_, whole.span(0.5, 1));
  return outcome;
}

Progress StageRunner::progress() {
  {
    const std::lock_guard lock(mutex_);
    progress_ = {};
  }
  return Progress([this](double done) {
    const std::lock_guard lock(mutex_);
    progress_.done = done;
    notify();
    return !stop_;
  });
}

// In the GUI thread: tells what happened since the last time.
void StageRunner::deliver() {
  std::optional<Outcome> outcome;
  RunProgress now;
  bool running = false;
  bool idle = false;
  {
    const std::lock_guard lock(mutex_);
    notified_ = false;
    outcome = std::exchange(outcome_, std::nullopt);
    now = progress_;
    running = running_.has_value();
    idle = !running_ && !pending_;
  }
  if (idle) {
    busy_ = false;
  }
  if (outcome) {
    Q_EMIT finished(std::make_shared<const Outcome>(std::move(*outcome)));
  }
  if (running && busy_) {
    Q_EMIT progressed(now);
  }
  if (idle && !busy_) {
    Q_EMIT busyChanged(false);
  }
}

}  // namespace graftsman
