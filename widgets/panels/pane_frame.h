#pragma once

#include <QColor>
#include <QWidget>

class QBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace graftsman {

class ElidedLabel;
class ProblemLine;
class Viewport;

/// A pane with its header ("Part  penguin.obj · 6,720 faces", a button that enlarges it) and its footer: what
/// to do next, or what is wrong, with a button for the remedy.
class PaneFrame : public QWidget {
  Q_OBJECT

 public:
  /// Takes the viewport as its child. `role` ("Part") is shown in bold, in `colour` (invalid: the text's),
  /// made darker or lighter until it can be read.
  PaneFrame(const QString& role, const QColor& colour, Viewport* viewport, QWidget* parent = nullptr);

  [[nodiscard]] Viewport* viewport() const { return viewport_; }
  void setTitle(const QString& title);
  void setRoleColour(const QColor& colour);
  /// A quiet sentence in the footer.
  void setHint(const QString& hint);
  /// What is wrong, with an icon; `remedy` is the text of the button beside it, empty: none; `tip` the
  /// button's tooltip. Empty: nothing is wrong, the hint shows again.
  void setProblem(const QString& problem, const QString& remedy, const QString& tip = {});
  /// A widget at the header's right end (the result's colour box).
  void addHeaderWidget(QWidget* widget);
  /// Whether there is a button that enlarges the pane (at first there is).
  void setEnlargeable(bool enlargeable);
  /// Shows the button pressed or not, without a signal.
  void setEnlarged(bool enlarged);

 Q_SIGNALS:
  void enlargeToggled(bool enlarged);
  void remedyClicked();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QWidget* header(const QString& role);
  [[nodiscard]] QWidget* footer(const QString& role);
  void showRoleColour();
  void showEnlarged();

  Viewport* viewport_ = nullptr;
  QColor colour_;
  QBoxLayout* headerRow_ = nullptr;
  QLabel* role_ = nullptr;
  ElidedLabel* title_ = nullptr;
  QToolButton* enlarge_ = nullptr;
  ProblemLine* line_ = nullptr;
  QPushButton* remedy_ = nullptr;
  QString plainTip_;  // of the remedy that has none of its own
};

}  // namespace graftsman
