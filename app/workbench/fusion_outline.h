#pragma once

#include <QObject>
#include <memory>

#include "app/document/document_model.h"
#include "app/workbench/fusion_rows.h"
#include "core/base/error.h"

class QMenu;

namespace graftsman {

class FusionTreePanel;
struct Outcome;

/// The dock with the fusions of the document: keeps its tree, and makes the edits of whole fusions.
class FusionOutline : public QObject {
  Q_OBJECT

 public:
  explicit FusionOutline(DocumentModel& model, QObject* parent = nullptr);

  [[nodiscard]] FusionTreePanel* panel() const { return panel_; }
  /// What a run found out about the results of the shown fusion and of those that it is made of.
  void setOutcome(const Outcome& outcome);

  void addEmpty();
  /// Another fusion whose base is the result of this one; it is shown, and lacks its part.
  void fuseOnto(FusionId id);
  /// The result of `source` becomes the part or base of the shown fusion.
  void take(FusionId source, Side side);
  void remove(FusionId id);
  /// Opens the editor of its name in the tree.
  void editName(FusionId id);
  /// The fusions whose results the shown one may take, an entry each.
  void fillTakeMenu(QMenu& menu, Side side);

 Q_SIGNALS:
  /// An edit that core refused.
  void refused(const graftsman::Error& error);
  /// There is a fusion now whose meshes and loop are to be given.
  void tilesWanted();

 private:
  void showRows();
  void forgetWhatIsStale();
  void showContextMenu(FusionId id, const QPoint& at);

  DocumentModel& model_;
  FusionTreePanel* panel_;
  KnownResults known_;
  FusionList before_;  // that known_ is of
};

}  // namespace graftsman
