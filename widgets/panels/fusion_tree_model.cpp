#include "widgets/panels/fusion_tree_model.h"

#include <QBrush>
#include <QFont>
#include <QGuiApplication>
#include <QIcon>
#include <QPalette>
#include <algorithm>
#include <utility>

#include "widgets/theme/contrast.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {

struct FusionTreeModel::Node {
  FusionRow row;  // `rows` in it are the children's
  Node* parent = nullptr;
  std::vector<std::unique_ptr<Node>> children;
};

namespace {

// Of the same thing at the same place: only what is said of it differs.
bool isSameRow(const FusionRow& a, const FusionRow& b) {
  return a.fusion == b.fusion && a.owner == b.owner && a.side == b.side;
}

bool saysTheSame(const FusionRow& a, const FusionRow& b) {
  return a.name == b.name && a.what == b.what && a.problem == b.problem && a.shown == b.shown;
}

QColor onGround(const QColor& colour) {
  return legible(colour, QGuiApplication::palette().color(QPalette::Base));
}

QIcon rowIcon(const FusionRow& row) {
  const QString name = row.fusion != 0 ? QStringLiteral("result") : QStringLiteral("mesh");
  return row.side ? icon(name, onGround(themeFor(QGuiApplication::palette()).of(*row.side))) : icon(name);
}

QString roleText(const FusionRow& row) {
  return !row.side                 ? QStringLiteral("Fusion")
         : *row.side == Side::Part ? QStringLiteral("Part")
                                   : QStringLiteral("Base");
}

// "Part: cone.stl, 1,200 faces".
QString details(const FusionRow& row) {
  QString text = roleText(row) + QStringLiteral(": ") + row.name;
  if (!row.what.isEmpty()) {
    text += QStringLiteral(", ") + row.what;
  }
  return row.problem.isEmpty() ? text : text + QStringLiteral(". ") + row.problem;
}

}  // namespace

FusionTreeModel::FusionTreeModel(QObject* parent)
    : QAbstractItemModel(parent), root_(std::make_unique<Node>()) {}

FusionTreeModel::~FusionTreeModel() = default;

std::unique_ptr<FusionTreeModel::Node> FusionTreeModel::made(FusionRow row, Node* parent) {
  auto node = std::make_unique<Node>();
  node->parent = parent;
  std::vector<FusionRow> rows = std::exchange(row.rows, {});
  node->row = std::move(row);
  for (FusionRow& child : rows) {
    node->children.push_back(made(std::move(child), node.get()));
  }
  return node;
}

void FusionTreeModel::setRows(std::vector<FusionRow> rows) {
  replaceRows(*root_, std::move(rows));
}

// What is the same at both ends stays; what is between goes and comes.
void FusionTreeModel::replaceRows(Node& node, std::vector<FusionRow> rows) {
  auto& children = node.children;
  const auto sameAt = [&](std::size_t i, std::size_t j) { return isSameRow(children[i]->row, rows[j]); };
  const std::size_t common = std::min(children.size(), rows.size());
  std::size_t head = 0;
  while (head < common && sameAt(head, head)) {
    ++head;
  }
  std::size_t tail = 0;
  while (tail < common - head && sameAt(children.size() - 1 - tail, rows.size() - 1 - tail)) {
    ++tail;
  }
  const QModelIndex index = indexOf(node, 0);
  const auto begin = static_cast<std::ptrdiff_t>(head);
  if (children.size() > head + tail) {
    beginRemoveRows(index, static_cast<int>(head), static_cast<int>(children.size() - tail) - 1);
    children.erase(children.begin() + begin, children.end() - static_cast<std::ptrdiff_t>(tail));
    endRemoveRows();
  }
  const std::size_t added = rows.size() - head - tail;
  if (added > 0) {
    beginInsertRows(index, static_cast<int>(head), static_cast<int>(head + added) - 1);
    for (std::size_t i = head; i < head + added; ++i) {
      children.insert(children.begin() + static_cast<std::ptrdiff_t>(i), made(std::move(rows[i]), &node));
    }
    endInsertRows();
  }
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (i < head || i >= head + added) {
      change(*children[i], std::move(rows[i]));
    }
  }
}

