#include "widgets/panels/stages_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

enum Column { StageColumn, StateColumn, TimeColumn, ColumnCount };

// In the order of Stage.
constexpr std::array<const char*, kStageCount> kTexts = {
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Points on the surface"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Paths"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Cut"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Tiles"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Adjustment"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Fit to the boundary"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Embedding"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Overlay"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Join"),
    QT_TRANSLATE_NOOP("graftsman::StagesPanel", "Blend")};

// Whether the results have what the stage makes (of both meshes).
bool made(const FusionResults& results, Stage stage) {
  const SideResults& part = results.part;
  const SideResults& base = results.base;
  switch (stage) {
    case Stage::Anchor:
      return part.anchored && base.anchored;
    case Stage::Paths:
      return part.paths && base.paths;
    case Stage::Cut:
      return part.cut && base.cut;
    case Stage::Tile:
      return part.tile && base.tile;
    case Stage::Adjust:
      return results.adjustment != nullptr;
    case Stage::Fit:
      return results.fitted != nullptr;
    case Stage::Embed:
      return part.embedding && base.embedding;
    case Stage::Overlay:
      return results.combined != nullptr;
    case Stage::Join:
      return results.join != nullptr;
    case Stage::Blend:
      return results.fused != nullptr;
  }
  return false;
}

}  // namespace

StagesPanel::StagesPanel(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(kStageCount, ColumnCount)) {
  setObjectName("stagesPanel");
  setAccessibleName(tr("Stages"));
  table_->setObjectName("stagesTable");
  table_->setAccessibleName(tr("Stages"));
  table_->setHorizontalHeaderLabels({tr("Stage"), tr("State"), tr("Time")});
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + sizes::kGrid / 2);
  table_->horizontalHeader()->setSectionResizeMode(StageColumn, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(StateColumn, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(TimeColumn, QHeaderView::ResizeToContents);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);
  for (int row = 0; row < kStageCount; ++row) {
    for (int column = 0; column < ColumnCount; ++column) {
      table_->setItem(row, column, new QTableWidgetItem);
    }
    table_->item(row, StageColumn)->setText(tr(kTexts[static_cast<std::size_t>(row)]));
    table_->item(row, TimeColumn)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(sizes::kGrid, sizes::kGrid, sizes::kGrid, sizes::kGrid);
  layout->addWidget(table_);
  showAll();
}

void StagesPanel::setResults(const FusionResults& results) {
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    const StageRun& run = results.run(stage);
    const bool failed = results.error && results.failedAt == stage;
    rows_[static_cast<std::size_t>(i)] = {
        failed                  ? State::Failed
        : !made(results, stage) ? State::NotReached
        : run.ran               ? State::Ran
                                : State::Reused,
        run.milliseconds, failed ? QString::fromStdString(results.error->message) : QString()};
  }
  showAll();
}

void StagesPanel::setRunning(std::optional<Stage> stage) {
  const std::optional<Stage> before = std::exchange(running_, stage);
  for (const auto& changed : {before, stage}) {
    if (changed && before != stage) {
      show(*changed);
    }
  }
}

void StagesPanel::clear() {
  rows_ = {};
  showAll();
}

void StagesPanel::showAll() {
  for (int i = 0; i < kStageCount; ++i) {
    show(static_cast<Stage>(i));
  }
}

void StagesPanel::show(Stage stage) {
  const int row = static_cast<int>(stage);
  const Row& shown = rows_[static_cast<std::size_t>(row)];
  QTableWidgetItem* state = table_->item(row, StateColumn);
  const auto say = [&](const QString& text, const char* iconName) {
    state->setText(text);
    state->setIcon(icon(iconName));
  };
  if (running_ == stage) {
    say(tr("running"), "run");
  } else {
    switch (shown.state) {
      case State::NotReached:
        say(tr("not reached"), "");
        break;
      case State::Ran:
        say(tr("ran"), "ok");
        break;
      case State::Reused:
        say(tr("reused"), "redo");
        break;
      case State::Failed:
        state->setText(tr("failed"));
        state->setIcon(icon("problem", themeFor(palette()).problem));
        break;
    }
  }
  state->setToolTip(shown.problem);
  table_->item(row, TimeColumn)
      ->setText(shown.milliseconds > 0 ? tr("%1 ms").arg(QLocale().toString(shown.milliseconds, 'f',
                                                                            shown.milliseconds < 10 ? 2 : 0))
                                       : QString());
}

}  // namespace graftsman
