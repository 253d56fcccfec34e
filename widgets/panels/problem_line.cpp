#include "widgets/panels/problem_line.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

#include "widgets/theme/contrast.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {

ProblemLine::ProblemLine(QWidget* parent)
    : QWidget(parent), icon_(new QLabel(this)), text_(new QLabel(this)) {
  setObjectName(QStringLiteral("problemLine"));
  icon_->setObjectName(QStringLiteral("problemIcon"));
  icon_->setAccessibleName(QStringLiteral("Problem"));
  text_->setObjectName(QStringLiteral("problemText"));
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(sizes::kGrid - 2);
  row->addWidget(icon_, 0, Qt::AlignTop);
  row->addWidget(text_, 1);
  showText();
}

void ProblemLine::setHint(const QString& hint) {
  hint_ = hint;
  showText();
}

void ProblemLine::setProblem(const QString& problem) {
  if (problem != problem_) {
    problem_ = problem;
    showText();
  }
}

void ProblemLine::showText() {
  const bool wrong = !problem_.isEmpty();
  text_->setText(wrong ? problem_ : hint_);
  text_->setAccessibleName(wrong ? QStringLiteral("Problem: ") + problem_ : hint_);
  icon_->setVisible(wrong);
  showColours();
}

void ProblemLine::showColours() {
  const QColor window = palette().color(QPalette::Window);
  const QColor text = palette().color(QPalette::WindowText);
  const QColor problem = legible(themeFor(palette()).problem, window);
  QPalette own = palette();
  own.setColor(QPalette::WindowText,
               problem_.isEmpty() ? legible(mixed(text, window, 0.35), window) : problem);
  text_->setPalette(own);
  const int side = fontMetrics().height();
  icon_->setPixmap(icon(QStringLiteral("problem"), problem).pixmap(QSize(side, side), devicePixelRatioF()));
}

void ProblemLine::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    showColours();
  }
  QWidget::changeEvent(event);
}

}  // namespace graftsman

#include "moc_problem_line.cpp"  // NOLINT(bugprone-suspicious-include)
