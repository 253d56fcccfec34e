#include "widgets/variants/variants_model.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace graftsman {
namespace {

using Rows = std::vector<VariantRow>;

bool sameIds(const VariantRow& a, const VariantRow& b) {
  return a.id == b.id;
}

}  // namespace

// What both lists begin and end with stays; between, rows are removed and inserted. A removal from the middle
// is one of several blocks where rows between them stay.
void VariantsModel::setRows(Rows rows) {
  const auto isGone = [&](const VariantRow& row) {
    return std::none_of(rows.begin(), rows.end(), [&](const auto& other) { return other.id == row.id; });
  };
  for (auto last = static_cast<int>(rows_.size()) - 1; last >= 0; --last) {
    if (!isGone(rows_[static_cast<std::size_t>(last)])) {
      continue;
    }
    int first = last;
    while (first > 0 && isGone(rows_[static_cast<std::size_t>(first) - 1])) {
      --first;
    }
    beginRemoveRows({}, first, last);
    rows_.erase(rows_.begin() + first, rows_.begin() + last + 1);
    shown_.erase(shown_.begin() + first, shown_.begin() + last + 1);
    endRemoveRows();
    last = first;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i < rows_.size() && sameIds(rows_[i], rows[i])) {
      if (!(rows_[i] == rows[i])) {
        rows_[i] = std::move(rows[i]);
        const QModelIndex changed = index(static_cast<int>(i));
        Q_EMIT dataChanged(changed, changed);
      }
      continue;
    }
    const auto place = static_cast<std::ptrdiff_t>(i);
    const int from = rowOf(rows[i].id);
    if (from >= 0) {  // it stands elsewhere: it is taken from there
      beginRemoveRows({}, from, from);
      rows_.erase(rows_.begin() + from);
      Shown kept = std::move(shown_[static_cast<std::size_t>(from)]);
      shown_.erase(shown_.begin() + from);
      endRemoveRows();
      beginInsertRows({}, static_cast<int>(i), static_cast<int>(i));
      rows_.insert(rows_.begin() + place, std::move(rows[i]));
      shown_.insert(shown_.begin() + place, std::move(kept));
      endInsertRows();
      continue;
    }
    beginInsertRows({}, static_cast<int>(i), static_cast<int>(i));
    rows_.insert(rows_.begin() + place, std::move(rows[i]));
    shown_.insert(shown_.begin() + place, Shown());
    endInsertRows();
  }
}

int VariantsModel::rowOf(int id) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [id](const VariantRow& row) { return row.id == id; });
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

void VariantsModel::setPicture(int id, const QImage& picture, const QString& problem) {
  const int row = rowOf(id);
  if (row < 0) {
    return;
  }
  Shown& shown = shown_[static_cast<std::size_t>(row)];
  if (shown.picture.cacheKey() == picture.cacheKey() && shown.problem == problem) {
    return;
  }
  shown = {picture, problem};
  Q_EMIT dataChanged(index(row), index(row), {Picture, Problem, Qt::ToolTipRole});
}

int VariantsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QString VariantsModel::toolTip(std::size_t row) const {
  QStringList lines{rows_[row].name};
  for (const QString& line : {rows_[row].note, shown_[row].problem}) {
    if (!line.isEmpty()) {
      lines.append(line);
    }
  }
  return lines.join('\n');
}

QVariant VariantsModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const auto row = static_cast<std::size_t>(index.row());
  const VariantRow& variant = rows_[row];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
    case Name:
      return variant.name;
    case Qt::ToolTipRole:
      return toolTip(row);
    case Qt::AccessibleTextRole:
      return variant.starred ? tr("%1, starred").arg(variant.name) : variant.name;
    case Qt::AccessibleDescriptionRole:
    case Note:
      return variant.note;
    case Id:
      return variant.id;
    case Starred:
      return variant.starred;
    case Present:
      return variant.present;
    case Picture:
      return shown_[row].picture;
    case Problem:
      return shown_[row].problem;
    default:
      return {};
  }
}

bool VariantsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const QString name = value.toString().simplified();
  if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid) || name.isEmpty()) {
    return false;
  }
  const VariantRow& row = rows_[static_cast<std::size_t>(index.row())];
  if (name != row.name) {
    Q_EMIT renameWanted(row.id, name);
  }
  return true;
}

Qt::ItemFlags VariantsModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractListModel::flags(index);
  return index.isValid() ? flags | Qt::ItemIsEditable | Qt::ItemNeverHasChildren : flags;
}

}  // namespace graftsman

#include "moc_variants_model.cpp"  // NOLINT(bugprone-suspicious-include)
