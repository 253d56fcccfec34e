#include "app/workbench/fusion_page.h"

#include <QComboBox>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/workbench/first_view.h"
#include "app/workbench/fusion_rows.h"
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
      seam_(new QToolButton),
      suggest_(new QToolButton) {
  setObjectName("fusionPage");
  pane_->setObjectName("resultPane");
  pane_->setAccessibleName(tr("Result"));
  frame_->setObjectName("resultFrame");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(frame_, 1);

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
  suggest_->setObjectName("suggest");
  suggest_->setAutoRaise(true);
  suggest_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  frame_->addHeaderWidget(suggest_);

  connect(pane_, &Viewport::contextMenuWanted, this, &FusionPage::contextMenuWanted);
  connect(frame_, &PaneFrame::remedyClicked, this, &FusionPage::tilesWanted);
  connect(&model, &DocumentModel::changed, this, &FusionPage::showDocument);
  showVerdict(nullptr);
}

void FusionPage::setOutcome(const std::shared_ptr<const Outcome>& outcome) {
  if (outcome->results && outcome->results->fused && !outcome->results->error) {
    shown_ = outcome->results;
    lookAtArrived(*outcome);
    pane_->setResults(shown_);
    // The hand may be further than the worker was.
    if (!(shown_->inputs.fcf == model_.fusion().inputs.fcf)) {
      pane_->setCurve(model_.fusion().inputs.fcf);
    }
  } else if (!shown_) {
    pane_->setResults(nullptr);  // that of the fusion that was shown before
  }
  showVerdict(outcome.get());
}

void FusionPage::setBusy(std::optional<double> progress) {
  pane_->setBusy(progress);
}

void FusionPage::addBelow(QWidget* widget) {
  layout()->addWidget(widget);
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
  const Fusion& fusion = model_.fusion();
  if (change == Change::Reset || !fusion.part || !fusion.base) {
    shown_.reset();
    pane_->setResults(nullptr);
    showVerdict(nullptr);
    if (change == Change::Reset) {
      cameras_.clear();
      seen_ = fusion.id;
    }
  } else if (change == Change::Shown) {
    // The pane keeps its picture until the other result is there, but it is none that counts.
    shown_.reset();
  } else if (shown_) {
    pane_->setCurve(fusion.inputs.fcf);
  }
}

// Another fusion's result: seen as the person left it, or, where it is of another base, from its first side.
void FusionPage::lookAtArrived(const Outcome& outcome) {
  const FusionId id = outcome.fusion.id;
  if (id == seen_) {
    return;
  }
  cameras_[seen_] = pane_->camera();
  const FusionList& fusions = model_.document().fusions;
  if (const auto left = cameras_.find(id); left != cameras_.end()) {
    pane_->setCamera(left->second);
  } else if (firstBase(fusions, id) != firstBase(fusions, seen_)) {
    pane_->aim(firstView(outcome.fusion, Side::Base));
  }
  seen_ = id;
}

void FusionPage::showVerdict(const Outcome* outcome) {
  QStringList title;
  if (model_.document().fusions.size() > 1) {
    title.append(fusionName(model_.document().fusions, model_.shown()));
  }
  if (shown_) {
    title.append(tr("%1 vertices · %2 faces")
                     .arg(QLocale().toString(shown_->fused->points.size()),
                          QLocale().toString(shown_->fused->faces().size())));
  }
  frame_->setTitle(title.join(tr(" · ")));
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
