#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>

#include "core/base/error.h"
#include "core/project/project_file.h"

namespace graftsman {

class DocumentModel;
class JobQueue;

/// What the window adds to a project when it is saved, and takes from one that is opened.
struct ProjectView {
  std::function<std::string()> thumbnail;                      // PNG bytes of the present look
  std::function<std::string()> state;                          // JSON text
  std::function<void(const std::string& state)> restore;       // after a project was opened
  std::function<std::map<VariantId, std::string>()> pictures;  // PNG bytes of those that have one
  std::function<void(const Document&, std::map<VariantId, std::string>)> restorePictures;  // before that
};

/// The document's file: new, open, save, import, export; each on the job queue, told of when it is done.
/// Remembers recent files in the settings.
class ProjectFiles : public QObject {
  Q_OBJECT

 public:
  ProjectFiles(DocumentModel& model, JobQueue& jobs, ProjectView view, QObject* parent = nullptr);

  /// Of the project; empty: never saved.
  [[nodiscard]] const QString& path() const { return path_; }
  /// The project's name, for the title bar.
  [[nodiscard]] QString name() const;
  [[nodiscard]] static QStringList recent();

  void startNew();
  /// A project (.graft) or a scenario (.json), which becomes a new, unsaved project named after it.
  void open(const QString& path);
  /// Opens what a crash left behind as the unsaved state of `originalPath` (which may be empty).
  void recover(const QString& recoveryPath, const QString& originalPath);
  /// Calls `then` when the file is written, not if that failed.
  void save(const QString& path, std::function<void()> then = {});
  void importMesh(Side side, const QString& path);
  /// Writes the result as OBJ, PLY, STL, OFF, or GLB.
  void exportResult(const QString& path, std::shared_ptr<const FusionResults> results);

  /// Forgets every step of undo. The document stays; it is unsaved if its file has a history.
  void forgetHistory();

  /// The project as it would be saved now, without a drag under way.
  [[nodiscard]] Project snapshot() const;

 Q_SIGNALS:
  /// path(), name() or the modified state changed.
  void stateChanged();
  void opened();
  void saved(const QString& path);
  void exported(const QString& path);
  /// What could not be done, and why.
  void failed(const QString& message);
  /// Something worth a line in the status bar ("Read head.obj: 12 polygons triangulated").
  void told(const QString& message);

 private:
  void show(Project project, const QString& path, const QString& name, bool unsaved = false);
  void remember(const QString& path);

  DocumentModel& model_;
  JobQueue& jobs_;
  ProjectView view_;
  QString path_;
  QString name_;
  std::shared_ptr<const ProjectRemains> remains_;
  bool historySaved_ = false;  // the file has steps of history
};

}  // namespace graftsman
