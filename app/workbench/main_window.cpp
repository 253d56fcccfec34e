#include "app/workbench/main_window.h"

#include <QDockWidget>
#include <QEvent>
#include <QMenuBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStyle>
#include <QTimer>
#include <QToolBar>
#include <QUndoView>
#include <algorithm>

#include "app/document/commands.h"
#include "app/document/loop_editor.h"
#include "app/document/stage_runner.h"
#include "app/workbench/actions.h"
#include "app/workbench/autosave.h"
#include "app/workbench/first_view.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/job_queue.h"
#include "app/workbench/start_page.h"
#include "app/workbench/status_line.h"
#include "app/workbench/tiles_page.h"
#include "widgets/curve/fusion_curve_editor.h"
#include "widgets/curve/fusion_curve_panel.h"
#include "widgets/panels/adjustment_panel.h"
#include "widgets/panels/pairs_model.h"
#include "widgets/panels/pairs_panel.h"
#include "widgets/panels/stages_panel.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/result_pane.h"

namespace graftsman {
namespace {

constexpr auto kLayoutKey = "window/layout";
constexpr auto kGeometryKey = "window/geometry";
constexpr auto kClosedByPerson = "closedByPerson";
// Of saveState(): another number after a change of docks or bars.
constexpr int kLayoutVersion = 1;

// What is computed within this time is not announced: nothing blinks.
constexpr int kQuietMs = 150;

constexpr QSize kFirstSize(1280, 800);
constexpr int kDockFrame = 9 * sizes::kGrid;  // more than a dock's title and the tabs above it

bool onlyCurveDiffers(Document a, const Document& b) {
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
      pairs_(new PairsPanel),
      curve_(new FusionCurvePanel),
      adjustment_(new AdjustmentPanel),
      stages_(new StagesPanel),
      status_(new StatusLine) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  pages_->setObjectName("pages");
  for (QWidget* page : std::initializer_list<QWidget*>{start_, tiles_, fusion_}) {
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
  restoreLayout();
  setMode(Mode::Start);
  showTitle();
  enableActions();
}

MainWindow::~MainWindow() {
  // What ends with the document tells it to nobody.
  model_->history()->disconnect();
  model_->disconnect();
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  actions_->menu("docksMenu")->addAction(dock->toggleViewAction());
  // A dock behind another one's tab is not hidden for Qt: Tab would lead out of sight.
  connect(dock, &QDockWidget::visibilityChanged, content, &QWidget::setEnabled);
  return dock;
}

void MainWindow::makePanels() {
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  pairsDock_ = addDock("pairsDock", tr("Pairs"), pairs_);
  curveDock_ = addDock("curveDock", tr("Fusion curve"), curve_);
  adjustmentDock_ = addDock("adjustmentDock", tr("Adjustment"), adjustment_);
  QDockWidget* stages = addDock("stagesDock", tr("Stages"), stages_);
  auto* view = new QUndoView(model_->history());
  view->setObjectName("historyView");
  view->setAccessibleName(tr("History"));
  view->setEmptyLabel(tr("As opened"));
  QDockWidget* history = addDock("historyDock", tr("History"), view);
  tabifyDockWidget(adjustmentDock_, stages);
  tabifyDockWidget(stages, history);
  adjustmentDock_->raise();
  sharedDocks_ = {adjustmentDock_, stages, history};
  for (QDockWidget* dock : sharedDocks_) {
    connect(dock->toggleViewAction(), &QAction::triggered, dock,
            [dock](bool shown) { dock->setProperty(kClosedByPerson, !shown); });
  }
  resizeDocks({pairsDock_, curveDock_}, {360, 360}, Qt::Horizontal);
}

void MainWindow::makeToolBar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) {
      bar->addAction((*actions_)[name]);
    }
    bar->addSeparator();
  };
  add({"tilesMode", "fusionMode"});
  add({"undo", "redo"});
  add({"loadPart", "loadBase"});
  add({"closeLoop", "reverse", "shift"});
  bar->addAction((*actions_)["findAction"]);
  for (const char* name : {"undo", "redo", "findAction"}) {
    if (auto* button = bar->widgetForAction((*actions_)[name])) {
      button->setProperty("toolButtonStyle", Qt::ToolButtonIconOnly);
    }
  }
}

