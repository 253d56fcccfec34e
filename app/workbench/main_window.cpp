#include "app/workbench/main_window.h"

#include <QDockWidget>
#include <QEvent>
#include <QListView>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStyle>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "app/document/commands.h"
#include "app/document/loop_editor.h"
#include "app/document/stage_runner.h"
#include "app/workbench/actions.h"
#include "app/workbench/autosave.h"
#include "app/workbench/compare_window.h"
#include "app/workbench/first_view.h"
#include "app/workbench/fusion_outline.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/job_queue.h"
#include "app/workbench/start_page.h"
#include "app/workbench/status_line.h"
#include "app/workbench/suggester.h"
#include "app/workbench/sweep_dialog.h"
#include "app/workbench/tiles_page.h"
#include "widgets/curve/fusion_curve_editor.h"
#include "widgets/curve/fusion_curve_panel.h"
#include "widgets/panels/adjustment_panel.h"
#include "widgets/panels/pairs_model.h"
#include "widgets/panels/pairs_panel.h"
#include "widgets/panels/stages_panel.h"
#include "widgets/variants/variants_gallery.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/result_pane.h"

namespace graftsman {
namespace {

// What is computed within this time is not announced: nothing blinks.
constexpr int kQuietMs = 150;

bool onlyCurveDiffers(Fusion a, const Fusion& b) {
  a.inputs.fcf = b.inputs.fcf;
  return a == b;
}

}  // namespace

MainWindow::MainWindow(const QString& recoveryFolder, QWidget* parent)
    : QMainWindow(parent),
      model_(new DocumentModel(this)),
      runner_(new StageRunner(this)),
      jobs_(new JobQueue(this)),
      editor_(new LoopEditor(*model_, this)),
      actions_(new Actions(this)),
      recoveryFolder_(recoveryFolder),
      pages_(new QStackedWidget),
      start_(new StartPage),
      tiles_(new TilesPage(*model_, *editor_)),
      fusion_(new FusionPage(*model_)),
      variants_(new VariantsPage(*model_, [this] { return resultView(); })),
      pairs_(new PairsPanel),
      curve_(new FusionCurvePanel),
      adjustment_(new AdjustmentPanel),
      stages_(new StagesPanel),
      outline_(new FusionOutline(*model_, this)),
      status_(new StatusLine) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  pages_->setObjectName("pages");
  for (QWidget* page : std::initializer_list<QWidget*>{start_, tiles_, fusion_, variants_}) {
    pages_->addWidget(page);
  }
  setCentralWidget(pages_);
  setStatusBar(status_);
  actions_->fill(menuBar());
  makePanels();
  makeToolBar();

  files_ = new ProjectFiles(*model_, *jobs_, projectView(), this);
  autosave_ = new Autosave(*model_, *files_, *jobs_, recoveryFolder, this);
  connectDocument();
  connectPanels();
  connectFiles();
  connectActions();
  connectVariants();
  makeSuggestions();
  restoreLayout();
  setMode(Mode::Start);
  showTitle();
  enableActions();
}

MainWindow::~MainWindow() {
  // What asks the window ends before it, and so do the windows over it.
  delete std::exchange(suggester_, nullptr);
  delete std::exchange(sweep_, nullptr);
  qDeleteAll(findChildren<CompareWindow*>());
  // What ends with the document tells it to nobody.
  model_->history()->disconnect();
  model_->disconnect();
}

