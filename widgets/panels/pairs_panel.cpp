#include "widgets/panels/pairs_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/panels/flash.h"
#include "widgets/panels/pairs_model.h"
#include "widgets/panels/problem_line.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

bool removes(const QEvent& event) {
  const auto& key = static_cast<const QKeyEvent&>(event);
  return (key.key() == Qt::Key_Delete || key.key() == Qt::Key_Backspace) &&
         (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

}  // namespace

PairsPanel::PairsPanel(QWidget* parent)
    : QWidget(parent),
      model_(new PairsModel(this)),
      view_(new QTableView(this)),
      empty_(new QLabel(view_->viewport())),
      next_(new ProblemLine(this)) {
  setObjectName(QStringLiteral("pairsPanel"));
  setAccessibleName(QStringLiteral("Pairs"));
  next_->setObjectName(QStringLiteral("pairsNext"));
  makeView();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(sizes::kGrid, sizes::kGrid, sizes::kGrid, sizes::kGrid);
  column->setSpacing(sizes::kGrid);
  column->addWidget(view_, 1);
  column->addWidget(next_);

  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PairsPanel::tellSelection);
  const auto before = [this] { changingRows_ = true; };
  const auto after = [this] {
    changingRows_ = false;
    showEmptyState();
    tellSelection();
  };
  connect(model_, &QAbstractItemModel::rowsAboutToBeInserted, this, before);
  connect(model_, &QAbstractItemModel::rowsAboutToBeRemoved, this, before);
  connect(model_, &QAbstractItemModel::rowsInserted, this, after);
  connect(model_, &QAbstractItemModel::rowsRemoved, this, after);
  connect(model_, &QAbstractItemModel::dataChanged, this, &PairsPanel::showProblem);
  showEmptyState();
}

void PairsPanel::makeView() {
  view_->setObjectName(QStringLiteral("pairsView"));
  view_->setAccessibleName(QStringLiteral("Pairs"));
  view_->setToolTip(
      QStringLiteral("The pairs of the loop. Select pairs here or in the panes; Delete removes them"));
  view_->setModel(model_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setTabKeyNavigation(false);
  view_->setShowGrid(false);
  view_->setAlternatingRowColors(true);
  view_->setWordWrap(false);
  view_->setIconSize({12, 12});
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + sizes::kGrid);
  QHeaderView* header = view_->horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(sizes::kGrid * 4);
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(PairsModel::Problem, QHeaderView::Stretch);
  view_->installEventFilter(this);
  view_->viewport()->installEventFilter(this);

  empty_->setObjectName(QStringLiteral("pairsEmpty"));
  empty_->setText(QStringLiteral("Click a point on the part,\nthen its partner on the base"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setForegroundRole(QPalette::Text);
  empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
}

bool PairsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_->viewport() && event->type() == QEvent::Resize) {
    empty_->setGeometry(view_->viewport()->rect().adjusted(sizes::kGrid, 0, -sizes::kGrid, 0));
  }
  if (watched == view_ && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) &&
      removes(*event)) {
    event->accept();  // also before a shortcut of the window takes the key
    const QSet<int> rows = selectedRows();
    if (event->type() == QEvent::KeyPress && !rows.isEmpty()) {
      Q_EMIT removeWanted(rows);
    }
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void PairsPanel::setSelected(const QSet<int>& rows) {
  told_ = rows;
  if (rows == selectedRows()) {
    return;
  }
  QItemSelection selection;
  for (const int row : rows) {
    if (row >= 0 && row < model_->rowCount()) {
      selection.select(model_->index(row, 0), model_->index(row, PairsModel::ColumnCount - 1));
    }
  }
  const bool wasChanging = std::exchange(changingRows_, true);  // what follows is no person's doing
  view_->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  if (!selection.isEmpty()) {
    const int first = *std::min_element(rows.begin(), rows.end());
    view_->selectionModel()->setCurrentIndex(model_->index(std::max(first, 0), 0),
                                             QItemSelectionModel::NoUpdate);
    view_->scrollTo(model_->index(std::max(first, 0), 0));
  }
  changingRows_ = wasChanging;
  showProblem();
}

void PairsPanel::flashRow(int row) {
  view_->scrollTo(model_->index(row, 0));
  const QRect first = view_->visualRect(model_->index(row, 0));
  flash(*view_->viewport(), QRect(0, first.top(), view_->viewport()->width(), first.height()));
}

void PairsPanel::setNext(const QString& text) {
  next_->setHint(text);
}

QSet<int> PairsPanel::selectedRows() const {
  QSet<int> rows;
  for (const QModelIndex& index : view_->selectionModel()->selectedRows()) {
    rows.insert(index.row());
  }
  return rows;
}

void PairsPanel::tellSelection() {
  if (changingRows_) {
    return;
  }
  showProblem();
  QSet<int> rows = selectedRows();
  if (rows != told_) {
    told_ = rows;
    Q_EMIT selectionChanged(rows);
  }
}

void PairsPanel::showEmptyState() {
  empty_->setVisible(model_->rowCount() == 0);
}

void PairsPanel::showProblem() {
  QString problem;
  int of = model_->rowCount();
  for (const int row : selectedRows()) {
    const QString& its = model_->rows()[static_cast<std::size_t>(row)].problem;
    if (row < of && !its.isEmpty()) {
      of = row;
      problem = its;
    }
  }
  next_->setProblem(problem);
}

}  // namespace graftsman

#include "moc_pairs_panel.cpp"  // NOLINT(bugprone-suspicious-include)
