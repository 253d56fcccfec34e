#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <optional>

#include "app/document/document_model.h"
#include "app/document/stage_runner.h"
#include "widgets/panels/adjustment_panel.h"
#include "widgets/viewport/viewport.h"

class QComboBox;
class QToolButton;

namespace graftsman {

class FusionCurvePanel;
class PaneFrame;
class ResultPane;

/// Fusion mode: the result of the fusion that is shown. It stays shown, dimmed, while another is computed or
/// while there is none for the present inputs; then its footer says why. A fusion that was shown before is
/// seen as the person left it.
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
  /// A widget under the result.
  void addBelow(QWidget* widget);

  void setColouring(int colouring);
  void setPartInPlace(AdjustmentPanel::Shown shown);
  [[nodiscard]] QToolButton* seamButton() const { return seam_; }
  [[nodiscard]] QComboBox* colourBox() const { return colours_; }
  [[nodiscard]] QToolButton* suggestButton() const { return suggest_; }

 Q_SIGNALS:
  void contextMenuWanted(const QPoint& globalPosition);
  /// "Show the tiles": the remedy of a fusion that failed.
  void tilesWanted();

 private:
  void showDocument(Change change);
  void lookAtArrived(const Outcome& outcome);
  void showVerdict(const Outcome* outcome);

  DocumentModel& model_;
  ResultPane* pane_ = nullptr;
  PaneFrame* frame_ = nullptr;
  QComboBox* colours_ = nullptr;
  QToolButton* seam_ = nullptr;
  QToolButton* suggest_ = nullptr;
  std::shared_ptr<const FusionResults> shown_;
  FusionId seen_ = 0;                   // the fusion that the camera was last set for
  std::map<FusionId, Camera> cameras_;  // of fusions that were shown before
};

/// Lets the curve's panel, the document and the result's pane follow each other: what is dragged shows at
/// once and becomes one step of history at the end. Lives as long as the panel.
void connectCurve(FusionCurvePanel& panel, DocumentModel& model, FusionPage& page);

}  // namespace graftsman
