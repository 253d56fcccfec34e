#include "app/workbench/project_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <utility>

#include "app/document/commands.h"
#include "app/document/document_model.h"
#include "app/workbench/job_queue.h"
#include "core/io/mesh_file.h"
#include "core/io/report.h"
#include "core/io/result_file.h"
#include "core/io/scenario.h"
#include "core/project/edits.h"

namespace graftsman {
namespace {

constexpr int kRecentFiles = 10;
constexpr auto kRecentKey = "recentFiles";

std::filesystem::path toPath(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

QString fileName(const QString& path) {
  return QFileInfo(path).fileName();
}

Project fromScenario(LoadedScenario loaded) {
  const auto asset = [](const std::filesystem::path& source, const ReadReport& report,
                        const std::shared_ptr<const TriangleMesh>& mesh) {
    return std::make_shared<const MeshAsset>(MeshAsset{source.filename().string(), source, report, mesh});
  };
  Fusion fusion;
  fusion.inputs = std::move(loaded.scenario.inputs);
  setAsset(fusion, Side::Part, asset(loaded.scenario.part, loaded.partReport, fusion.inputs.part));
  setAsset(fusion, Side::Base, asset(loaded.scenario.base, loaded.baseReport, fusion.inputs.base));
  fusion.closed = true;
  Project project;
  project.document.fusions = {std::make_shared<const Fusion>(std::move(fusion))};
  return project;
}

Result<LoadedProject> read(const std::filesystem::path& path, const Progress& progress) {
  if (path.extension() != ".json") {
    return readProject(path, progress);
  }
  return readScenario(path, progress).map([](LoadedScenario&& loaded) {
    return LoadedProject{fromScenario(std::move(loaded)), {}};
  });
}

}  // namespace

ProjectFiles::ProjectFiles(DocumentModel& model, JobQueue& jobs, ProjectView view, QObject* parent)
    : QObject(parent), model_(model), jobs_(jobs), view_(std::move(view)) {
  connect(model.history(), &QUndoStack::cleanChanged, this, &ProjectFiles::stateChanged);
}

QString ProjectFiles::name() const {
  return name_.isEmpty() ? tr("Untitled") : name_;
}

QStringList ProjectFiles::recent() {
  return QSettings().value(kRecentKey).toStringList();
}

void ProjectFiles::remember(const QString& path) {
  QStringList files = recent();
  const QString absolute = QFileInfo(path).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  QSettings().setValue(kRecentKey, files.mid(0, kRecentFiles));
}

void ProjectFiles::show(Project project, const QString& path, const QString& name, bool unsaved) {
  path_ = path;
  name_ = name;
  remains_ = std::move(project.remains);
  historySaved_ = !project.history.steps.empty();
  model_.reset(std::move(project.document), project.shown, project.history);
  if (unsaved) {
    model_.history()->resetClean();
  }
  view_.restore(project.viewState);
  Q_EMIT stateChanged();
  Q_EMIT opened();
}

void ProjectFiles::startNew() {
  show({}, {}, {});
}

void ProjectFiles::open(const QString& path) {
  jobs_.start<Result<LoadedProject>>(
      tr("Opening %1").arg(fileName(path)),
      [path](const Progress& progress) { return read(toPath(path), progress); },
      [this, path](Result<LoadedProject> loaded) {
        if (!loaded) {
          Q_EMIT failed(QString::fromStdString(loaded.error().message));
          return;
        }
        const bool isProject = !path.endsWith(".json");
        show(std::move(loaded->project), isProject ? path : QString(), QFileInfo(path).completeBaseName());
        if (isProject) {
          remember(path);
        }
        QStringList damage;
        for (const Error& error : loaded->damage) {
          damage.append(QString::fromStdString(error.message));
        }
        if (!damage.isEmpty()) {
          Q_EMIT failed(
              tr("%1 is damaged; the rest of it is open. %2").arg(fileName(path), damage.join(' ')));
        }
      });
}

void ProjectFiles::recover(const QString& recoveryPath, const QString& originalPath) {
  jobs_.start<Result<LoadedProject>>(
      tr("Recovering"),
      [recoveryPath](const Progress& progress) { return read(toPath(recoveryPath), progress); },
      [this, originalPath](Result<LoadedProject> loaded) {
        if (!loaded) {
          Q_EMIT failed(QString::fromStdString(loaded.error().message));
          return;
        }
        show(std::move(loaded->project), originalPath, QFileInfo(originalPath).completeBaseName(), true);
        Q_EMIT told(tr("Recovered. Save the project to keep it."));
      });
}

Project ProjectFiles::snapshot() const {
  return {model_.document(), model_.shown(), view_.thumbnail(),    {},
          view_.state(),     remains_,       model_.historyValue()};
}

void ProjectFiles::forgetHistory() {
  const bool stays = model_.history()->isClean() && !historySaved_;
  const int steps = model_.history()->count();
  model_.forgetHistory();
  if (!stays) {
    model_.history()->resetClean();
  }
  Q_EMIT told(steps == 1 ? tr("Forgot one step of history") : tr("Forgot %1 steps of history").arg(steps));
}

void ProjectFiles::save(const QString& path, std::function<void()> then) {
  const int savedIndex = model_.history()->index();
  const bool withHistory = model_.history()->count() > 0;
  jobs_.start<Result<void>>(
      tr("Saving %1").arg(fileName(path)),
      [path, project = snapshot()](const Progress&) { return writeProject(toPath(path), project, {}); },
      [this, path, savedIndex, withHistory, then = std::move(then)](const Result<void>& written) {
        if (!written) {
          Q_EMIT failed(QString::fromStdString(written.error().message));
          return;
        }
        path_ = path;
        name_ = QFileInfo(path).completeBaseName();
        historySaved_ = withHistory;
        // An edit made while the file was written is not in it.
        if (model_.history()->index() == savedIndex) {
          model_.history()->setClean();
        }
        remember(path);
        Q_EMIT stateChanged();
        Q_EMIT saved(path);
        if (then) {
          then();
        }
      });
}

void ProjectFiles::importMesh(Side side, const QString& path) {
  jobs_.start<Result<MeshFile>>(
      tr("Reading %1").arg(fileName(path)),
      [path](const Progress& progress) { return readMesh(toPath(path), progress); },
      [this, side, path](Result<MeshFile> file) {
        if (!file) {
          Q_EMIT failed(QString::fromStdString(file.error().message));
          return;
        }
        const QString report = QString::fromStdString(describe(file->report)).trimmed().replace('\n', "; ");
        auto asset = std::make_shared<const MeshAsset>(
            MeshAsset{fileName(path).toStdString(), toPath(path), file->report, std::move(file->mesh)});
        model_.push(
            std::make_unique<LoadMesh>(model_, edits::loadMesh(model_.committed(), side, asset), side));
        Q_EMIT told(tr("Read %1: %2").arg(fileName(path), report));
      });
}

void ProjectFiles::exportResult(const QString& path, std::shared_ptr<const FusionResults> results) {
  jobs_.start<Result<void>>(
      tr("Exporting %1").arg(fileName(path)),
      [path, results = std::move(results)](const Progress& progress) {
        return writeResult(toPath(path), *results, progress);
      },
      [this, path](const Result<void>& written) {
        if (!written) {
          Q_EMIT failed(QString::fromStdString(written.error().message));
          return;
        }
        Q_EMIT exported(path);
        Q_EMIT told(tr("Exported %1").arg(QDir::toNativeSeparators(path)));
      });
}

}  // namespace graftsman
