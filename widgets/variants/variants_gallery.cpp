#include "widgets/variants/variants_gallery.h"

#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPixmapCache>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/panels/elided_label.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"
#include "widgets/variants/variant_delegate.h"
#include "widgets/variants/variants_filter.h"
#include "widgets/variants/variants_model.h"

namespace graftsman {
namespace {

// Room for the scaled pictures of some hundred variants.
constexpr int kPixmapCacheKb = 64 * 1024;

int idOf(const QModelIndex& index) {
  return index.data(VariantsModel::Id).toInt();
}

}  // namespace

VariantsGallery::VariantsGallery(QWidget* parent)
    : QWidget(parent),
      model_(new VariantsModel(this)),
      filter_(new VariantsFilter(this)),
      view_(new QListView(this)),
      delegate_(new VariantDelegate(this)) {
  setObjectName(QStringLiteral("variantsGallery"));
  setAccessibleName(tr("Variants"));
  QPixmapCache::setCacheLimit(std::max(QPixmapCache::cacheLimit(), kPixmapCacheKb));
  filter_->setSourceModel(model_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeHeader());
  makeView();
  column->addWidget(view_, 1);
  column->addWidget(makeFooter());
  connectView();
  showCount();
  showSelection();
}

QWidget* VariantsGallery::makeHeader() {
  auto* bar = new QWidget(this);
  bar->setObjectName(QStringLiteral("variantsHeader"));
  auto* title = new QLabel(tr("Variants"), bar);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  count_ = new QLabel(bar);
  count_->setObjectName(QStringLiteral("variantsCount"));
  words_ = new QLineEdit(bar);
  words_->setObjectName(QStringLiteral("variantsWords"));
  words_->setAccessibleName(tr("Find variants"));
  words_->setPlaceholderText(tr("Find in names and notes"));
  words_->setToolTip(tr("Show the variants whose name or note has these words"));
  words_->setClearButtonEnabled(true);
  words_->setMaximumWidth(28 * sizes::kGrid);
  starred_ = new QToolButton(bar);
  starred_->setObjectName(QStringLiteral("variantsStarred"));
  starred_->setAccessibleName(tr("Starred only"));
  starred_->setToolTip(tr("Show the starred variants alone"));
  starred_->setIcon(icon(QStringLiteral("star")));
  starred_->setCheckable(true);
  starred_->setAutoRaise(true);
  auto* order = new QComboBox(bar);
  order->setObjectName(QStringLiteral("variantsOrder"));
  order->setAccessibleName(tr("Order"));
  order->setToolTip(tr("In which order the variants are shown"));
  // In the order of VariantsFilter::Order.
  order->addItems({tr("As kept"), tr("Newest first"), tr("By name"), tr("Starred first")});

  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(sizes::kGrid, sizes::kGrid / 2, sizes::kGrid, sizes::kGrid / 2);
  row->setSpacing(sizes::kGrid);
  row->addWidget(title);
  row->addWidget(count_, 1);
  row->addWidget(words_, 1);
  row->addWidget(starred_);
  row->addWidget(order);
  connect(words_, &QLineEdit::textChanged, filter_, &VariantsFilter::setWords);
  connect(starred_, &QToolButton::toggled, this, [this](bool on) {
    starred_->setIcon(icon(on ? QStringLiteral("star-full") : QStringLiteral("star")));
    filter_->setStarredOnly(on);
  });
  connect(order, &QComboBox::currentIndexChanged, filter_,
          [this](int chosen) { filter_->setOrder(static_cast<VariantsFilter::Order>(chosen)); });
  return bar;
}

void VariantsGallery::makeView() {
  view_->setObjectName(QStringLiteral("variantsView"));
  view_->setAccessibleName(tr("Variants"));
  view_->setModel(filter_);
  view_->setItemDelegate(delegate_);
  view_->setViewMode(QListView::IconMode);
  view_->setMovement(QListView::Static);
  view_->setResizeMode(QListView::Adjust);
  view_->setUniformItemSizes(true);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  view_->setFrameShape(QFrame::NoFrame);
  view_->viewport()->setAttribute(Qt::WA_Hover);
  view_->installEventFilter(this);
  view_->viewport()->installEventFilter(this);

  empty_ = new QLabel(view_->viewport());
  empty_->setObjectName(QStringLiteral("variantsEmpty"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setForegroundRole(QPalette::Text);
  empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
}

QWidget* VariantsGallery::makeFooter() {
  auto* bar = new QWidget(this);
  bar->setObjectName(QStringLiteral("variantsFooter"));
  chosen_ = new ElidedLabel(bar);
  chosen_->setObjectName(QStringLiteral("variantsChosen"));
  note_ = new QLineEdit(bar);
  note_->setObjectName(QStringLiteral("variantNote"));
  note_->setAccessibleName(tr("Note"));
  note_->setPlaceholderText(tr("Note"));
  note_->setToolTip(tr("What is worth remembering about this variant"));
  footer_ = new QHBoxLayout(bar);
  footer_->setContentsMargins(sizes::kGrid, sizes::kGrid / 2, sizes::kGrid, sizes::kGrid / 2);
  footer_->setSpacing(sizes::kGrid);
  footer_->addWidget(chosen_, 2);
  footer_->addWidget(note_, 5);
  bar->setMinimumHeight(note_->sizeHint().height() + sizes::kGrid);
  connect(note_, &QLineEdit::editingFinished, this, &VariantsGallery::tellNote);
  return bar;
}

void VariantsGallery::connectView() {
  connect(view_, &QListView::activated, this, [this](const QModelIndex& index) {
    // Enter applies one, not several.
    Q_EMIT applyWanted(idOf(index));
  });
  connect(delegate_, &VariantDelegate::starClicked, this, [this](const QModelIndex& index) {
    Q_EMIT starWanted({idOf(index)}, !index.data(VariantsModel::Starred).toBool());
  });
  connect(delegate_, &VariantDelegate::nameDoubleClicked, view_,
          [this](const QModelIndex& index) { view_->edit(index); });
  const auto changed = [this] {
    showSelection();
    Q_EMIT selectionChanged();
  };
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, changed);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, changed);
  connect(model_, &QAbstractItemModel::dataChanged, this,
          [this](const QModelIndex&, const QModelIndex&, const QList<int>& roles) {
            if (roles.isEmpty()) {
              showSelection();
              Q_EMIT selectionChanged();
            }
          });
  for (auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
    connect(filter_, signal, this, &VariantsGallery::showCount);
    connect(model_, signal, this, &VariantsGallery::showCount);
  }
}

bool VariantsGallery::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_->viewport() && event->type() == QEvent::Resize) {
    empty_->setGeometry(view_->viewport()->rect().adjusted(4 * sizes::kGrid, 0, -4 * sizes::kGrid, 0));
  }
  if (watched == view_ && event->type() == QEvent::Resize) {
    fitColumns();
  }
  if (watched == view_->viewport() && event->type() == QEvent::ContextMenu) {
    Q_EMIT contextMenuWanted(static_cast<QContextMenuEvent*>(event)->globalPos());
    return true;
  }
  if (watched == view_ && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
    return keyPressed(event);
  }
  return QWidget::eventFilter(watched, event);
}

