#pragma once

#include <QAbstractItemModel>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/project/fusion.h"

namespace graftsman {

/// A fusion, or the part or base of one, as the tree shows it.
struct FusionRow {
  FusionId fusion = 0;       // the fusion that it is (the result of); 0: a mesh, or nothing yet
  FusionId owner = 0;        // the fusion that it is the part or base of; 0: at the top
  std::optional<Side> side;  // which of the two; nullopt at the top
  QString name;
  QString what;        // how large it is, or what is missing
  QString problem;     // one sentence: why there is no result; empty: none
  bool shown = false;  // the fusion that the window shows
  std::vector<FusionRow> rows;
};

/// The fusions of a document as a tree of two columns: name, and what it is like. A name of a fusion can be
/// edited: the model tells, and shows it when it is set.
class FusionTreeModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { Name, What, ColumnCount };

  explicit FusionTreeModel(QObject* parent = nullptr);
  ~FusionTreeModel() override;

  /// Replaces the rows with as few signals as the difference needs: selections and what is folded survive.
  void setRows(std::vector<FusionRow> rows);
  /// The row at `index`, without those under it. Precondition: the index is valid.
  [[nodiscard]] const FusionRow& row(const QModelIndex& index) const;
  /// The first row of that fusion from the top down; invalid: there is none.
  [[nodiscard]] QModelIndex find(FusionId fusion) const;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// The person gave it another name (empty: none of its own).
  void renameWanted(graftsman::FusionId fusion, const QString& name);

 private:
  struct Node;
  [[nodiscard]] Node& nodeAt(const QModelIndex& index) const;
  [[nodiscard]] QModelIndex indexOf(const Node& node, int column) const;
  [[nodiscard]] static std::unique_ptr<Node> made(FusionRow row, Node* parent);
  void replaceRows(Node& node, std::vector<FusionRow> rows);
  void change(Node& node, FusionRow row);

  std::unique_ptr<Node> root_;
};

}  // namespace graftsman
