#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "app/document/document_model.h"
#include "app/document/stage_runner.h"
#include "widgets/panels/adjustment_panel.h"

class QComboBox;
class QToolButton;

namespace graftsman {

class FusionCurvePanel;
class PaneFrame;
class ResultPane;

/// Fusion mode: the result. It stays shown, dimmed, while another is computed or while there is none for the
/// present inputs; then its footer says why.
class FusionPage : public QWidget {
  Q_OBJECT

 public:
  FusionPage(DocumentModel& model, QWidget* parent = nullptr);

  [[nodiscard]] ResultPane* pane() const { return pane_; }
  /// The result that is shown; null: none. It may be of older inputs than the document's.
  [[nodiscard]] const FusionResults* shown() const { return shown_.get(); }
  [[nodiscard]] const std::shared_ptr<const FusionResults>& shownResults() const { return shown_; }
  void setOutcome(const std::shared_ptr<const Outcome>& outcome);
  void setBusy(std::optional<double> progress);

  void setColouring(int colouring);
  void setPartInPlace(AdjustmentPanel::Shown shown);
  [[nodiscard]] QToolButton* seamButton() const { return seam_; }
  [[nodiscard]] QComboBox* colourBox() const { return colours_; }

 Q_SIGNALS:
  void contextMenuWanted(const QPoint& globalPosition);
  /// "Show the tiles": the remedy of a fusion that failed.
  void tilesWanted();

 private:
  void showDocument(Change change);
  void showVerdict(const Outcome* outcome);

  DocumentModel& model_;
  ResultPane* pane_ = nullptr;
  PaneFrame* frame_ = nullptr;
  QComboBox* colours_ = nullptr;
  QToolButton* seam_ = nullptr;
  std::shared_ptr<const FusionResults> shown_;
};

/// Lets the curve's panel, the document and the result's pane follow each other: what is dragged shows at
/// once and becomes one step of history at the end. Lives as long as the panel.
void connectCurve(FusionCurvePanel& panel, DocumentModel& model, FusionPage& page);

}  // namespace graftsman
