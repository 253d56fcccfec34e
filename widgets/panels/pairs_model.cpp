#include "widgets/panels/pairs_model.h"

#include <QGuiApplication>
#include <QIcon>
#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "widgets/panels/numbers.h"
#include "widgets/theme/contrast.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr int kLengthDigits = 3;
constexpr double kVisible = 2;  // least contrast of a swatch without a line round it

struct Heading {
  const char* text;
  const char* toolTip;
};

constexpr std::array<Heading, PairsModel::ColumnCount> kHeadings = {{
    {"#", "Number of the pair, in the colour of its spheres"},
    {"part", "Vertex of the part"},
    {"base", "Vertex of the base"},
    {"part\npath", "Length of the part's path to the next pair, in the part's unit"},
    {"base\npath", "Length of the base's path to the next pair, in the base's unit"},
    {"problem", "What is wrong with the pair or with its path to the next"},
}};

bool isHalf(const PairRow& row) {
  return row.part.has_value() != row.base.has_value();
}

// As the sphere in the panes: full, or a ring while the partner is missing.
QIcon swatch(int number, bool hollow) {
  constexpr int kSize = 12;
  constexpr double kRatio = 3;  // drawn large, so that it is sharp at any ratio
  QPixmap pixmap(QSize(kSize, kSize) * kRatio);
  pixmap.fill(Qt::transparent);
  pixmap.setDevicePixelRatio(kRatio);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette palette = QGuiApplication::palette();
  const QColor ground = palette.color(QPalette::Base);
  const QPointF middle(kSize / 2.0, kSize / 2.0);
  painter.setPen(QPen(cvColour(number), 2));
  painter.setBrush(hollow ? Qt::NoBrush : QBrush(cvColour(number)));
  painter.drawEllipse(middle, 4, 4);
  if (contrast(cvColour(number), ground) < kVisible) {
    painter.setPen(QPen(mixed(ground, palette.color(QPalette::Text), 0.6), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(middle, 5.5, 5.5);
  }
  painter.end();
  QIcon swatch(pixmap);
  swatch.addPixmap(pixmap, QIcon::Selected);  // no style may tint it: its colour is the spheres'
  return swatch;
}

QString pointText(const std::optional<SurfacePoint>& point) {
  if (!point) {
    return QStringLiteral("–");
  }
  const QLocale locale;
  return point->vertex >= 0 ? locale.toString(point->vertex)
                            : QStringLiteral("face %1").arg(locale.toString(point->face));
}

QString pointDetails(const std::optional<SurfacePoint>& point, const char* side) {
  if (!point) {
    return QStringLiteral("Not picked yet: click a point on the %1").arg(QLatin1String(side));
  }
  const QLocale locale;
  if (point->vertex >= 0) {
    return QStringLiteral("Vertex %1 of the %2").arg(locale.toString(point->vertex), QLatin1String(side));
  }
  const auto weight = [&](int i) { return locale.toString(point->bary[i], 'f', 3); };
  return QStringLiteral("A point within face %1 of the %2; weights of its corners: %3, %4, %5")
      .arg(locale.toString(point->face), QLatin1String(side), weight(0), weight(1), weight(2));
}

QString lengthText(const std::optional<double>& length) {
  return length ? significant(*length, kLengthDigits) : QStringLiteral("–");
}

QString lengthDetails(const std::optional<double>& length, const char* side) {
  return length ? QStringLiteral("Length of the path on the %1: %2")
                      .arg(QLatin1String(side), QLocale().toString(*length, 'g', 9))
                : QStringLiteral("There is no path on the %1 yet").arg(QLatin1String(side));
}

QString text(const PairRow& row, int number, int column) {
  switch (column) {
    case PairsModel::Number:
      return QString::number(number);
    case PairsModel::PartVertex:
      return pointText(row.part);
    case PairsModel::BaseVertex:
      return pointText(row.base);
    case PairsModel::PartLength:
      return lengthText(row.partLength);
    case PairsModel::BaseLength:
      return lengthText(row.baseLength);
    default:
      return row.problem;
  }
}

QString details(const PairRow& row, int number, int column) {
  switch (column) {
    case PairsModel::Number:
      return isHalf(row) ? QStringLiteral("Pair %1, half made").arg(number)
                         : QStringLiteral("Pair %1").arg(number);
    case PairsModel::PartVertex:
      return pointDetails(row.part, "part");
    case PairsModel::BaseVertex:
      return pointDetails(row.base, "base");
    case PairsModel::PartLength:
      return lengthDetails(row.partLength, "part");
    case PairsModel::BaseLength:
      return lengthDetails(row.baseLength, "base");
    default:
      return row.problem;
  }
}

QVariant alignment(int column) {
  const bool words = column == PairsModel::Number || column == PairsModel::Problem;
  return QVariant(Qt::Alignment(words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
}

QColor problemColour() {
  const QPalette palette = QGuiApplication::palette();
  return legible(themeFor(palette).problem, palette.color(QPalette::Base));
}

QVariant columnColour(int column) {
  const QPalette palette = QGuiApplication::palette();
  const Theme theme = themeFor(palette);
  const QColor ground = palette.color(QPalette::Button);
  if (column == PairsModel::PartVertex || column == PairsModel::PartLength) {
    return legible(theme.part, ground);
  }
  if (column == PairsModel::BaseVertex || column == PairsModel::BaseLength) {
    return legible(theme.base, ground);
  }
  return {};
}

}  // namespace

void PairsModel::setRows(std::vector<PairRow> rows) {
  const auto [oldDiffers, newDiffers] = std::mismatch(rows_.begin(), rows_.end(), rows.begin(), rows.end());
  const auto begin = static_cast<int>(oldDiffers - rows_.begin());
  const auto [oldEnd, newEnd] = std::mismatch(rows_.rbegin(), std::make_reverse_iterator(oldDiffers),
                                              rows.rbegin(), std::make_reverse_iterator(newDiffers));
  const auto removed = static_cast<int>(oldEnd.base() - oldDiffers);
  const auto added = static_cast<int>(newEnd.base() - newDiffers);
  const int changed = std::min(removed, added);  // the first of them keep their row
  const int shiftAt = begin + changed;
  if (removed > added) {
    beginRemoveRows({}, shiftAt, begin + removed - 1);
    rows_.erase(rows_.begin() + shiftAt, rows_.begin() + begin + removed);
    numbers_.erase(numbers_.begin() + shiftAt, numbers_.begin() + begin + removed);
    endRemoveRows();
  } else if (added > removed) {
    beginInsertRows({}, shiftAt, begin + added - 1);
    rows_.insert(rows_.begin() + shiftAt, rows.begin() + shiftAt, rows.begin() + begin + added);
    numbers_.insert(numbers_.begin() + shiftAt, static_cast<std::size_t>(added - removed), 0);
    std::iota(numbers_.begin() + shiftAt, numbers_.begin() + begin + added, shiftAt);
    endInsertRows();
  }
  for (int i = begin; i < shiftAt; ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (!(rows_[row] == rows[row])) {
      rows_[row] = std::move(rows[row]);
      tellChanged(i, i, Number, Problem);
    }
  }
  if (removed != added) {  // those behind have another number now
    std::iota(numbers_.begin() + begin + added, numbers_.end(), begin + added);
    tellChanged(begin + added, rowCount() - 1, Number, Number);
  }
}

void PairsModel::tellChanged(int first, int last, Column from, Column to) {
  if (first <= last) {
    Q_EMIT dataChanged(index(first, from), index(last, to));
  }
}

int PairsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int PairsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant PairsModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
    return {};
  }
  const PairRow& row = rows_[static_cast<std::size_t>(index.row())];
  const int number = numbers_[static_cast<std::size_t>(index.row())];
  const bool aboutProblem = index.column() == Problem && !row.problem.isEmpty();
  switch (role) {
    case Qt::DisplayRole:
      return text(row, number, index.column());
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return details(row, number, index.column());
    case Qt::DecorationRole:
      return index.column() == Number ? QVariant(swatch(number, isHalf(row)))
             : aboutProblem           ? QVariant(icon(QStringLiteral("problem"), problemColour()))
                                      : QVariant();
    case Qt::ForegroundRole:
      return aboutProblem ? QVariant(QBrush(problemColour())) : QVariant();
    case Qt::TextAlignmentRole:
      return alignment(index.column());
    default:
      return {};
  }
}

QVariant PairsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
    return {};
  }
  const Heading& heading = kHeadings[static_cast<std::size_t>(section)];
  switch (role) {
    case Qt::DisplayRole:
      return QString::fromUtf8(heading.text);
    case Qt::ToolTipRole:
      return QString::fromUtf8(heading.toolTip);
    case Qt::ForegroundRole:
      return columnColour(section);
    case Qt::TextAlignmentRole:
      return alignment(section);
    default:
      return {};
  }
}

}  // namespace graftsman
