#include "app/workbench/tiles_page.h"

#include <QAction>
#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/document/loop_editor.h"
#include "app/workbench/first_view.h"
#include "app/workbench/fusion_rows.h"
#include "widgets/panels/pane_frame.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/mesh_pane.h"

namespace graftsman {
namespace {

constexpr std::array<Side, 2> kSides = {Side::Part, Side::Base};

// "head.obj · 8,932 faces", "Result of “Nose” · 9,120 faces".
QString title(const DocumentModel& model, Side side) {
  const std::shared_ptr<const MeshAsset>& asset = model.fusion().of(side);
  if (!asset) {
    return TilesPage::tr("no mesh yet");
  }
  const QString name =
      asset->result != 0
          ? TilesPage::tr("Result of “%1”").arg(fusionName(model.document().fusions, asset->result))
          : QString::fromStdString(asset->name);
  return asset->mesh ? TilesPage::tr("%1 · %2 faces").arg(name, QLocale().toString(asset->mesh->faceCount()))
                     : name;
}

}  // namespace

TilesPage::TilesPage(DocumentModel& model, LoopEditor& editor, QWidget* parent)
    : QWidget(parent), model_(model), editor_(editor), splitter_(new QSplitter(this)) {
  setObjectName("tilesPage");
  splitter_->setObjectName("tilesSplitter");
  splitter_->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter_);
  for (const Side side : kSides) {
    connectPane(side);
  }
  connect(&model, &DocumentModel::changed, this, &TilesPage::showDocument);
  shown_ = model.shown();
  connect(&editor, &LoopEditor::halfPairChanged, this, &TilesPage::showLoop);
  connect(&editor, &LoopEditor::selectionChanged, this, &TilesPage::showLoop);
  showTitles();
  showLoop();
}

void TilesPage::connectPane(Side side) {
  const bool isPart = side == Side::Part;
  auto* pane = new MeshPane(side);
  pane->setObjectName(isPart ? "partPane" : "basePane");
  pane->setAccessibleName(isPart ? tr("Part") : tr("Base"));
  auto* frame = new PaneFrame(isPart ? tr("Part") : tr("Base"), themeFor(palette()).of(side), pane);
  frame->setObjectName(isPart ? "partFrame" : "baseFrame");
  splitter_->addWidget(frame);
  panes_[index(side)] = pane;
  frames_[index(side)] = frame;

  connect(pane, &MeshPane::surfacePicked, this,
          [=, this](const SurfacePoint& at) { editor_.pick(side, at); });
  connect(pane, &MeshPane::cvClicked, &editor_, &LoopEditor::clickCV);
  connect(pane, &MeshPane::pathClicked, this, [=, this](int number, const SurfacePoint& at) {
    editor_.insertOnPath(side, number, at, outcome_.get());
  });
  connect(pane, &MeshPane::pickTakenBack, &editor_, &LoopEditor::takeBackPick);
  connect(pane, &MeshPane::cvDragStarted, this, [=, this](int number) { editor_.startDrag(side, number); });
  connect(pane, &MeshPane::cvDragged, this,
          [=, this](int number, const SurfacePoint& to) { editor_.dragTo(side, number, to); });
  connect(pane, &MeshPane::cvDragFinished, &editor_, &LoopEditor::finishDrag);
  connect(pane, &MeshPane::cvDragCancelled, &editor_, &LoopEditor::cancelDrag);
  connect(pane, &Viewport::fileDropped, this,
          [=, this](const QString& path) { Q_EMIT loadWanted(side, path); });
  connect(pane, &Viewport::contextMenuWanted, this, &TilesPage::contextMenuWanted);
  connect(pane, &Viewport::cameraChanged, this, [=, this](const Camera& camera) {
    if (links_) {
      panes_[1 - index(side)]->setCamera(follow((*links_)[index(side)], camera));
    }
  });
  connect(frame, &PaneFrame::enlargeToggled, this, [=, this](bool enlarged) { enlarge(side, enlarged); });
  connect(frame, &PaneFrame::remedyClicked, this, [=, this] { applyRemedy(side); });
}

void TilesPage::setOutcome(std::shared_ptr<const Outcome> outcome) {
  outcome_ = std::move(outcome);
  showLoop();
}

