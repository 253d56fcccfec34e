#include "widgets/variants/variants_filter.h"

#include <QLocale>
#include <algorithm>

#include "widgets/variants/variants_model.h"

namespace graftsman {
namespace {

// The locale "C" knows no numbers in names.
QLocale locale() {
  const QLocale system;
  return system.language() == QLocale::C ? QLocale(QLocale::English) : system;
}

}  // namespace

VariantsFilter::VariantsFilter(QObject* parent) : QSortFilterProxyModel(parent), collator_(locale()) {
  // "Nose 2" before "Nose 10".
  collator_.setNumericMode(true);
  collator_.setCaseSensitivity(Qt::CaseInsensitive);
  setDynamicSortFilter(true);
  sort(0);
}

void VariantsFilter::setOrder(Order order) {
  if (order_ != order) {
    order_ = order;
    invalidate();
  }
}

void VariantsFilter::setStarredOnly(bool only) {
  if (starredOnly_ != only) {
    starredOnly_ = only;
    invalidateFilter();
  }
}

void VariantsFilter::setWords(const QString& words) {
  const QStringList list = words.split(' ', Qt::SkipEmptyParts);
  if (words_ != list) {
    words_ = list;
    invalidateFilter();
  }
}

bool VariantsFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QModelIndex index = sourceModel()->index(row, 0, parent);
  if (starredOnly_ && !index.data(VariantsModel::Starred).toBool()) {
    return false;
  }
  const QString text =
      index.data(VariantsModel::Name).toString() + '\n' + index.data(VariantsModel::Note).toString();
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool VariantsFilter::lessThan(const QModelIndex& a, const QModelIndex& b) const {
  const auto number = [](const QModelIndex& index) { return index.data(VariantsModel::Id).toInt(); };
  const auto starred = [](const QModelIndex& index) { return index.data(VariantsModel::Starred).toBool(); };
  if (order_ == Order::Newest) {
    return number(a) > number(b);
  }
  if (order_ == Order::Star && starred(a) != starred(b)) {
    return starred(a);
  }
  if (order_ == Order::Name) {
    const int names =
        collator_.compare(a.data(VariantsModel::Name).toString(), b.data(VariantsModel::Name).toString());
    if (names != 0) {
      return names < 0;
    }
  }
  return number(a) < number(b);
}

}  // namespace graftsman

#include "moc_variants_filter.cpp"  // NOLINT(bugprone-suspicious-include)
