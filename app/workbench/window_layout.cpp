#include <QDockWidget>
#include <QMenu>
#include <QSettings>
#include <QStackedWidget>
#include <QStyle>
#include <QTimer>
#include <QToolBar>
#include <QUndoView>
#include <algorithm>

#include "app/workbench/actions.h"
#include "app/workbench/fusion_outline.h"
#include "app/workbench/main_window.h"
#include "widgets/curve/fusion_curve_panel.h"
#include "widgets/panels/adjustment_panel.h"
#include "widgets/panels/fusion_tree_panel.h"
#include "widgets/panels/pairs_panel.h"
#include "widgets/panels/stages_panel.h"
#include "widgets/theme/theme.h"
#include "widgets/variants/suggestion_strip.h"

// The window's docks and bars, and how they are laid out.
namespace graftsman {
namespace {

constexpr auto kLayoutKey = "window/layout";
constexpr auto kGeometryKey = "window/geometry";
constexpr auto kLowerDocksKey = "window/lowerDocks";
constexpr auto kSuggestionsKey = "window/suggestions";
constexpr auto kClosedByPerson = "closedByPerson";
// Of saveState(): another number after a change of docks or bars.
constexpr int kLayoutVersion = 3;

constexpr QSize kFirstSize(1280, 800);
constexpr int kDockFrame = 9 * sizes::kGrid;  // more than a dock's title and the tabs above it

}  // namespace

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
  view->setEmptyLabel(tr("Beginning"));
  QDockWidget* history = addDock("historyDock", tr("History"), view);
  tabifyDockWidget(adjustmentDock_, stages);
  QDockWidget* fusions = addDock("fusionsDock", tr("Fusions"), outline_->panel());
  tabifyDockWidget(stages, history);
  tabifyDockWidget(history, fusions);
  adjustmentDock_->raise();
  sharedDocks_ = {adjustmentDock_, stages, history, fusions};
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
  add({"tilesMode", "fusionMode", "variantsMode"});
  add({"undo", "redo"});
  add({"loadPart", "loadBase"});
  add({"closeLoop", "reverse", "shift"});
  add({"keepVariant"});
  bar->addAction((*actions_)["findAction"]);
  for (const char* name : {"undo", "redo", "findAction"}) {
    if (auto* button = bar->widgetForAction((*actions_)[name])) {
      button->setProperty("toolButtonStyle", Qt::ToolButtonIconOnly);
    }
  }
}

// The pairs belong to Tiles mode, the curve to Fusion mode; the other panels are in all modes, those that the
// person closed in none; none is on the start page.
void MainWindow::showDocksOf(Mode mode) {
  lowerDocks_ = lowerDocks();
  docksShared_ = false;
  pairsDock_->setVisible(mode == Mode::Tiles);
  curveDock_->setVisible(mode == Mode::Fusion);
  for (QDockWidget* dock : sharedDocks_) {
    dock->setVisible(mode != Mode::Start && !dock->property(kClosedByPerson).toBool());
  }
  if (mode == Mode::Tiles || mode == Mode::Fusion) {
    shareDocks(mode);
  }
  // What is laid out in the next round of the event loop is the person's from then on.
  QTimer::singleShot(0, this,
                     [this] { docksShared_ = this->mode() == Mode::Tiles || this->mode() == Mode::Fusion; });
}

// The docks that both modes have keep their height from one mode to the other; at first the adjustment is
// seen whole.
void MainWindow::shareDocks(Mode mode) {
  const bool first = lowerDocks_ == 0;
  if (first && laidOut_) {
    return;
  }
  const int whole = docksHeight();
  const int wanted = adjustment_->sizeHint().height() + kDockFrame;
  const int lower = first ? std::min(wanted, whole * 11 / 20) : lowerDocks_;
  resizeDocks({mode == Mode::Tiles ? pairsDock_ : curveDock_, adjustmentDock_}, {whole - lower, lower},
              Qt::Vertical);
}

int MainWindow::lowerDocks() const {
  for (const QDockWidget* upper : {pairsDock_, curveDock_}) {
    if (docksShared_ && upper->isVisible() && !upper->isFloating()) {
      return docksHeight() - upper->height();
    }
  }
  return lowerDocks_;
}

int MainWindow::docksHeight() const {
  return pages_->height() - style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  if (!restoreGeometry(settings.value(kGeometryKey).toByteArray())) {
    resize(kFirstSize);
  }
  laidOut_ = restoreState(settings.value(kLayoutKey).toByteArray(), kLayoutVersion);
  lowerDocks_ = settings.value(kLowerDocksKey, 0).toInt();
  const bool suggesting = settings.value(kSuggestionsKey, false).toBool();
  suggestions_->setVisible(suggesting);
  (*actions_)["suggestions"]->setChecked(suggesting);
}

void MainWindow::saveLayout() const {
  QSettings settings;
  settings.setValue(kGeometryKey, saveGeometry());
  settings.setValue(kLayoutKey, saveState(kLayoutVersion));
  settings.setValue(kLowerDocksKey, lowerDocks());
  settings.setValue(kSuggestionsKey, !suggestions_->isHidden());
}

}  // namespace graftsman