void FusionTreeModel::change(Node& node, FusionRow row) {
  std::vector<FusionRow> rows = std::exchange(row.rows, {});
  if (!saysTheSame(node.row, row)) {
    node.row = std::move(row);
    Q_EMIT dataChanged(indexOf(node, Name), indexOf(node, What));
  }
  replaceRows(node, std::move(rows));
}

FusionTreeModel::Node& FusionTreeModel::nodeAt(const QModelIndex& index) const {
  return index.isValid() ? *static_cast<Node*>(index.internalPointer()) : *root_;
}

QModelIndex FusionTreeModel::indexOf(const Node& node, int column) const {
  if (node.parent == nullptr) {
    return {};
  }
  const auto& siblings = node.parent->children;
  const auto at = std::ranges::find(siblings, &node, &std::unique_ptr<Node>::get);
  return createIndex(static_cast<int>(at - siblings.begin()), column, const_cast<Node*>(&node));
}

const FusionRow& FusionTreeModel::row(const QModelIndex& index) const {
  return nodeAt(index).row;
}

QModelIndex FusionTreeModel::find(FusionId fusion) const {
  std::vector<const Node*> level = {root_.get()};
  while (!level.empty()) {
    std::vector<const Node*> next;
    for (const Node* node : level) {
      for (const auto& child : node->children) {
        if (child->row.fusion == fusion && fusion != 0) {
          return indexOf(*child, 0);
        }
        next.push_back(child.get());
      }
    }
    level = std::move(next);
  }
  return {};
}

QModelIndex FusionTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) {
    return {};
  }
  return createIndex(row, column, nodeAt(parent).children[static_cast<std::size_t>(row)].get());
}

QModelIndex FusionTreeModel::parent(const QModelIndex& index) const {
  return index.isValid() ? indexOf(*nodeAt(index).parent, 0) : QModelIndex();
}

int FusionTreeModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(nodeAt(parent).children.size());
}

int FusionTreeModel::columnCount(const QModelIndex&) const {
  return ColumnCount;
}

QVariant FusionTreeModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const FusionRow& row = nodeAt(index).row;
  const bool aboutProblem = index.column() == What && !row.problem.isEmpty();
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == Name ? row.name : row.what;
    case Qt::EditRole:
      return index.column() == Name ? QVariant(row.name) : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return details(row);
    case Qt::DecorationRole:
      return index.column() == Name ? QVariant(rowIcon(row))
             : aboutProblem         ? QVariant(icon(QStringLiteral("problem"),
                                                    onGround(themeFor(QGuiApplication::palette()).problem)))
                                    : QVariant();
    case Qt::ForegroundRole:
      return aboutProblem ? QVariant(QBrush(onGround(themeFor(QGuiApplication::palette()).problem)))
                          : QVariant();
    case Qt::FontRole: {
      QFont font = QGuiApplication::font();
      font.setBold(row.shown && index.column() == Name);
      return font;
    }
    case Qt::TextAlignmentRole:
      return QVariant(Qt::Alignment(index.column() == Name ? Qt::AlignLeft : Qt::AlignRight) |
                      Qt::AlignVCenter);
    default:
      return {};
  }
}

bool FusionTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) {
    return false;
  }
  const FusionRow& row = nodeAt(index).row;
  const QString name = value.toString().trimmed();
  if (name != row.name) {
    Q_EMIT renameWanted(row.fusion, name);
  }
  return true;
}

Qt::ItemFlags FusionTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) {
    return Qt::NoItemFlags;
  }
  const bool editable = index.column() == Name && nodeAt(index).row.fusion != 0;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | (editable ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

}  // namespace graftsman

#include "moc_fusion_tree_model.cpp"  // NOLINT(bugprone-suspicious-include)
