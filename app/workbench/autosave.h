#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <vector>

namespace graftsman {

class DocumentModel;
class JobQueue;
class ProjectFiles;

/// What a crash left behind.
struct Recoverable {
  QString path;          // of the recovery file
  QString originalPath;  // of the project it belongs to; empty: never saved
  QDateTime savedAt;
};

/// Writes the unsaved state beside the person's other data every two minutes, and takes it away when the
/// project is saved or the program ends as it should.
class Autosave : public QObject {
  Q_OBJECT

 public:
  static constexpr int kIntervalMs = 120'000;

  /// `folder` is made where it is missing.
  Autosave(DocumentModel& model, ProjectFiles& files, JobQueue& jobs, const QString& folder,
           QObject* parent = nullptr);
  ~Autosave() override;

  /// Where recovery files lie.
  [[nodiscard]] static QString defaultFolder();
  /// The files of programs that no longer run, the newest first.
  [[nodiscard]] static std::vector<Recoverable> findRecoverable(const QString& folder);
  static void discard(const Recoverable& left);

  /// Takes what was recovered over as its own: writes it again here before it removes what the crash left.
  void adopt(const Recoverable& left);
  /// Writes now if there is something unsaved that is not written yet.
  void saveNow();

 Q_SIGNALS:
  void autosaved();
  void failed(const QString& message);

 private:
  void removeOwn();

  DocumentModel& model_;
  ProjectFiles& files_;
  JobQueue& jobs_;
  QString path_;
  QLockFile lock_;
  QTimer timer_;
  bool dirty_ = false;  // edited since the last time
  std::optional<Recoverable> adopted_;
};

}  // namespace graftsman
