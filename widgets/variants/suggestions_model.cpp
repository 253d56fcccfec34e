#include "widgets/variants/suggestions_model.h"

#include <algorithm>
#include <utility>

namespace graftsman {

void SuggestionsModel::setRows(std::vector<SuggestionRow> rows) {
  std::vector<QImage> pictures;
  for (const SuggestionRow& row : rows) {
    const int before = rowOf(row.id);
    pictures.push_back(before < 0 ? QImage() : pictures_[static_cast<std::size_t>(before)]);
  }
  beginResetModel();
  rows_ = std::move(rows);
  pictures_ = std::move(pictures);
  endResetModel();
}

int SuggestionsModel::rowOf(int id) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [id](const SuggestionRow& row) { return row.id == id; });
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

void SuggestionsModel::setPicture(int id, const QImage& picture) {
  const int row = rowOf(id);
  if (row < 0 || pictures_[static_cast<std::size_t>(row)].cacheKey() == picture.cacheKey()) {
    return;
  }
  pictures_[static_cast<std::size_t>(row)] = picture;
  Q_EMIT dataChanged(index(row), index(row), {Picture});
}

void SuggestionsModel::setTaken(int id) {
  if (std::exchange(taken_, id) != id) {
    tellAll();
  }
}

void SuggestionsModel::setOutdated(bool outdated) {
  if (std::exchange(outdated_, outdated) != outdated) {
    tellAll();
  }
}

void SuggestionsModel::tellAll() {
  if (!rows_.empty()) {
    Q_EMIT dataChanged(index(0), index(static_cast<int>(rows_.size()) - 1));
  }
}

int SuggestionsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant SuggestionsModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const SuggestionRow& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return row.difference;
    case Qt::ToolTipRole:
      return QStringLiteral("%1\n%2").arg(row.difference, row.measure);
    case Qt::AccessibleTextRole:
      return (row.id == taken_ ? tr("%1, %2, taken") : tr("%1, %2")).arg(row.difference, row.measure);
    case Id:
      return row.id;
    case Measure:
      return row.measure;
    case Taken:
      return row.id == taken_;
    case Picture:
      return pictures_[static_cast<std::size_t>(index.row())];
    default:
      return {};
  }
}

Qt::ItemFlags SuggestionsModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) {
    return Qt::NoItemFlags;
  }
  return outdated_ ? Qt::ItemNeverHasChildren
                   : Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
}

}  // namespace graftsman

#include "moc_suggestions_model.cpp"  // NOLINT(bugprone-suspicious-include)
