#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <optional>
#include <vector>

#include "core/mesh/surface_point.h"

namespace graftsman {

/// A pair as the table shows it.
struct PairRow {
  std::optional<SurfacePoint> part;  // absent: not picked yet
  std::optional<SurfacePoint> base;
  std::optional<double> partLength;  // of the path to the next pair, model length; absent: none yet
  std::optional<double> baseLength;
  QString problem;  // one sentence; empty: none
  friend bool operator==(const PairRow&, const PairRow&) = default;
};

/// The pairs of a loop, a row each: number, part vertex, base vertex, path length on the part, on the base,
/// problem.
class PairsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Number, PartVertex, BaseVertex, PartLength, BaseLength, Problem, ColumnCount };

  explicit PairsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  /// Replaces the rows with as few signals as the difference needs: selections survive.
  void setRows(std::vector<PairRow> rows);
  [[nodiscard]] const std::vector<PairRow>& rows() const { return rows_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void tellChanged(int first, int last, Column from, Column to);

  std::vector<PairRow> rows_;
  std::vector<int> numbers_;  // as told; behind an insertion they follow a moment later
};

}  // namespace graftsman
