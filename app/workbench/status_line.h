#pragma once

#include <QStatusBar>
#include <optional>

class QLabel;
class QProgressBar;
class QToolButton;

namespace graftsman {

class ElidedLabel;
struct Outcome;
struct RunProgress;

/// The status bar: what runs, how far it is, Cancel; and at the right what the result is like.
class StatusLine : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusLine(QWidget* parent = nullptr);

  void showRun(const RunProgress& progress);
  void showJob(const QString& what, double done);
  void showIdle();
  /// "12,425 vertices · 8 ms".
  void showOutcome(const Outcome& outcome);
  /// "saved", "not saved"; nothing: there is nothing to save.
  void showSaved(std::optional<bool> saved);
  /// A sentence that is worth reading; stays until something else happens.
  void tell(const QString& message);
  /// The same for what went wrong, with an icon.
  void warn(const QString& message);

 Q_SIGNALS:
  void cancelWanted();

 private:
  void showProgress(const QString& what, double done);
  void showMessage(const QString& message, bool problem);

  QLabel* icon_ = nullptr;
  ElidedLabel* message_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QToolButton* cancel_ = nullptr;
  QLabel* facts_ = nullptr;
  QLabel* saved_ = nullptr;
  bool messageIsProgress_ = false;
  QString time_;  // of the last run that computed something
};

/// "Fusing: embedding the base's tile": what a stage does, in a designer's words.
[[nodiscard]] QString describe(const RunProgress& progress);

}  // namespace graftsman
