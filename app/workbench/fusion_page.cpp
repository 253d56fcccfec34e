#include "app/workbench/fusion_page.h"

#include <QComboBox>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/workbench/loop_view.h"
#include "widgets/panels/pane_frame.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/result_pane.h"

namespace graftsman {

FusionPage::FusionPage(DocumentModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      pane_(new ResultPane),
      frame_(new PaneFrame(tr("Result"), {}, pane_, this)),
      colours_(new QComboBox),
      seam_(new QToolButton) {
  setObjectName("fusionPage");
  pane_->setObjectName("resultPane");
  pane_->setAccessibleName(tr("Result"));
  frame_->setObjectName("resultFrame");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(frame_);

  colours_->setObjectName("colouring");
  colours_->setAccessibleName(tr("Colour by"));
  colours_->setToolTip(tr("What the result's colours mean (C: the next)"));
  // In the order of Colouring.
  colours_->addItems({tr("Plain"), tr("Fusion curve f"), tr("Tile of origin"), tr("Normal jump at the seam"),
                      tr("Triangle quality")});
  connect(colours_, &QComboBox::currentIndexChanged, this, &FusionPage::setColouring);
  frame_->addHeaderWidget(colours_);
  seam_->setObjectName("seam");
  seam_->setAutoRaise(true);
  frame_->addHeaderWidget(seam_);

  connect(pane_, &Viewport::contextMenuWanted, this, &FusionPage::contextMenuWanted);
  connect(frame_, &PaneFrame::remedyClicked, this, &FusionPage::tilesWanted);
  connect(&model, &DocumentModel::changed, this, &FusionPage::showDocument);
  showVerdict(nullptr);
}

void FusionPage::setOutcome(const std::shared_ptr<const Outcome>& outcome) {
  if (outcome->results && outcome->results->fused && !outcome->results->error) {
    shown_ = outcome->results;
    pane_->setResults(shown_);
    // The hand may be further than the worker was.
    if (!(shown_->inputs.fcf == model_.fusion().inputs.fcf)) {
      pane_->setCurve(model_.fusion().inputs.fcf);
    }
  }
  showVerdict(outcome.get());
}

void FusionPage::setBusy(std::optional<double> progress) {
  pane_->setBusy(progress);
}

void FusionPage::setColouring(int colouring) {
  pane_->setColouring(static_cast<Colouring>(colouring));
}

void FusionPage::setPartInPlace(AdjustmentPanel::Shown shown) {
  using Shown = AdjustmentPanel::Shown;
  pane_->setPartInPlace(shown == Shown::Before  ? ResultPane::PartInPlace::Before
                        : shown == Shown::After ? ResultPane::PartInPlace::After
                                                : ResultPane::PartInPlace::Hidden);
}

void FusionPage::showDocument(Change change) {
  const FusionInputs& inputs = model_.fusion().inputs;
  if (change == Change::Reset || !inputs.part || !inputs.base) {
    shown_.reset();
    pane_->setResults(nullptr);
    showVerdict(nullptr);
  } else if (shown_) {
    pane_->setCurve(inputs.fcf);
  }
}

void FusionPage::showVerdict(const Outcome* outcome) {
  frame_->setTitle(shown_ ? tr("%1 vertices · %2 faces")
                                .arg(QLocale().toString(shown_->fused->points.size()),
                                     QLocale().toString(shown_->fused->faces().size()))
                          : QString());
  const Error* error = errorOf(outcome);
  if (error && model_.fusion().closed) {
    const QString text = QString::fromStdString(error->message);
    frame_->setProblem(shown_ ? tr("Shown is the last result that worked. %1").arg(text) : text,
                       tr("Show the tiles"));
    return;
  }
  const bool open = !model_.fusion().closed;
  frame_->setProblem(open && shown_ ? tr("The loop is open: shown is the last result.") : QString(),
                     open && shown_ ? tr("Show the tiles") : QString());
  frame_->setHint(shown_ ? tr("Drag a point of the fusion curve, and the result follows")
                         : tr("Nothing is fused yet: load two meshes and close the loop in Tiles mode"));
}

}  // namespace graftsman