// Delete removes, S stars; the keys of letters mean the gallery, and none of the window's tools.
bool VariantsGallery::keyPressed(QEvent* event) {
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if ((key.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) != Qt::NoModifier) {
    return false;
  }
  const bool removes = key.key() == Qt::Key_Delete || key.key() == Qt::Key_Backspace;
  if (event->type() == QEvent::ShortcutOverride) {
    if (removes || (!key.text().isEmpty() && key.text().front().isPrint())) {
      event->accept();
      return true;
    }
    return false;
  }
  const std::vector<int> ids = selected();
  if (removes) {
    if (!ids.empty()) {
      Q_EMIT removeWanted(ids);
    }
    return true;
  }
  if (key.key() == Qt::Key_S) {
    toggleStars(ids);
    return true;
  }
  return false;
}

// Stars on all of them, unless all have one.
void VariantsGallery::toggleStars(const std::vector<int>& ids) {
  const bool all = std::all_of(ids.begin(), ids.end(), [this](int id) {
    return model_->rows()[static_cast<std::size_t>(model_->rowOf(id))].starred;
  });
  if (!ids.empty()) {
    Q_EMIT starWanted(ids, !all);
  }
}

// As many columns as there is room for, spread over the width.
void VariantsGallery::fitColumns() {
  const int width = view_->width() - view_->verticalScrollBar()->sizeHint().width() - 1;
  delegate_->setItemWidth(width / std::max(1, width / VariantDelegate::kLeastWidth));
}