void MainWindow::connectDocument() {
  connect(model_, &DocumentModel::changed, this, [this](Change change, const Touched& touched) {
    const Fusion& fusion = model_->fusion();
    if (change == Change::Reset) {
      status_->tell({});
    }
    if (change == Change::History && touched.adjustment) {
      adjustmentDock_->raise();
      adjustment_->showChange(fusion.inputs.adjustment);
    } else if (change != Change::Drag) {
      adjustment_->setSettings(fusion.inputs.adjustment);
    }
    if (change == Change::Upstream) {
      // What was computed just now: nothing is to be asked for.
    } else if (change != Change::Drag || !model_->dragging()) {
      requestRun(StageRunner::Urgency::Edit);
      if (mode() == Mode::Start && (fusion.part || fusion.base)) {
        setMode(Mode::Tiles);
      }
    } else if (!onlyCurveDiffers(model_->committed(), fusion)) {
      // Of a drag of the curve the result's pane shows each move by itself.
      requestRun(StageRunner::Urgency::Drag);
    }
    enableActions();
  });
  connect(runner_, &StageRunner::finished, this, &MainWindow::showOutcome);
  connect(runner_, &StageRunner::progressed, this, [this](const RunProgress& progress) {
    stages_->setRunning(progress.stage);
    if (tiles_->property("busy").toBool()) {
      status_->showRun(progress);
      tiles_->setBusy(progress.done);
      fusion_->setBusy(progress.done);
    }
  });
  connect(runner_, &StageRunner::busyChanged, this, [this](bool busy) {
    if (busy) {
      QTimer::singleShot(kQuietMs, this, &MainWindow::showBusy);
      return;
    }
    showBusy();
    Q_EMIT settled();
  });
  connect(jobs_, &JobQueue::progressed, status_, &StatusLine::showJob);
  connect(jobs_, &JobQueue::busyChanged, this, [this](bool busy) {
    if (!busy) {
      status_->showIdle();
    }
  });
  connect(status_, &StatusLine::cancelWanted, (*actions_)["cancel"], &QAction::trigger);
}

void MainWindow::requestRun(StageRunner::Urgency urgency) {
  runner_->request(model_->shownDocument(), model_->shown(), urgency);
}

void MainWindow::showBusy() {
  const bool busy = runner_->busy();
  tiles_->setProperty("busy", busy);
  (*actions_)["cancel"]->setEnabled(canCancel());
  if (busy) {
    tiles_->setBusy(0);
    fusion_->setBusy(0);
    return;
  }
  tiles_->setBusy({});
  fusion_->setBusy({});
  stages_->setRunning({});
  if (!jobs_->busy()) {
    status_->showIdle();
  }
}

void MainWindow::showOutcome(const std::shared_ptr<const Outcome>& outcome) {
  outline_->setOutcome(*outcome);
  if (outcome->fusion.id != model_->shown()) {
    return;  // it was on its way when another fusion was shown
  }
  const std::shared_ptr<const FusionResults> before =
      tiles_->outcome() ? tiles_->outcome()->results : nullptr;
  model_->setResultAssets(outcome->assets, outcome->fusion);
  tiles_->setOutcome(outcome);
  fusion_->setOutcome(outcome);
  pairs_->model()->setRows(pairRows(model_->fusion(), outcome.get(), editor_->halfPair()));
  status_->showOutcome(*outcome);
  if (!outcome->results) {
    stages_->clear();
    adjustment_->setReport({});
    curve_->editor()->setHistogram({});
  } else {
    stages_->setResults(*outcome->results);
    const auto& adjustment = outcome->results->adjustment;
    adjustment_->setReport(adjustment ? std::optional(adjustment->report) : std::nullopt);
    const auto& combined = outcome->results->combined;
    if (!before || before->combined != combined) {
      curve_->editor()->setHistogram(combined ? std::span<const double>(combined->s)
                                              : std::span<const double>());
    }
  }
  if (outcome->cancelled) {
    status_->tell(tr("Cancelled. The next edit, or “Run the adjustment”, goes on from there."));
  }
  enableActions();
}

