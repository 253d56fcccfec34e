#include "app/workbench/status_line.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>

#include "app/document/commands.h"
#include "app/document/stage_runner.h"
#include "widgets/panels/elided_label.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent),
      icon_(new QLabel),
      message_(new ElidedLabel),
      bar_(new QProgressBar),
      cancel_(new QToolButton),
      facts_(new QLabel),
      saved_(new QLabel) {
  setObjectName("statusLine");
  setSizeGripEnabled(false);
  setContentsMargins(sizes::kGrid, 0, sizes::kGrid, 0);
  icon_->setObjectName("statusIcon");
  icon_->setPixmap(icon("problem").pixmap(16));
  icon_->setAccessibleName(tr("Problem"));
  message_->setObjectName("statusMessage");
  message_->setContextMenuPolicy(Qt::ActionsContextMenu);
  auto* copy = new QAction(tr("Copy"), message_);
  copy->setObjectName("copyMessage");
  connect(copy, &QAction::triggered, this,
          [this] { QGuiApplication::clipboard()->setText(message_->text()); });
  message_->addAction(copy);
  bar_->setObjectName("statusProgress");
  bar_->setAccessibleName(tr("Progress"));
  bar_->setFixedWidth(160);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  cancel_->setObjectName("statusCancel");
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop what is being computed; nothing is lost (Ctrl+.)"));
  facts_->setObjectName("statusFacts");
  saved_->setObjectName("statusSaved");
  addWidget(icon_);
  addWidget(message_, 1);
  addWidget(bar_);
  addWidget(cancel_);
  addPermanentWidget(facts_);
  addPermanentWidget(saved_);
  connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancelWanted);
  icon_->hide();
  showIdle();
}

void StatusLine::showRun(const RunProgress& progress) {
  showProgress(describe(progress), progress.done);
}

void StatusLine::showJob(const QString& what, double done) {
  showProgress(what, done);
}

void StatusLine::showProgress(const QString& what, double done) {
  showMessage(what, false);
  messageIsProgress_ = true;
  bar_->setValue(static_cast<int>(done * bar_->maximum()));
  bar_->show();
  cancel_->show();
}

void StatusLine::showIdle() {
  if (messageIsProgress_) {
    tell({});
  }
  bar_->hide();
  cancel_->hide();
}

void StatusLine::showOutcome(const Outcome& outcome) {
  if (!outcome.results || !outcome.results->fused) {
    facts_->clear();
    return;
  }
  double milliseconds = 0;
  for (const StageRun& run : outcome.results->runs) {
    milliseconds += run.milliseconds;
  }
  if (milliseconds > 0) {  // otherwise everything was taken over: the time of the last run stands
    time_ = QLocale().toString(milliseconds, 'f', milliseconds < 10 ? 1 : 0);
  }
  facts_->setText(
      tr("%1 vertices · %2 ms").arg(QLocale().toString(outcome.results->fused->points.size()), time_));
}

void StatusLine::showSaved(std::optional<bool> saved) {
  saved_->setText(!saved ? QString() : *saved ? tr("saved") : tr("not saved"));
}

void StatusLine::tell(const QString& message) {
  showMessage(message, false);
}

void StatusLine::warn(const QString& message) {
  showMessage(message, true);
}

void StatusLine::showMessage(const QString& message, bool problem) {
  messageIsProgress_ = false;
  icon_->setVisible(problem);
  message_->setText(message);
  message_->setAccessibleName(problem ? tr("Problem: %1").arg(message) : tr("Status: %1").arg(message));
}

QString describe(const RunProgress& progress) {
  const auto of = [&](const QString& both, const QString& one) {
    return progress.side ? one.arg(label(*progress.side)) : both;
  };
  if (!progress.stage) {
    return StatusLine::tr("Finding the paths");
  }
  switch (*progress.stage) {
    case Stage::Anchor:
    case Stage::Paths:
      return of(StatusLine::tr("Finding the paths"), StatusLine::tr("Fusing: finding the %1's paths"));
    case Stage::Cut:
    case Stage::Tile:
      return of(StatusLine::tr("Cutting"), StatusLine::tr("Fusing: cutting the %1"));
    case Stage::Adjust:
    case Stage::Fit:
      return StatusLine::tr("Fusing: adjusting the part");
    case Stage::Embed:
      return of(StatusLine::tr("Embedding"), StatusLine::tr("Fusing: embedding the %1's tile"));
    case Stage::Overlay:
      return StatusLine::tr("Fusing: overlaying the tiles");
    case Stage::Join:
    case Stage::Blend:
      return StatusLine::tr("Fusing: joining");
  }
  return {};
}

}  // namespace graftsman
