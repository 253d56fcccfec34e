#pragma once

#include <QWidget>

class QLabel;

namespace graftsman {

/// A line that tells a problem, with an icon, or else a quiet hint. Wraps.
class ProblemLine : public QWidget {
  Q_OBJECT

 public:
  explicit ProblemLine(QWidget* parent = nullptr);

  void setHint(const QString& hint);
  /// Empty: none, the hint shows again.
  void setProblem(const QString& problem);
  [[nodiscard]] const QString& problem() const { return problem_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showText();
  void showColours();

  QLabel* icon_ = nullptr;
  QLabel* text_ = nullptr;
  QString hint_;
  QString problem_;
};

}  // namespace graftsman
