#include "app/workbench/autosave.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

#include "app/document/document_model.h"
#include "app/workbench/job_queue.h"
#include "app/workbench/project_files.h"

namespace graftsman {
namespace {

constexpr auto kEnding = ".graft";

// The project that a recovery file belongs to stands in a text file beside it.
QString ownerPath(const QString& recoveryPath) {
  return recoveryPath + ".of";
}

QString lockPath(const QString& recoveryPath) {
  return recoveryPath + ".lock";
}

QString newPath(const QString& folder) {
  QDir().mkpath(folder);
  return QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + kEnding);
}

}  // namespace

Autosave::Autosave(DocumentModel& model, ProjectFiles& files, JobQueue& jobs, const QString& folder,
                   QObject* parent)
    : QObject(parent),
      model_(model),
      files_(files),
      jobs_(jobs),
      path_(newPath(folder)),
      lock_(lockPath(path_)),
      timer_(this) {
  lock_.setStaleLockTime(0);
  lock_.tryLock();
  connect(&model, &DocumentModel::changed, this, [this](Change change) {
    if (change == Change::Reset) {
      dirty_ = false;
      removeOwn();
    } else if (change != Change::Drag) {
      dirty_ = true;
    }
  });
  connect(&files, &ProjectFiles::saved, this, [this] { removeOwn(); });
  connect(&timer_, &QTimer::timeout, this, &Autosave::saveNow);
  timer_.start(kIntervalMs);
}

Autosave::~Autosave() {
  removeOwn();
}

QString Autosave::defaultFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath("recovery");
}

std::vector<Recoverable> Autosave::findRecoverable(const QString& folder) {
  std::vector<Recoverable> found;
  for (const QFileInfo& file :
       QDir(folder).entryInfoList({QString("*") + kEnding}, QDir::Files, QDir::Time)) {
    QLockFile lock(lockPath(file.filePath()));
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) {
      continue;  // of a program that runs
    }
    QFile owner(ownerPath(file.filePath()));
    const QString original = owner.open(QIODevice::ReadOnly) ? QString::fromUtf8(owner.readAll()) : QString();
    found.push_back({file.filePath(), original, file.lastModified()});
  }
  return found;
}

void Autosave::discard(const Recoverable& left) {
  QFile::remove(left.path);
  QFile::remove(ownerPath(left.path));
  QFile::remove(lockPath(left.path));
}

void Autosave::adopt(const Recoverable& left) {
  adopted_ = left;
  dirty_ = true;
  saveNow();
}

void Autosave::saveNow() {
  if (!dirty_ || model_.history()->isClean()) {
    return;
  }
  dirty_ = false;
  const QString original = files_.path();
  jobs_.start<Result<void>>(
      tr("Autosaving"),
      [path = path_, original, project = files_.snapshot()](const Progress&) -> Result<void> {
        // First whose it is: a recovery file without that would lose its name.
        QFile owner(ownerPath(path));
        if (!owner.open(QIODevice::WriteOnly) || owner.write(original.toUtf8()) < 0) {
          return fail(ErrorCode::FileUnwritable, ownerPath(path).toStdString() + ": cannot be written (" +
                                                     owner.errorString().toStdString() + ").");
        }
        owner.close();
        return writeProject(std::filesystem::path(path.toStdU16String()), project, {});
      },
      [this](const Result<void>& written) {
        if (!written) {
          dirty_ = true;
          Q_EMIT failed(QString::fromStdString(written.error().message));
          return;
        }
        if (adopted_) {
          discard(*adopted_);
          adopted_.reset();
        }
        if (model_.history()->isClean()) {
          removeOwn();
        }
        Q_EMIT autosaved();
      });
}

void Autosave::removeOwn() {
  QFile::remove(path_);
  QFile::remove(ownerPath(path_));
}

}  // namespace graftsman
