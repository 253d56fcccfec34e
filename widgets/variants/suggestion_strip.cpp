#include "widgets/variants/suggestion_strip.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/panels/elided_label.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"
#include "widgets/variants/suggestion_delegate.h"
#include "widgets/variants/suggestions_model.h"

namespace graftsman {
namespace {

// Pictures are as wide as lets so many stand beside each other, where that is wide enough.
constexpr int kBesideEachOther = 9;

}  // namespace

SuggestionStrip::SuggestionStrip(QWidget* parent)
    : QWidget(parent),
      model_(new SuggestionsModel(this)),
      view_(new QListView(this)),
      delegate_(new SuggestionDelegate(this)) {
  setObjectName(QStringLiteral("suggestionStrip"));
  setAccessibleName(tr("Suggestions"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeHeader());
  makeView();
  column->addWidget(view_);
  fit();
}

QWidget* SuggestionStrip::makeHeader() {
  auto* bar = new QWidget(this);
  bar->setObjectName(QStringLiteral("suggestionsHeader"));
  auto* title = new QLabel(tr("Suggestions"), bar);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  sentence_ = new ElidedLabel(bar);
  sentence_->setObjectName(QStringLiteral("suggestionsSentence"));
  orders_ = new QComboBox(bar);
  orders_->setObjectName(QStringLiteral("suggestionsOrder"));
  orders_->setAccessibleName(tr("Sorted by"));
  orders_->setToolTip(tr("The measure by which suggestions are chosen and sorted"));
  auto* by = new QLabel(tr("Sorted by"), bar);
  by->setBuddy(orders_);
  auto* close = new QToolButton(bar);
  close->setObjectName(QStringLiteral("suggestionsClose"));
  close->setAccessibleName(tr("Close the suggestions"));
  close->setToolTip(tr("Close the suggestions (Ctrl+G)"));
  close->setIcon(icon(QStringLiteral("cancel")));
  close->setAutoRaise(true);

  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(sizes::kGrid, sizes::kGrid / 2, sizes::kGrid, sizes::kGrid / 2);
  row->setSpacing(sizes::kGrid);
  row->addWidget(title);
  row->addWidget(sentence_, 1);
  row->addWidget(by);
  row->addWidget(orders_);
  row->addWidget(close);
  connect(close, &QToolButton::clicked, this, &SuggestionStrip::closeWanted);
  connect(orders_, &QComboBox::currentIndexChanged, this, &SuggestionStrip::orderChosen);
  return bar;
}

void SuggestionStrip::makeView() {
  view_->setObjectName(QStringLiteral("suggestionsView"));
  view_->setAccessibleName(tr("Suggestions"));
  view_->setModel(model_);
  view_->setItemDelegate(delegate_);
  view_->setViewMode(QListView::IconMode);
  view_->setFlow(QListView::LeftToRight);
  view_->setWrapping(false);
  view_->setMovement(QListView::Static);
  view_->setUniformItemSizes(true);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  view_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setFrameShape(QFrame::NoFrame);
  view_->viewport()->setAttribute(Qt::WA_Hover);
  view_->installEventFilter(this);
  view_->viewport()->installEventFilter(this);

  reason_ = new QLabel(view_->viewport());
  reason_->setObjectName(QStringLiteral("suggestionsReason"));
  reason_->setAlignment(Qt::AlignCenter);
  reason_->setWordWrap(true);
  reason_->setForegroundRole(QPalette::Text);
  reason_->setAttribute(Qt::WA_TransparentForMouseEvents);
  reason_->hide();

  connect(view_, &QListView::clicked, this, &SuggestionStrip::take);
  connect(model_, &QAbstractItemModel::modelReset, this, [this] {
    if (model_->rowCount() > 0) {
      view_->selectionModel()->setCurrentIndex(model_->index(0), QItemSelectionModel::NoUpdate);
    }
    fit();
  });
}

void SuggestionStrip::take(const QModelIndex& index) {
  if (index.flags().testFlag(Qt::ItemIsEnabled)) {
    Q_EMIT takeWanted(index.data(SuggestionsModel::Id).toInt());
  }
}

void SuggestionStrip::setOrders(const QStringList& orders) {
  const QSignalBlocker quiet(orders_);
  orders_->clear();
  orders_->addItems(orders);
}

int SuggestionStrip::order() const {
  return orders_->currentIndex();
}

void SuggestionStrip::setSentence(const QString& sentence) {
  sentence_->setText(sentence);
}

void SuggestionStrip::setReason(const QString& reason) {
  reason_->setText(reason);
  reason_->setVisible(!reason.isEmpty());
}

bool SuggestionStrip::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_->viewport() && event->type() == QEvent::Resize) {
    reason_->setGeometry(view_->viewport()->rect().adjusted(4 * sizes::kGrid, 0, -4 * sizes::kGrid, 0));
  }
  if (watched == view_ && event->type() == QEvent::Resize) {
    fit();
  }
  if (watched == view_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      take(view_->currentIndex());
      return true;
    }
    if (key == Qt::Key_Escape) {
      Q_EMIT left();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void SuggestionStrip::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    Q_EMIT paletteChanged();
  }
  if (event->type() == QEvent::FontChange) {
    fit();
  }
  QWidget::changeEvent(event);
}

// The height is that of the pictures, with the scroll bar where there is no room for all of them.
void SuggestionStrip::fit() {
  delegate_->fit(view_->width(), kBesideEachOther);
  const QSize item = delegate_->itemSize(view_->font());
  const bool scrolls = model_->rowCount() * item.width() > view_->width();
  view_->setFixedHeight(item.height() + (scrolls ? view_->horizontalScrollBar()->sizeHint().height() : 0));
}

}  // namespace graftsman

#include "moc_suggestion_strip.cpp"  // NOLINT(bugprone-suspicious-include)
