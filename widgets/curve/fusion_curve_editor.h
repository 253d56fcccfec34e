#pragma once

#include <QWidget>
#include <optional>
#include <span>
#include <vector>

#include "core/fusion/fcf.h"

namespace graftsman {

/// The fusion curve f(s) to look at and to shape (INTERFACE.md, Fusion mode). What is legal is decided by
/// core (FCF::through); the editor proposes only curves that are, and keeps a dragged point within what is
/// allowed. Knows no document: it shows each change at once and tells of it; whoever owns the curve sets it
/// by setCurve().
///
/// Mouse: drag a point (Shift: straight up or along; Ctrl: a tenth as fast), double-click for another point.
/// Keys: Page Up, Page Down, Home, End select; arrows move by 0.01 (Shift 0.1, Ctrl 0.001); Insert adds a
/// point after the selected one, Delete and Backspace remove it; Esc takes a move back.
class FusionCurveEditor : public QWidget {
  Q_OBJECT

 public:
  explicit FusionCurveEditor(QWidget* parent = nullptr);

  [[nodiscard]] const FCF& curve() const { return curve_; }
  /// Shows `curve` without any signal but shownChanged(). A drag under way is ended if the curve is another
  /// one than the drag's.
  void setCurve(const FCF& curve);
  /// s of the combined tile's vertices, each in [0, 1]: drawn as a histogram behind the curve. Empty: none.
  void setHistogram(std::span<const double> s);

  /// The selected point, −1: none.
  [[nodiscard]] int selectedPoint() const { return selected_; }
  /// Tells selectionChanged() if it is another one.
  void selectPoint(int point);
  /// A whole move of that point, told as one (for numbers that are typed in). Where it may not go to
  /// `wanted`, it goes as near as is allowed, and refused() says so.
  void movePoint(int point, const FCFPoint& wanted);

  /// Where the curve's point (s, f) is drawn, in the widget's coordinates (for tests).
  [[nodiscard]] QPointF position(const FCFPoint& point) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// A drag, or a run of arrow keys, on a point: started once, moved with each new curve, then finished or
  /// (Esc) cancelled. Cancelled: the curve is again what it was at the start.
  void moveStarted(int point);
  void moved(int point, const graftsman::FCF& curve);
  void moveFinished(int point);
  void moveCancelled(int point);
  void pointAdded(int point, const graftsman::FCF& curve);
  void pointRemoved(int point, const graftsman::FCF& curve);
  void selectionChanged(int point);
  /// s under the pointer (on a point: the point's), negative when it leaves.
  void sHovered(double s);
  /// A wish that core refused, in a person's words ("The first point stays at the seam, s = 0").
  void refused(const QString& why);
  /// The curve or the selection shown is another one, by whatever way (for what shows their numbers).
  void shownChanged();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// A drag or a run of keys under way.
  struct Move {
    int point = 0;
    FCF before;
    bool byKeys = false;
    bool started = false;  // a press moves nothing until the pointer went a little way
    FCFPoint target;       // where the pointer wants it, perhaps not allowed
    QPointF pressed;
    QPointF last;  // of the pointer
  };

  [[nodiscard]] int pointAt(const QPointF& at) const;
  void press(int point, const QPointF& at);
  void drag(const QPointF& to, Qt::KeyboardModifiers modifiers);
  void nudge(double s, double f);
  bool addPoint(const FCFPoint& at);  // false: refused
  void addPointAfterSelected();
  void removeSelectedPoint();
  void startMove(int point);         // by keys or numbers
  void showMoved(const FCF& curve);  // as part of the move under way
  void endMove();
  void cancelMove();
  void hover(const QPointF& at);
  void leave();
  void tellShown();

  FCF curve_;
  std::vector<double> histogram_;  // bar heights
  int selected_ = -1;
  int hovered_ = -1;
  std::optional<double> guide_;  // s under the pointer
  std::optional<Move> move_;
};

}  // namespace graftsman