void MainWindow::connectDocument() {
  connect(model_, &DocumentModel::changed, this, [this](Change change, const Touched& touched) {
    const Document& document = model_->document();
    if (change == Change::History && touched.adjustment) {
      adjustmentDock_->raise();
      adjustment_->showChange(document.inputs.adjustment);
    } else if (change != Change::Drag) {
      adjustment_->setSettings(document.inputs.adjustment);
    }
    if (change == Change::Reset) {
      status_->tell({});
    }
    if (change != Change::Drag) {
      runner_->request(document, StageRunner::Urgency::Edit);
      if (mode() == Mode::Start && (document.part || document.base)) {
        setMode(Mode::Tiles);
      }
    } else if (!model_->dragging()) {
      runner_->request(document, StageRunner::Urgency::Edit);
    } else if (!onlyCurveDiffers(model_->committed(), document)) {
      // Of a drag of the curve the result's pane shows each move by itself.
      runner_->request(document, StageRunner::Urgency::Drag);
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

void MainWindow::showBusy() {
  const bool busy = runner_->busy();
  tiles_->setProperty("busy", busy);
  (*actions_)["cancel"]->setEnabled(busy || jobs_->busy());
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
  const std::shared_ptr<const FusionResults> before =
      tiles_->outcome() ? tiles_->outcome()->results : nullptr;
  tiles_->setOutcome(outcome);
  fusion_->setOutcome(outcome);
  pairs_->model()->setRows(pairRows(model_->document(), outcome.get(), editor_->halfPair()));
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
    pairs_->model()->setRows(pairRows(model_->document(), tiles_->outcome(), editor_->halfPair()));
    const auto& half = editor_->halfPair();
    const auto pairs = model_->document().inputs.loop.size();
    pairs_->setNext(model_->document().closed          ? tr("The loop is closed: %1 pairs").arg(pairs)
                    : half && half->side == Side::Part ? tr("next: on the base")
                    : half                             ? tr("next: on the part")
                    : model_->document().part && model_->document().base
                        ? tr("next: on either mesh")
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

  adjustment_->setSettings(model_->document().inputs.adjustment);
  connect(adjustment_, &AdjustmentPanel::settingsEdited, this, [this](const AdjustmentSettings& settings) {
    model_->push(std::make_unique<SetAdjustment>(*model_, settings));
  });
  connect(adjustment_, &AdjustmentPanel::runWanted, (*actions_)["runAdjustment"], &QAction::trigger);
  connect(adjustment_, &AdjustmentPanel::shownChanged, fusion_, &FusionPage::setPartInPlace);
}

MainWindow::Mode MainWindow::mode() const {
  const QWidget* page = pages_->currentWidget();
  return page == tiles_ ? Mode::Tiles : page == fusion_ ? Mode::Fusion : Mode::Start;
}

void MainWindow::setMode(Mode mode) {
  pages_->setCurrentWidget(mode == Mode::Tiles    ? static_cast<QWidget*>(tiles_)
                           : mode == Mode::Fusion ? static_cast<QWidget*>(fusion_)
                                                  : start_);
  showDocksOf(mode);
  (*actions_)[mode == Mode::Tiles    ? "tilesMode"
              : mode == Mode::Fusion ? "fusionMode"
                                     : "startPage"]
      ->setChecked(true);
  if (Viewport* viewport = currentViewport()) {
    viewport->setFocus();
  }
  enableActions();
}

// The pairs belong to Tiles mode, the curve to Fusion mode; the other panels are in both, those that the
// person closed in neither; none is on the start page.
void MainWindow::showDocksOf(Mode mode) {
  for (const QDockWidget* upper : {pairsDock_, curveDock_}) {
    if (docksShared_ && upper->isVisible() && !upper->isFloating()) {
      lowerDocks_ = docksHeight() - upper->height();
    }
  }
  docksShared_ = false;
  pairsDock_->setVisible(mode == Mode::Tiles);
  curveDock_->setVisible(mode == Mode::Fusion);
  for (QDockWidget* dock : sharedDocks_) {
    dock->setVisible(mode != Mode::Start && !dock->property(kClosedByPerson).toBool());
  }
  shareDocks();
  QTimer::singleShot(0, this, [this] { docksShared_ = this->mode() != Mode::Start; });
}

int MainWindow::docksHeight() const {
  return pages_->height() - style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
}

// The docks that both modes have keep their height from one mode to the other; at first the adjustment is
// seen whole.
void MainWindow::shareDocks() {
  const bool first = lowerDocks_ == 0;
  if (mode() == Mode::Start || (first && laidOut_)) {
    return;
  }
  const int whole = docksHeight();
  const int wanted = adjustment_->sizeHint().height() + kDockFrame;
  const int lower = first ? std::min(wanted, whole * 11 / 20) : lowerDocks_;
  resizeDocks({mode() == Mode::Tiles ? pairsDock_ : curveDock_, adjustmentDock_}, {whole - lower, lower},
              Qt::Vertical);
}

void MainWindow::lookAtFirst() {
  const Document& document = model_->document();
  const auto look = [&](Viewport* viewport, Side side) {
    if (document.of(side)) {
      viewport->aim(firstView(document, side));
    }
  };
  look(tiles_->pane(Side::Part), Side::Part);
  look(tiles_->pane(Side::Base), Side::Base);
  look(fusion_->pane(), Side::Base);
}

Viewport* MainWindow::currentViewport() const {
  if (mode() == Mode::Start) {
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
  setWindowTitle(tr("%1[*] – Graftsman").arg(files_->name()));
  setWindowModified(modified);
  const bool anything = modified || !files_->path().isEmpty();
  status_->showSaved(anything ? std::optional(!modified) : std::nullopt);
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  if (!restoreGeometry(settings.value(kGeometryKey).toByteArray())) {
    resize(kFirstSize);
  }
  laidOut_ = restoreState(settings.value(kLayoutKey).toByteArray(), kLayoutVersion);
}

void MainWindow::saveLayout() const {
  QSettings settings;
  settings.setValue(kGeometryKey, saveGeometry());
  settings.setValue(kLayoutKey, saveState(kLayoutVersion));
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
