#include "widgets/curve/fusion_curve_editor.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/curve/curve_edit.h"
#include "widgets/curve/curve_plot.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr double kDragDistance = 3;  // pixels that a click may shake
constexpr double kFine = 0.1;        // of the pointer's way, with Ctrl
constexpr double kStep = 1e-3;       // a drag's values are multiples of it (of kFineStep with Ctrl)
constexpr double kFineStep = 1e-4;

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

const FCFPoint& pointOf(const FCF& curve, int point) {
  return curve.points()[static_cast<std::size_t>(point)];
}

int countOf(const FCF& curve) {
  return static_cast<int>(curve.points().size());
}

// Why a point did not go where a number or a key wanted it.
QString refusal(const FCF& curve, int point, const FCFPoint& wanted) {
  const QLocale locale;
  const AllowedS allowed = allowedS(curve, point);
  if (wanted.s != pointOf(curve, point).s) {
    if (point == 0) {
      return QStringLiteral("The first point stays at the seam, s = 0; only its f can change.");
    }
    if (point == countOf(curve) - 1) {
      return QStringLiteral("The last point stays at the centre, s = 1; only its f can change.");
    }
    if (wanted.s < allowed.from || wanted.s > allowed.to) {
      return QStringLiteral("Point %1 stays between its neighbours: s from %2 to %3.")
          .arg(point)
          .arg(locale.toString(allowed.from, 'f', 3), locale.toString(allowed.to, 'f', 3));
    }
  }
  return QStringLiteral("f stays between 0 (the base) and 1 (the part).");
}

}  // namespace

FusionCurveEditor::FusionCurveEditor(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("fusionCurveEditor"));
  setAccessibleName(QStringLiteral("Fusion curve"));
  setToolTip(QStringLiteral(
      "How the surface turns from the base (0) into the part (1) between the seam and the centre.\n"
      "Drag a point; Shift keeps it straight, Ctrl moves it finely. Double-click or Insert adds a point,\n"
      "Delete removes it, arrow keys move it, Page Up and Page Down select, Esc takes a move back."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  tellShown();
}

void FusionCurveEditor::setCurve(const FCF& curve) {
  if (curve == curve_) {
    return;
  }
  move_.reset();
  hovered_ = -1;
  curve_ = curve;
  selected_ = selected_ < countOf(curve_) ? selected_ : -1;
  tellShown();
}

void FusionCurveEditor::setHistogram(std::span<const double> s) {
  histogram_ = histogramOf(s);
  update();
}

void FusionCurveEditor::selectPoint(int point) {
  point = std::clamp(point, -1, countOf(curve_) - 1);
  if (point == selected_) {
    return;
  }
  endMove();
  selected_ = point;
  tellShown();
  Q_EMIT selectionChanged(point);
}

void FusionCurveEditor::movePoint(int point, const FCFPoint& wanted) {
  endMove();
  const FCF result = withPointMoved(curve_, point, wanted);
  const QString why = pointOf(result, point) == wanted ? QString() : refusal(curve_, point, wanted);
  if (!(result == curve_)) {
    startMove(point);
    showMoved(result);
    endMove();
  }
  if (!why.isEmpty()) {
    Q_EMIT refused(why);
  }
}

QPointF FusionCurveEditor::position(const FCFPoint& point) const {
  return plotIn(size(), font()).toWidget(point);
}

QSize FusionCurveEditor::sizeHint() const {
  return minimumSizeHint().expandedTo({360, 260});
}

QSize FusionCurveEditor::minimumSizeHint() const {
  return leastPlotSize(font());
}

void FusionCurveEditor::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const bool moving = move_ && move_->started;
  paintCurve(painter, plotIn(size(), font()),
             {.curve = curve_,
              .histogram = histogram_,
              .selected = selected_,
              .hovered = hovered_,
              .moving = moving ? move_->point : -1,
              .guide = moving && !move_->byKeys ? std::nullopt : guide_,
              .focused = hasFocus(),
              .enabled = isEnabled()},
             palette());
}

