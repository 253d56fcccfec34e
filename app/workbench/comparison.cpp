#include "app/workbench/comparison.h"

#include <QMetaObject>
#include <new>

#include "widgets/viewport/surface_pane.h"

namespace graftsman {
namespace {

// Of the way to the end, one state's computation and the drawing of it; the rest is the difference.
constexpr double kOneState = 0.4;

Compared::One computeState(const ComparedState& state, Evaluated& known, const Progress& progress) {
  Compared::One one;
  if (find(state.fusions, state.shown) == nullptr) {
    one.problem = Comparison::tr("It has no fusion.");
    return one;
  }
  if (state.known && !known.fusions.contains(state.shown)) {
    known.fusions[state.shown].results = *state.known;
  }
  const Evaluation evaluation = evaluate(state.fusions, state.shown, known, progress);
  const FusionResults& results = evaluation.results;
  if (!results.fused) {
    one.problem = results.error              ? QString::fromStdString(results.error->message)
                  : evaluation.fusion.closed ? Comparison::tr("A mesh is missing: there is no result.")
                                             : Comparison::tr("The loop is open: there is no result.");
    return one;
  }
  one.mesh = std::make_shared<const TriangleMesh>(results.fused->points, results.fused->faces());
  one.drawn = drawSurface(one.mesh);
  return one;
}

std::shared_ptr<const Compared> compareStates(const std::array<ComparedState, 2>& states, Evaluated& known,
                                              const Progress& progress) {
  auto made = std::make_shared<Compared>();
  made->sides[0] = computeState(states[0], known, progress.span(0, kOneState));
  made->sides[1] = computeState(states[1], known, progress.span(kOneState, 2 * kOneState));
  const auto& a = made->sides[0].mesh;
  const auto& b = made->sides[1].mesh;
  if (!a || !b) {
    return made;
  }
  made->sameFaces = a->vertexCount() == b->vertexCount() && a->faces() == b->faces();
  if (made->sameFaces) {
    made->between = drawBetween(made->sides[0].drawn, made->sides[1].drawn);
  }
  if (Result<SurfaceDifference> difference = differenceOf(*b, a, progress.span(2 * kOneState, 1))) {
    made->difference = *std::move(difference);
    const double range = made->difference->usual;
    made->coloured = drawSurface(b, made->difference->distances, range > 0 ? range : 1);
  }
  return made;
}

std::shared_ptr<const Compared> withoutMemory() {
  auto made = std::make_shared<Compared>();
  for (Compared::One& side : made->sides) {
    side.problem = Comparison::tr("There is not enough memory to compare the two.");
  }
  return made;
}

}  // namespace

Comparison::Comparison(QObject* parent) : QObject(parent), worker_([this] { work(); }) {}

Comparison::~Comparison() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = stop_ = true;
  }
  wake_.notify_one();
  worker_.join();
}

void Comparison::request(std::array<ComparedState, 2> states) {
  ++wanted_;
  {
    const std::lock_guard lock(mutex_);
    waiting_ = Job{wanted_, std::move(states)};
    stop_ = true;
  }
  wake_.notify_one();
}

void Comparison::work() {
  Evaluated known;  // what the next comparison is computed from
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return waiting_ || quit_; });
    if (quit_) {
      return;
    }
    const Job job = std::move(*waiting_);
    waiting_.reset();
    stop_ = false;
    lock.unlock();
    std::shared_ptr<const Compared> made;
    try {
      made = compareStates(job.states, known, progressOf(job.number));
    } catch (const std::bad_alloc&) {
      known = {};
      made = withoutMemory();
    }
    lock.lock();
    if (!stop_) {
      QMetaObject::invokeMethod(
          this, [this, made, number = job.number] { deliver(number, made); }, Qt::QueuedConnection);
    }
  }
}

Progress Comparison::progressOf(int number) {
  return Progress([this, number](double done) {
    const std::lock_guard lock(mutex_);
    if (!stop_) {
      QMetaObject::invokeMethod(
          this,
          [this, number, done] {
            if (number == wanted_ && busy()) {
              Q_EMIT progressed(done);
            }
          },
          Qt::QueuedConnection);
    }
    return !stop_;
  });
}

// In the GUI thread.
void Comparison::deliver(int number, const std::shared_ptr<const Compared>& made) {
  if (number == wanted_) {
    delivered_ = number;
    Q_EMIT compared(made);
  }
}

}  // namespace graftsman
