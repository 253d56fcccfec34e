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
class FusionCurveEditor : public QWidget {
  Q_OBJECT

 public:
  explicit FusionCurveEditor(QWidget* parent = nullptr);

  [[nodiscard]] const FCF& curve() const { return curve_; }
  /// Shows `curve` without any signal. A drag under way is ended if the curve is another one than the drag's.
  void setCurve(const FCF& curve);
  /// s of the combined tile's vertices, each in [0, 1]: drawn as a histogram behind the curve. Empty: none.
  void setHistogram(std::span<const double> s);

  /// The selected point, −1: none.
  [[nodiscard]] int selectedPoint() const { return selected_; }
  void selectPoint(int point);

  /// Where the curve's point (s, f) is drawn, in the widget's coordinates (for tests).
  [[nodiscard]] QPointF position(const FCFPoint& point) const;

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
  /// s under the pointer, negative when it leaves.
  void sHovered(double s);
  /// A wish that core refused, in a person's words ("The first point stays at the seam, s = 0").
  void refused(const QString& why);

 private:
  FCF curve_;
  int selected_ = -1;
};

}  // namespace graftsman
