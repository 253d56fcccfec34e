#pragma once

#include <QWidget>
#include <array>
#include <map>
#include <memory>

#include "app/document/document_model.h"
#include "app/workbench/camera_link.h"
#include "app/workbench/loop_view.h"
#include "core/base/error.h"

class QSplitter;

namespace graftsman {

class LoopEditor;
class MeshPane;
class PaneFrame;

/// Tiles mode: part and base side by side, with the loop on both. Shows what the document, the loop editor
/// and the last outcome say, and hands what the person does to the loop editor.
class TilesPage : public QWidget {
  Q_OBJECT

 public:
  TilesPage(DocumentModel& model, LoopEditor& editor, QWidget* parent = nullptr);

  [[nodiscard]] MeshPane* pane(Side side) const { return panes_[index(side)]; }
  void setOutcome(std::shared_ptr<const Outcome> outcome);
  [[nodiscard]] const Outcome* outcome() const { return outcome_.get(); }
  /// Both panes turn, move and zoom together.
  void setLinked(bool linked);
  /// nullopt: nothing is being computed.
  void setBusy(std::optional<double> progress);

 Q_SIGNALS:
  void loadWanted(graftsman::Side side, const QString& path);
  void contextMenuWanted(const QPoint& globalPosition);
  void remedyWanted(graftsman::Remedy remedy);
  /// Esc, with nothing here to back out of.
  void backedOut();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] static std::size_t index(Side side) { return side == Side::Part ? 0 : 1; }
  void connectPane(Side side);
  void showDocument(Change change, const Touched& touched);
  void showLoop();
  void showTitles();
  void enlarge(Side side, bool enlarged);
  void lookAtMeshes(Change change);
  void applyRemedy(Side side);

  DocumentModel& model_;
  LoopEditor& editor_;
  std::shared_ptr<const Outcome> outcome_;
  QSplitter* splitter_ = nullptr;
  std::array<MeshPane*, 2> panes_ = {};
  std::array<PaneFrame*, 2> frames_ = {};
  std::array<Verdict, 2> verdicts_;
  std::array<std::shared_ptr<const MeshAsset>, 2> seen_;  // that the panes were aimed at
  FusionId shown_ = 0;                                    // whose they are
  std::map<FusionId, std::array<Camera, 2>> cameras_;     // of fusions that were shown before
  std::optional<std::array<CameraLink, 2>> links_;        // from each side to the other; none: not linked
};

}  // namespace graftsman
