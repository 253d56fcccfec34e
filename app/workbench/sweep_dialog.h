#pragma once

#include <QDialog>
#include <optional>

#include "app/document/document_model.h"
#include "app/workbench/sweep_runner.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace graftsman {

class ProblemLine;
class SweepForm;

/// "Sweep": values are chosen, all combinations of them computed, and the results become variants, in one
/// step of history; files of them on demand. The window stays usable meanwhile; a run goes on when the dialog
/// is closed, with the inputs that it was started with.
class SweepDialog : public QDialog {
  Q_OBJECT

 public:
  /// More variants than anybody looks at; graftsman-cli makes as many files as one likes.
  static constexpr std::size_t kMostResults = 1000;

  explicit SweepDialog(DocumentModel& model, QWidget* parent = nullptr);

  [[nodiscard]] bool busy() const { return runner_->busy(); }
  /// Stops the run; what is done becomes variants.
  void cancel();
  /// Stops the run; nothing comes of it.
  void abandon();
  /// Files of the results do not go over this one.
  void setProjectPath(const QString& path) { projectPath_ = path; }

 Q_SIGNALS:
  void busyChanged(bool busy);
  /// A sentence for the status bar.
  void told(const QString& message);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  [[nodiscard]] QLayout* folderLines();
  [[nodiscard]] QLayout* runLines();
  void refreshSoon();
  void refresh();
  void showChoice();
  [[nodiscard]] Result<SweepPlan> chosen() const;
  void askFolder();
  void run();
  void start(SweepPlan plan);
  void showRunning();
  void finish(const SweepOutcome& outcome);
  void keepVariants();

  DocumentModel& model_;
  SweepRunner* runner_;
  SweepForm* form_;
  QLabel* count_ = nullptr;
  ProblemLine* problem_ = nullptr;
  QCheckBox* files_ = nullptr;
  QLineEdit* folder_ = nullptr;
  QPushButton* browse_ = nullptr;
  QComboBox* format_ = nullptr;
  QCheckBox* pictures_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QLabel* summary_ = nullptr;
  QTreeWidget* failures_ = nullptr;
  QPushButton* run_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QString projectPath_;
  std::optional<SweepOutcome> kept_;  // to become variants once a drag under way is over
  bool refreshing_ = false;
};

}  // namespace graftsman
