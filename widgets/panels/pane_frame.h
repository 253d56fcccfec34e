#pragma once

#include <QWidget>

class QLabel;
class QToolButton;

namespace graftsman {

class Viewport;

/// A pane with its header ("Part  penguin.obj · 6,720 faces", a button that enlarges it) and its footer: what
/// to do next, or what is wrong, with a button for the remedy.
class PaneFrame : public QWidget {
  Q_OBJECT

 public:
  /// Takes the viewport as its child. `role` ("Part") is shown in bold, in `colour`.
  PaneFrame(const QString& role, const QColor& colour, Viewport* viewport, QWidget* parent = nullptr);

  [[nodiscard]] Viewport* viewport() const { return viewport_; }
  void setTitle(const QString& title);
  void setRoleColour(const QColor& colour);
  /// A quiet sentence in the footer.
  void setHint(const QString& hint);
  /// What is wrong, with an icon; `remedy` is the text of the button beside it, empty: none. Empty: nothing
  /// is wrong, the hint shows again.
  void setProblem(const QString& problem, const QString& remedy);
  /// A widget at the header's right end (the result's colour box).
  void addHeaderWidget(QWidget* widget);

 Q_SIGNALS:
  void enlargeToggled(bool enlarged);
  void remedyClicked();

 private:
  Viewport* viewport_ = nullptr;
};

}  // namespace graftsman