void MainWindow::connectPanels() {
  const auto showRows = [this] {
    pairs_->model()->setRows(pairRows(model_->fusion(), tiles_->outcome(), editor_->halfPair()));
    const auto& half = editor_->halfPair();
    const auto pairs = model_->fusion().inputs.loop.size();
    pairs_->setNext(model_->fusion().closed            ? tr("The loop is closed: %1 pairs").arg(pairs)
                    : half && half->side == Side::Part ? tr("next: on the base")
                    : half                             ? tr("next: on the part")
                    : model_->fusion().part && model_->fusion().base ? tr("next: on either mesh")
                                                                     : tr("Load a part and a base first"));
  };
  connect(model_, &DocumentModel::changed, pairs_, showRows);
  connect(model_, &DocumentModel::changed, pairs_, [this](Change change, const Touched& touched) {
    if (change == Change::History && touched.cv) {
      pairs_->flashRow(*touched.cv);
    }
  });
  connect(editor_, &LoopEditor::halfPairChanged, pairs_, showRows);
  showRows();
  connect(editor_, &LoopEditor::selectionChanged, pairs_, &PairsPanel::setSelected);
  connect(editor_, &LoopEditor::selectionChanged, this, &MainWindow::enableActions);
  connect(editor_, &LoopEditor::refused, this,
          [this](const Error& error) { status_->warn(QString::fromStdString(error.message)); });
  connect(pairs_, &PairsPanel::selectionChanged, editor_, &LoopEditor::select);
  connect(pairs_, &PairsPanel::removeWanted, editor_, &LoopEditor::remove);

  connectCurve(*curve_, *model_, *fusion_);
  connect(fusion_->pane(), &ResultPane::sHovered, fusion_->pane(),
          [this](double s) { fusion_->pane()->setRing(s >= 0 ? std::optional(s) : std::nullopt); });
  connect(fusion_, &FusionPage::tilesWanted, this, [this] { setMode(Mode::Tiles); });

  adjustment_->setSettings(model_->fusion().inputs.adjustment);
  connect(adjustment_, &AdjustmentPanel::settingsEdited, this, [this](const AdjustmentSettings& settings) {
    model_->push(std::make_unique<SetAdjustment>(*model_, settings));
  });
  connect(adjustment_, &AdjustmentPanel::runWanted, (*actions_)["runAdjustment"], &QAction::trigger);
  connect(adjustment_, &AdjustmentPanel::shownChanged, fusion_, &FusionPage::setPartInPlace);
}

MainWindow::Mode MainWindow::mode() const {
  const QWidget* page = pages_->currentWidget();
  return page == tiles_      ? Mode::Tiles
         : page == fusion_   ? Mode::Fusion
         : page == variants_ ? Mode::Variants
                             : Mode::Start;
}

void MainWindow::setMode(Mode mode) {
  QWidget* page = start_;
  const char* action = "startPage";
  switch (mode) {
    case Mode::Start:
      break;
    case Mode::Tiles:
      page = tiles_;
      action = "tilesMode";
      break;
    case Mode::Fusion:
      page = fusion_;
      action = "fusionMode";
      break;
    case Mode::Variants:
      page = variants_;
      action = "variantsMode";
      break;
  }
  pages_->setCurrentWidget(page);
  showDocksOf(mode);
  (*actions_)[action]->setChecked(true);
  if (Viewport* viewport = currentViewport()) {
    viewport->setFocus();
  } else if (mode == Mode::Variants) {
    variants_->gallery()->view()->setFocus();
  }
  enableActions();
}

void MainWindow::lookAtFirst() {
  const Fusion& fusion = model_->fusion();
  const auto look = [&](Viewport* viewport, Side side) {
    if (fusion.of(side)) {
      viewport->aim(firstView(fusion, side));
    }
  };
  look(tiles_->pane(Side::Part), Side::Part);
  look(tiles_->pane(Side::Base), Side::Base);
  look(fusion_->pane(), Side::Base);
}

Viewport* MainWindow::currentViewport() const {
  if (mode() == Mode::Start || mode() == Mode::Variants) {
    return nullptr;
  }
  if (mode() == Mode::Fusion) {
    return fusion_->pane();
  }
  // The pane under the pointer, else the one with the keyboard.
  MeshPane* part = tiles_->pane(Side::Part);
  MeshPane* base = tiles_->pane(Side::Base);
  return part->underMouse() || (part->hasFocus() && !base->underMouse()) ? part : base;
}

void MainWindow::showTitle() {
  const bool modified = !model_->history()->isClean();
  const FusionList& fusions = model_->document().fusions;
  const QString fusion =
      fusions.size() > 1 ? tr(" – %1").arg(fusionName(fusions, model_->shown())) : QString();
  setWindowTitle(tr("%1[*]%2 – Graftsman").arg(files_->name(), fusion));
  setWindowModified(modified);
  const bool anything = modified || !files_->path().isEmpty();
  status_->showSaved(anything ? std::optional(!modified) : std::nullopt);
}

QImage MainWindow::resultPicture(const QSize& size) {
  return fusion_->pane()->picture(size);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    actions_->refreshIcons();
  }
  QMainWindow::changeEvent(event);
}

}  // namespace graftsman