int FusionCurveEditor::pointAt(const QPointF& at) const {
  const CurvePlot plot = plotIn(size(), font());
  int nearest = -1;
  double least = std::pow(sizes::kHitArea / 2.0 + 1, 2);
  for (int i = 0; i < countOf(curve_); ++i) {
    const QPointF way = plot.toWidget(pointOf(curve_, i)) - at;
    const double distance = QPointF::dotProduct(way, way);
    if (distance < least || (distance == least && i == selected_)) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

void FusionCurveEditor::press(int point, const QPointF& at) {
  endMove();
  selectPoint(point);
  if (point >= 0) {
    move_ =
        Move{.point = point, .before = curve_, .target = pointOf(curve_, point), .pressed = at, .last = at};
  }
}

void FusionCurveEditor::drag(const QPointF& to, Qt::KeyboardModifiers modifiers) {
  if (!move_->started) {
    if ((to - move_->pressed).manhattanLength() < kDragDistance) {
      return;
    }
    move_->started = true;
    Q_EMIT moveStarted(move_->point);
    if (!move_) {
      return;  // whoever heard of it set another curve
    }
  }
  const bool fine = modifiers.testFlag(Qt::ControlModifier);
  const CurvePlot plot = plotIn(size(), font());
  const QPointF way = (to - move_->last) * (fine ? kFine : 1);
  move_->last = to;
  move_->target.s += way.x() / plot.area.width();
  move_->target.f -= way.y() / plot.area.height();

  const FCFPoint& from = pointOf(move_->before, move_->point);
  FCFPoint wanted = move_->target;
  if (modifiers.testFlag(Qt::ShiftModifier)) {
    const bool along =
        std::abs(wanted.s - from.s) * plot.area.width() > std::abs(wanted.f - from.f) * plot.area.height();
    (along ? wanted.f : wanted.s) = along ? from.f : from.s;
  }
  // No digits that nobody meant; an axis along which nothing moved keeps its very value.
  const double step = fine ? kFineStep : kStep;
  wanted.s = wanted.s == from.s ? from.s : rounded(wanted.s, step);
  wanted.f = wanted.f == from.f ? from.f : rounded(wanted.f, step);
  showMoved(withPointMoved(curve_, move_->point, wanted));
}

void FusionCurveEditor::nudge(double s, double f) {
  if (selected_ < 0) {
    selectPoint(0);
    return;
  }
  if (move_ && !move_->byKeys) {
    return;
  }
  const FCFPoint& from = pointOf(curve_, selected_);
  // Sums of 0.01 stay what they read as: 0.35, not 0.35000000000000003.
  const auto sum = [](double value, double by) { return by == 0 ? value : rounded(value + by, 1e-6); };
  const FCFPoint wanted{sum(from.s, s), sum(from.f, f)};
  const FCF result = withPointMoved(curve_, selected_, wanted);
  if (result == curve_) {
    Q_EMIT refused(refusal(curve_, selected_, wanted));
    return;
  }
  if (!move_) {
    startMove(selected_);
  }
  showMoved(result);
}

void FusionCurveEditor::startMove(int point) {
  Move move;
  move.point = point;
  move.before = curve_;
  move.byKeys = true;
  move.started = true;
  move_ = move;
  Q_EMIT moveStarted(point);
}

void FusionCurveEditor::showMoved(const FCF& curve) {
  if (!move_ || curve == curve_) {
    return;
  }
  curve_ = curve;
  tellShown();
  Q_EMIT moved(move_->point, curve);
}

bool FusionCurveEditor::addPoint(const FCFPoint& at) {
  endMove();
  const auto added = withPointAdded(curve_, at);
  if (!added) {
    Q_EMIT refused(added.error());
    return false;
  }
  curve_ = added->curve;
  selected_ = added->point;
  tellShown();
  Q_EMIT pointAdded(added->point, added->curve);
  Q_EMIT selectionChanged(selected_);
  return true;
}

void FusionCurveEditor::addPointAfterSelected() {
  const int left = std::clamp(selected_, 0, countOf(curve_) - 2);
  const double s = rounded((pointOf(curve_, left).s + pointOf(curve_, left + 1).s) / 2, kFineStep);
  addPoint({s, rounded(curve_(s), kFineStep)});
}

void FusionCurveEditor::removeSelectedPoint() {
  endMove();
  const int point = selected_;
  const auto result = withPointRemoved(curve_, point);
  if (!result) {
    Q_EMIT refused(result.error());
    return;
  }
  curve_ = *result;
  selected_ = std::min(point, countOf(curve_) - 2);  // an inner one again: Delete goes on
  hovered_ = -1;
  tellShown();
  Q_EMIT pointRemoved(point, *result);
  Q_EMIT selectionChanged(selected_);
}

void FusionCurveEditor::endMove() {
  if (const std::optional<Move> move = std::exchange(move_, std::nullopt); move && move->started) {
    update();
    Q_EMIT moveFinished(move->point);
  }
}

void FusionCurveEditor::cancelMove() {
  if (const std::optional<Move> move = std::exchange(move_, std::nullopt); move && move->started) {
    curve_ = move->before;
    tellShown();
    Q_EMIT moveCancelled(move->point);
  }
}

void FusionCurveEditor::hover(const QPointF& at) {
  const CurvePlot plot = plotIn(size(), font());
  constexpr double kAround = sizes::kHitArea / 2.0;
  const int moving = move_ && !move_->byKeys ? move_->point : -1;
  const int point = moving >= 0 ? moving : pointAt(at);
  if (point < 0 && !plot.area.adjusted(-kAround, -kAround, kAround, kAround).contains(at)) {
    leave();
    return;
  }
  const double s = point >= 0 ? pointOf(curve_, point).s : std::clamp(plot.toCurve(at).s, 0.0, 1.0);
  setCursor(point >= 0 ? Qt::SizeAllCursor : Qt::CrossCursor);
  hovered_ = point;
  update();
  if (guide_ != s) {
    guide_ = s;
    Q_EMIT sHovered(s);
  }
}

void FusionCurveEditor::leave() {
  hovered_ = -1;
  unsetCursor();
  update();
  if (guide_) {
    guide_.reset();
    Q_EMIT sHovered(-1);
  }
}

void FusionCurveEditor::tellShown() {
  const QLocale locale;
  const QString count = QStringLiteral("%1 points").arg(countOf(curve_));
  if (selected_ < 0) {
    setAccessibleDescription(count + QStringLiteral(", none selected"));
  } else {
    const FCFPoint& point = pointOf(curve_, selected_);
    setAccessibleDescription(QStringLiteral("%1, point %2 selected: s %3, f %4")
                                 .arg(count)
                                 .arg(selected_)
                                 .arg(locale.toString(point.s, 'f', 3), locale.toString(point.f, 'f', 3)));
  }
  update();
  Q_EMIT shownChanged();
}

}  // namespace graftsman

#include "moc_fusion_curve_editor.cpp"  // NOLINT(bugprone-suspicious-include)
