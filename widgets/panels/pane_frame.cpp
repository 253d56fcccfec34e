#include "widgets/panels/pane_frame.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/panels/elided_label.h"
#include "widgets/panels/problem_line.h"
#include "widgets/theme/contrast.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {

PaneFrame::PaneFrame(const QString& role, const QColor& colour, Viewport* viewport, QWidget* parent)
    : QWidget(parent), viewport_(viewport), colour_(colour) {
  setObjectName(QStringLiteral("paneFrame"));
  setAccessibleName(role);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header(role));
  column->addWidget(viewport_, 1);
  column->addWidget(footer(role));
  showRoleColour();
  showEnlarged();
}

QWidget* PaneFrame::header(const QString& role) {
  auto* bar = new QWidget(this);
  bar->setObjectName(QStringLiteral("paneHeader"));
  role_ = new QLabel(role, bar);
  role_->setObjectName(QStringLiteral("paneRole"));
  QFont bold = role_->font();
  bold.setBold(true);
  role_->setFont(bold);
  title_ = new ElidedLabel(bar);
  title_->setObjectName(QStringLiteral("paneTitle"));
  enlarge_ = new QToolButton(bar);
  enlarge_->setObjectName(QStringLiteral("enlarge"));
  enlarge_->setAccessibleName(QStringLiteral("Enlarge the pane %1").arg(role));
  enlarge_->setCheckable(true);
  enlarge_->setAutoRaise(true);
  enlarge_->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus in the pane
  connect(enlarge_, &QToolButton::toggled, this, [this](bool on) {
    showEnlarged();
    Q_EMIT enlargeToggled(on);
  });
  headerRow_ = new QHBoxLayout(bar);
  headerRow_->setContentsMargins(sizes::kGrid, sizes::kGrid / 2, sizes::kGrid / 2, sizes::kGrid / 2);
  headerRow_->setSpacing(sizes::kGrid);
  headerRow_->addWidget(role_);
  headerRow_->addWidget(title_, 1);
  headerRow_->addWidget(enlarge_);
  return bar;
}

QWidget* PaneFrame::footer(const QString& role) {
  auto* bar = new QWidget(this);
  bar->setObjectName(QStringLiteral("paneFooter"));
  line_ = new ProblemLine(bar);
  line_->setObjectName(QStringLiteral("paneLine"));
  remedy_ = new QPushButton(bar);
  remedy_->setObjectName(QStringLiteral("remedy"));
  plainTip_ = QStringLiteral("Mend what is wrong on the %1").arg(role.toLower());
  remedy_->hide();
  connect(remedy_, &QPushButton::clicked, this, &PaneFrame::remedyClicked);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(sizes::kGrid, sizes::kGrid / 2, sizes::kGrid, sizes::kGrid / 2);
  row->setSpacing(sizes::kGrid);
  row->addWidget(line_, 1);
  row->addWidget(remedy_);
  // As high as with the button, so that the pane keeps its size when a problem comes or goes.
  bar->setMinimumHeight(remedy_->sizeHint().height() + sizes::kGrid);
  return bar;
}

void PaneFrame::setTitle(const QString& title) {
  title_->setText(title);
}

void PaneFrame::setRoleColour(const QColor& colour) {
  colour_ = colour;
  showRoleColour();
}

void PaneFrame::setHint(const QString& hint) {
  line_->setHint(hint);
}

void PaneFrame::setProblem(const QString& problem, const QString& remedy, const QString& tip) {
  line_->setProblem(problem);
  remedy_->setText(remedy);
  remedy_->setToolTip(tip.isEmpty() ? plainTip_ : tip);
  remedy_->setAccessibleName(remedy);
  remedy_->setVisible(!problem.isEmpty() && !remedy.isEmpty());
}

void PaneFrame::addHeaderWidget(QWidget* widget) {
  headerRow_->insertWidget(headerRow_->indexOf(enlarge_), widget);
}

void PaneFrame::setEnlargeable(bool enlargeable) {
  enlarge_->setVisible(enlargeable);
}

void PaneFrame::setEnlarged(bool enlarged) {
  const QSignalBlocker blocker(enlarge_);
  enlarge_->setChecked(enlarged);
  showEnlarged();
}

void PaneFrame::showRoleColour() {
  const QColor text = palette().color(QPalette::WindowText);
  QPalette own = palette();
  own.setColor(QPalette::WindowText,
               colour_.isValid() ? legible(colour_, palette().color(QPalette::Window)) : text);
  role_->setPalette(own);
}

void PaneFrame::showEnlarged() {
  const bool enlarged = enlarge_->isChecked();
  enlarge_->setIcon(icon(enlarged ? QStringLiteral("shrink") : QStringLiteral("enlarge")));
  enlarge_->setToolTip(enlarged ? QStringLiteral("Show the panes side by side again")
                                : QStringLiteral("Let this pane fill the window"));
}

void PaneFrame::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    showRoleColour();
  }
  QWidget::changeEvent(event);
}

}  // namespace graftsman

#include "moc_pane_frame.cpp"  // NOLINT(bugprone-suspicious-include)
