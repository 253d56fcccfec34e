#pragma once

#include <QWidget>
#include <vector>

#include "widgets/panels/fusion_tree_model.h"

class QTreeView;

namespace graftsman {

/// The tree of fusions. A click or Enter on one asks for it to be shown, F2 or a double click edits its name,
/// Delete asks for it to be removed.
class FusionTreePanel : public QWidget {
  Q_OBJECT

 public:
  explicit FusionTreePanel(QWidget* parent = nullptr);

  [[nodiscard]] FusionTreeModel* model() const { return model_; }
  [[nodiscard]] QTreeView* view() const { return view_; }
  /// Shows these; where another fusion is the shown one than before, it is selected.
  void setRows(std::vector<FusionRow> rows);
  /// Opens the editor of its name. Precondition: there is such a fusion.
  void editName(FusionId fusion);

 Q_SIGNALS:
  void showWanted(graftsman::FusionId fusion);
  void renameWanted(graftsman::FusionId fusion, const QString& name);
  void removeWanted(graftsman::FusionId fusion);
  /// On the row of that fusion; 0: on a mesh, or beside the rows.
  void contextMenuWanted(graftsman::FusionId fusion, const QPoint& globalPosition);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeView();
  [[nodiscard]] FusionId fusionAt(const QModelIndex& index) const;
  void wantShown(const QModelIndex& index);

  FusionTreeModel* model_ = nullptr;
  QTreeView* view_ = nullptr;
  FusionId shown_ = 0;
};

}  // namespace graftsman