std::vector<int> VariantsGallery::selected() const {
  QModelIndexList indexes = view_->selectionModel()->selectedIndexes();
  const QModelIndex current = view_->currentIndex();
  std::sort(indexes.begin(), indexes.end(), [&](const QModelIndex& a, const QModelIndex& b) {
    return std::pair(a == current, a.row()) < std::pair(b == current, b.row());
  });
  std::vector<int> ids;
  for (const QModelIndex& index : std::as_const(indexes)) {
    ids.push_back(idOf(index));
  }
  return ids;
}

void VariantsGallery::select(const std::vector<int>& ids) {
  QItemSelection selection;
  QModelIndex last;
  for (const int id : ids) {
    const int row = model_->rowOf(id);
    const QModelIndex index = row < 0 ? QModelIndex() : filter_->mapFromSource(model_->index(row));
    if (index.isValid()) {
      selection.select(index, index);
      last = index;
    }
  }
  if (last.isValid()) {
    view_->selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
  }
  view_->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  if (last.isValid()) {
    view_->scrollTo(last);
  }
}

void VariantsGallery::rename() {
  const QModelIndexList indexes = view_->selectionModel()->selectedIndexes();
  if (indexes.size() == 1) {
    view_->setFocus();
    view_->scrollTo(indexes.first());
    view_->edit(indexes.first());
  }
}

void VariantsGallery::addAction(QAction* action, bool withSeveral) {
  auto* button = new QToolButton(this);
  button->setObjectName(action->objectName() + QStringLiteral("Button"));
  button->setDefaultAction(action);
  button->setAccessibleName(action->toolTip());
  button->setAutoRaise(true);
  button->setToolButtonStyle(action->icon().isNull() ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly);
  footer_->addWidget(button);
  if (withSeveral) {
    forSeveral_.push_back(button);
  }
  showSelection();
}

void VariantsGallery::setActivity(const QString& text) {
  activity_ = text;
  showCount();
}

void VariantsGallery::setEmptyText(const QString& text) {
  emptyText_ = text;
  showCount();
}

void VariantsGallery::tellNote() {
  const int row = model_->rowOf(noted_);
  note_->setModified(false);
  if (row >= 0 && model_->rows()[static_cast<std::size_t>(row)].note != note_->text()) {
    Q_EMIT noteWanted(noted_, note_->text());
  }
}

void VariantsGallery::showSelection() {
  const std::vector<int> ids = selected();
  const int row = ids.size() == 1 ? model_->rowOf(ids.front()) : -1;
  const int noted = row >= 0 ? ids.front() : 0;
  const bool another = noted != noted_;
  noted_ = noted;
  chosen_->setText(row >= 0         ? model_->rows()[static_cast<std::size_t>(row)].name
                   : ids.size() > 1 ? tr("%1 variants").arg(ids.size())
                                    : tr("None selected"));
  note_->setVisible(ids.size() <= 1);
  note_->setEnabled(row >= 0);
  const QString note = row >= 0 ? model_->rows()[static_cast<std::size_t>(row)].note : QString();
  if (note != note_->text() && (another || !note_->isModified())) {
    note_->setText(note);
  }
  for (QWidget* button : forSeveral_) {
    button->setVisible(ids.size() > 1);
  }
}

void VariantsGallery::showCount() {
  const int all = model_->rowCount();
  const int shown = filter_->rowCount();
  QString text = all == 0       ? QString()
                 : shown == all ? QString::number(all)
                                : tr("%1 of %2").arg(shown).arg(all);
  if (!activity_.isEmpty()) {
    text += (text.isEmpty() ? QString() : QStringLiteral(" · ")) + activity_;
  }
  count_->setText(text);
  empty_->setVisible(shown == 0);
  empty_->setText(all == 0 ? emptyText_ : tr("No variant is like that. Clear the words or the star above."));
}

}  // namespace graftsman

#include "moc_variants_gallery.cpp"  // NOLINT(bugprone-suspicious-include)
