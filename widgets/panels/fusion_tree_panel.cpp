#include "widgets/panels/fusion_tree_panel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QTreeView>
#include <QVBoxLayout>
#include <functional>
#include <utility>

#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

FusionId shownOf(const std::vector<FusionRow>& rows) {
  for (const FusionRow& row : rows) {
    const FusionId shown = row.shown ? row.fusion : shownOf(row.rows);
    if (shown != 0) {
      return shown;
    }
  }
  return 0;
}

}  // namespace

FusionTreePanel::FusionTreePanel(QWidget* parent)
    : QWidget(parent), model_(new FusionTreeModel(this)), view_(new QTreeView(this)) {
  setObjectName(QStringLiteral("fusionsPanel"));
  setAccessibleName(QStringLiteral("Fusions"));
  makeView();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(sizes::kGrid, sizes::kGrid, sizes::kGrid, sizes::kGrid);
  column->addWidget(view_);
  connect(model_, &FusionTreeModel::renameWanted, this, &FusionTreePanel::renameWanted);
  connect(model_, &QAbstractItemModel::rowsInserted, view_,
          [this](const QModelIndex& above, int first, int last) {
            view_->expand(above);
            for (int row = first; row <= last; ++row) {
              view_->expandRecursively(model_->index(row, 0, above));
            }
          });
  connect(view_, &QTreeView::clicked, this, &FusionTreePanel::wantShown);
  connect(view_, &QTreeView::activated, this, &FusionTreePanel::wantShown);
  connect(view_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
    Q_EMIT contextMenuWanted(fusionAt(view_->indexAt(at)), view_->viewport()->mapToGlobal(at));
  });
}

void FusionTreePanel::makeView() {
  view_->setObjectName(QStringLiteral("fusionsView"));
  view_->setAccessibleName(QStringLiteral("Fusions"));
  view_->setToolTip(
      QStringLiteral("The fusions of the project, each with its part and base. A click shows one, F2 names "
                     "it, Delete removes it"));
  view_->setModel(model_);
  view_->setHeaderHidden(true);
  view_->setUniformRowHeights(true);
  view_->setAllColumnsShowFocus(true);
  view_->setExpandsOnDoubleClick(false);
  view_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->setTextElideMode(Qt::ElideMiddle);
  view_->setIndentation(sizes::kGrid * 2);
  view_->setIconSize({sizes::kGrid * 2, sizes::kGrid * 2});
  QHeaderView* header = view_->header();
  header->setStretchLastSection(false);
  header->setSectionResizeMode(FusionTreeModel::Name, QHeaderView::Stretch);
  header->setSectionResizeMode(FusionTreeModel::What, QHeaderView::ResizeToContents);
  view_->installEventFilter(this);
}

void FusionTreePanel::setRows(std::vector<FusionRow> rows) {
  const FusionId shown = shownOf(rows);
  const bool another = std::exchange(shown_, shown) != shown;
  model_->setRows(std::move(rows));
  const QModelIndex current = view_->currentIndex();
  if ((another || !current.isValid()) && fusionAt(current) != shown) {
    view_->setCurrentIndex(model_->find(shown));
  }
}

void FusionTreePanel::editName(FusionId fusion) {
  const QModelIndex current = view_->currentIndex().siblingAtColumn(FusionTreeModel::Name);
  const QModelIndex index = fusionAt(current) == fusion ? current : model_->find(fusion);
  view_->setCurrentIndex(index);
  view_->setFocus();
  view_->edit(index);
}

FusionId FusionTreePanel::fusionAt(const QModelIndex& index) const {
  return index.isValid() ? model_->row(index).fusion : 0;
}

void FusionTreePanel::wantShown(const QModelIndex& index) {
  if (const FusionId fusion = fusionAt(index); fusion != 0 && fusion != shown_) {
    Q_EMIT showWanted(fusion);
  }
}

// The tree's own keys come before the window's shortcuts.
bool FusionTreePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool plain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    const bool removes = plain && (key.key() == Qt::Key_Delete || key.key() == Qt::Key_Backspace);
    if (removes || (plain && key.key() == Qt::Key_F2)) {
      event->accept();
    }
    if (event->type() == QEvent::KeyPress && removes) {
      if (const FusionId fusion = fusionAt(view_->currentIndex()); fusion != 0) {
        Q_EMIT removeWanted(fusion);
      }
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace graftsman

#include "moc_fusion_tree_panel.cpp"  // NOLINT(bugprone-suspicious-include)
