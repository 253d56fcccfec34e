#include "app/workbench/sweep_runner.h"

#include <QMetaObject>
#include <algorithm>
#include <map>
#include <memory>

#include "core/project/document_edits.h"
#include "core/project/evaluate.h"
#include "core/sweep/sweep_folder.h"
#include "core/sweep/sweep_run.h"

namespace graftsman {
namespace {

// The sweep with the meshes of results that its fusion is made of, which are computed for it.
Result<Sweep> resolvedSweep(const SweepPlan& plan, const Progress& progress) {
  Sweep sweep = plan.values;
  Evaluated known;
  const std::size_t origins = std::max<std::size_t>(plan.parts.size(), 1);
  for (std::size_t i = 0; i < origins; ++i) {
    const Fusion& origin = plan.origin(i * plan.values.count());
    const FusionList fusions = edits::withFusion(Document{plan.fusions, {}}, origin).fusions;
    const Upstream upstream = evaluateUpstream(fusions, plan.shown, known, progress);
    if (upstream.error) {
      return fail(*upstream.error);
    }
    const Fusion resolved = resolve(origin, upstream.assets);
    if (i == 0) {
      sweep.base = resolved.inputs;
    }
    if (!plan.parts.empty()) {
      sweep.parts.push_back({plan.parts[i].name.toStdString(), resolved.part->source, resolved.inputs.part,
                             resolved.inputs.loop});
    }
  }
  return sweep;
}

}  // namespace

SweepRunner::SweepRunner(QObject* parent) : QObject(parent) {}

SweepRunner::~SweepRunner() {
  stop_ = true;
  if (worker_.joinable()) {
    worker_.join();
  }
}

void SweepRunner::start(SweepPlan plan) {
  stop_ = false;
  abandoned_ = false;
  busy_ = true;
  worker_ = std::thread([this, plan = std::move(plan)] {
    auto outcome = std::make_shared<const SweepOutcome>(run(plan));
    QMetaObject::invokeMethod(
        this,
        [this, outcome] {
          worker_.join();  // it has nothing left to do
          busy_ = false;
          if (!abandoned_) {
            Q_EMIT finished(*outcome);
          }
          Q_EMIT idle();
        },
        Qt::QueuedConnection);
  });
}

void SweepRunner::cancel() {
  stop_ = true;
}

void SweepRunner::abandon() {
  abandoned_ = true;
  stop_ = true;
}

// On the worker.
SweepOutcome SweepRunner::run(const SweepPlan& plan) {
  SweepOutcome outcome;
  outcome.shown = plan.shown;
  outcome.of = plan.count();
  const auto tell = [this, &outcome](double fraction) {
    const auto done = static_cast<int>(outcome.done);
    const auto of = static_cast<int>(outcome.of);
    const double whole = (done + fraction) / of;
    QMetaObject::invokeMethod(
        this,
        [this, done, of, whole] {
          if (!abandoned_) {
            Q_EMIT progressed(done, of, whole);
          }
        },
        Qt::QueuedConnection);
    return !stop_.load();
  };
  const auto quiet = [this] { return Progress([this](double) { return !stop_.load(); }); };
  const auto ended = [&](const Error& error) {
    outcome.cancelled = error.code == ErrorCode::Cancelled;
    if (!outcome.cancelled) {
      outcome.error = error;
    }
    return outcome;
  };

  Result<Sweep> resolved = resolvedSweep(plan, quiet());
  if (!resolved) {
    return ended(resolved.error());
  }
  const bool isObj = find(plan.fusions, plan.shown)->base->report.format == MeshFormat::Obj;
  Result<LoadedSweep> read = loadSweep(std::move(*resolved), plan.output, isObj);
  if (!read) {
    return ended(read.error());
  }
  read->sources = plan.sources;
  const auto loaded = std::make_shared<const LoadedSweep>(std::move(*read));
  std::optional<SweepFolder> folder;
  if (plan.folder) {
    Result<SweepFolder> opened = SweepFolder::open(*plan.folder, loaded, quiet());
    if (!opened) {
      return ended(opened.error());
    }
    folder.emplace(std::move(*opened));
  }
  SweepRun sweep(std::shared_ptr<const Sweep>(loaded, &loaded->sweep));
  std::map<std::size_t, std::optional<Error>> results;  // by their numbers
  for (const std::size_t number : runOrder(loaded->sweep)) {
    if (!tell(0)) {
      outcome.cancelled = true;
      break;
    }
    const SweepResult result = sweep.run(number, Progress(tell));
    if (result.results.error && result.results.error->code == ErrorCode::Cancelled) {
      outcome.cancelled = true;
      break;
    }
    results[number] = result.results.error;
    ++outcome.done;
    if (folder) {
      // A file that is begun is written.
      if (Result<void> written = folder->add(result, {}); !written) {
        outcome.error = written.error();
        break;
      }
    }
  }
  if (folder) {
    if (Result<void> written = folder->writeTable(); !written && !outcome.error) {
      outcome.error = written.error();
    }
  }
  for (const auto& [number, error] : results) {
    if (error) {
      outcome.failures.emplace_back(plan.name(number), QString::fromStdString(error->message));
    } else {
      outcome.states.emplace_back(plan.state(number), plan.name(number));
    }
  }
  return outcome;
}

}  // namespace graftsman