void TilesPage::setLinked(bool linked) {
  links_.reset();
  if (linked) {
    const Camera part = pane(Side::Part)->camera();
    const Camera base = pane(Side::Base)->camera();
    links_ = {linkCameras(part, base), linkCameras(base, part)};
    pane(Side::Part)->setCamera(follow((*links_)[index(Side::Base)], base));
  }
}

void TilesPage::setBusy(std::optional<double> progress) {
  for (MeshPane* pane : panes_) {
    pane->setBusy(progress);
  }
}

void TilesPage::showDocument(Change change, const Touched& touched) {
  const Fusion& fusion = model_.fusion();
  if (outcome_ && (change == Change::Reset || outcome_->fusion.id != fusion.id)) {
    outcome_.reset();
  }
  lookAtMeshes(change);
  for (const Side side : kSides) {
    pane(side)->setMesh(side == Side::Part ? fusion.inputs.part : fusion.inputs.base);
  }
  showTitles();
  showLoop();
  if (change == Change::History && touched.cv && *touched.cv < static_cast<int>(fusion.inputs.loop.size())) {
    for (const Side side : kSides) {
      if (!touched.side || *touched.side == side) {
        pane(side)->flashCV(*touched.cv);
      }
    }
  }
}

// A mesh that was not seen in its pane before is looked at from its first side. A fusion that was shown
// before is seen as the person left it, and a result that was computed anew as it was.
void TilesPage::lookAtMeshes(Change change) {
  const Fusion& fusion = model_.fusion();
  if (change == Change::Reset) {
    cameras_.clear();
  } else if (fusion.id != shown_) {
    cameras_[shown_] = {pane(Side::Part)->camera(), pane(Side::Base)->camera()};
  }
  const auto left = fusion.id != shown_ ? cameras_.find(fusion.id) : cameras_.end();
  for (const Side side : kSides) {
    const std::shared_ptr<const MeshAsset>& asset = fusion.of(side);
    if (asset && left != cameras_.end()) {
      pane(side)->setCamera(left->second[index(side)]);
    } else if (asset && !same(asset, seen_[index(side)])) {
      pane(side)->aim(firstView(fusion, side));
    }
    seen_[index(side)] = asset;
  }
  shown_ = fusion.id;
}

void TilesPage::applyRemedy(Side side) {
  const Verdict verdict = verdicts_[index(side)];
  switch (verdict.remedy) {
    case Remedy::ShowCV:
      editor_.select({verdict.cv});
      pane(side)->flashCV(verdict.cv);
      break;
    case Remedy::ShowSource:
      model_.show(model_.fusion().upstream(side));
      break;
    case Remedy::KeepPlaces:
      editor_.keepPlaces(side);
      break;
    default:
      Q_EMIT remedyWanted(verdict.remedy);
  }
}

void TilesPage::showTitles() {
  for (const Side side : kSides) {
    frames_[index(side)]->setTitle(title(model_, side));
    frames_[index(side)]->setRoleColour(themeFor(palette()).of(side));
  }
}

void TilesPage::showLoop() {
  for (const Side side : kSides) {
    SideView view = viewLoop(side, model_.fusion(), outcome_.get(), editor_.halfPair(), editor_.selection());
    pane(side)->setMarks(std::move(view.marks));
    PaneFrame* frame = frames_[index(side)];
    verdicts_[index(side)] = view.verdict;
    if (view.verdict.problem) {
      const char* name = remedyAction(view.verdict.remedy);
      const auto* action = name ? window()->findChild<const QAction*>(name) : nullptr;
      frame->setProblem(view.verdict.text, remedyText(view.verdict), action ? action->toolTip() : QString());
    } else {
      frame->setProblem({}, {});
      frame->setHint(view.verdict.text);
    }
  }
}

void TilesPage::enlarge(Side side, bool enlarged) {
  frames_[1 - index(side)]->setVisible(!enlarged);
}

void TilesPage::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!model_.committed().closed) {
        editor_.close();
        return;
      }
      break;
    case Qt::Key_Escape:
      if (!editor_.backOut()) {
        Q_EMIT backedOut();
      }
      return;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

void TilesPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    showTitles();
  }
  QWidget::changeEvent(event);
}

}  // namespace graftsman
