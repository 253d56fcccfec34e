#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QSettings>
#include <QToolButton>

#include "app/document/commands.h"
#include "app/document/loop_editor.h"
#include "app/document/stage_runner.h"
#include "app/workbench/actions.h"
#include "app/workbench/compare_window.h"
#include "app/workbench/first_view.h"
#include "app/workbench/fusion_outline.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/help_dialogs.h"
#include "app/workbench/job_queue.h"
#include "app/workbench/main_window.h"
#include "app/workbench/status_line.h"
#include "app/workbench/suggester.h"
#include "app/workbench/sweep_dialog.h"
#include "app/workbench/tiles_page.h"
#include "app/workbench/variant_pictures.h"
#include "widgets/curve/fusion_curve_editor.h"
#include "widgets/curve/fusion_curve_panel.h"
#include "widgets/panels/adjustment_panel.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/result_pane.h"

// What each action does.
namespace graftsman {
namespace {

constexpr auto kNavigationKey = "view/navigation";

void onTrigger(const Actions& actions, const char* name, QObject* context, std::function<void()> what) {
  QObject::connect(actions[name], &QAction::triggered, context, [what = std::move(what)] { what(); });
}

}  // namespace

void MainWindow::connectActions() {
  const Actions& actions = *actions_;
  onTrigger(actions, "newProject", this, [this] { askUnsaved([this] { files_->startNew(); }); });
  onTrigger(actions, "openProject", this, [this] { askOpen(); });
  onTrigger(actions, "save", this, [this] { save(); });
  onTrigger(actions, "saveAs", this, [this] { askSaveAs(); });
  onTrigger(actions, "loadPart", this, [this] { askLoad(Side::Part); });
  onTrigger(actions, "loadBase", this, [this] { askLoad(Side::Base); });
  onTrigger(actions, "exportResult", this, [this] { askExport(); });
  onTrigger(actions, "exportPicture", this, [this] { askPicture(); });
  onTrigger(actions, "exportFrames", this, [this] { askFrames(); });
  onTrigger(actions, "quit", this, [this] { close(); });

  // During a drag, undo takes back the drag.
  onTrigger(actions, "undo", this, [this] {
    if (model_->dragging()) {
      model_->cancelDrag();
    } else {
      model_->history()->undo();
      status_->tell(tr("Undone: %1").arg(model_->history()->redoText()));
    }
  });
  onTrigger(actions, "redo", this, [this] {
    model_->history()->redo();
    status_->tell(tr("Done again: %1").arg(model_->history()->undoText()));
  });
  onTrigger(actions, "clearHistory", this, [this] { files_->forgetHistory(); });
  for (auto signal : {&QUndoStack::undoTextChanged, &QUndoStack::redoTextChanged}) {
    connect(model_->history(), signal, this, &MainWindow::showUndoTexts);
  }
  connect(model_->history(), &QUndoStack::indexChanged, this, [this] {
    status_->tell({});  // what it says was of the state before
    enableActions();
  });

  onTrigger(actions, "findAction", this, [this] { (new ActionFinder(*actions_, this))->open(); });
  onTrigger(actions, "shortcuts", this, [this] { (new ShortcutsDialog(*actions_, this))->open(); });
  onTrigger(actions, "about", this, [this] { showAbout(this); });
  connectViews();
  connectTools();
  connectFusions();
  showUndoTexts();
}

void MainWindow::connectViews() {
  const Actions& actions = *actions_;
  onTrigger(actions, "tilesMode", this, [this] { setMode(Mode::Tiles); });
  onTrigger(actions, "fusionMode", this, [this] { setMode(Mode::Fusion); });
  onTrigger(actions, "variantsMode", this, [this] { setMode(Mode::Variants); });
  onTrigger(actions, "startPage", this, [this] { setMode(Mode::Start); });

  const auto look = [this](const char* name, AxisView view) {
    onTrigger(*actions_, name, this, [this, view] {
      if (Viewport* viewport = currentViewport()) {
        viewport->lookFrom(view);
      }
    });
  };
  onTrigger(actions, "frame", this, [this] {
    if (Viewport* viewport = currentViewport()) {
      viewport->frameAll();
    }
  });
  look("front", AxisView::Front);
  look("back", AxisView::Back);
  look("right", AxisView::Right);
  look("left", AxisView::Left);
  look("top", AxisView::Top);
  look("bottom", AxisView::Bottom);
  onTrigger(actions, "otherUp", this, [this] {
    if (Viewport* viewport = currentViewport()) {
      viewport->aim(withOtherUp(viewport->camera()));
    }
  });
  connect(actions["link"], &QAction::toggled, tiles_, &TilesPage::setLinked);

  onTrigger(actions, "nextColouring", this, [this] {
    QComboBox* box = fusion_->colourBox();
    box->setCurrentIndex((box->currentIndex() + 1) % box->count());
  });
  connect(actions["seam"], &QAction::toggled, fusion_->pane(), &ResultPane::setSeamShown);
  connect(actions["edges"], &QAction::toggled, fusion_->pane(), &ResultPane::setEdgesShown);
  connect(actions["wireframe"], &QAction::toggled, fusion_->pane(), &ResultPane::setWireframe);
  fusion_->seamButton()->setDefaultAction(actions["seam"]);
  actions["seam"]->setChecked(true);

  const std::pair<const char*, Navigation> navigations[] = {{"navigateBlender", Navigation::Blender},
                                                            {"navigateCad", Navigation::Cad},
                                                            {"navigateMaya", Navigation::Maya}};
  const QString chosen = QSettings().value(kNavigationKey, "navigateBlender").toString();
  for (const auto& [name, navigation] : navigations) {
    connect(actions[name], &QAction::toggled, this, [this, name = name, navigation = navigation](bool on) {
      if (on) {
        for (Viewport* viewport : std::initializer_list<Viewport*>{
                 tiles_->pane(Side::Part), tiles_->pane(Side::Base), fusion_->pane()}) {
          viewport->setNavigation(navigation);
        }
        for (CompareWindow* comparing : findChildren<CompareWindow*>()) {
          comparing->setNavigation(navigation);
        }
        QSettings().setValue(kNavigationKey, name);
      }
    });
    actions[name]->setChecked(chosen == name);
  }
}

void MainWindow::connectTools() {
  const Actions& actions = *actions_;
  // What Space repeats.
  const auto tool = [this](const char* name, std::function<void()> what) {
    QAction* action = (*actions_)[name];
    connect(action, &QAction::triggered, this, [this, action, what = std::move(what)] {
      lastTool_ = action;
      what();
      enableActions();
    });
  };
  tool("closeLoop", [this] { editor_->close(); });
  tool("openLoop", [this] { editor_->open(); });
  tool("reverse", [this] { editor_->reverse(); });
  tool("shift", [this] { editor_->shift(); });
  tool("mirror", [this] { editor_->mirror(); });
  tool("clearLoop", [this] { editor_->clear(); });
  tool("removePairs", [this] { editor_->remove(editor_->selection()); });
  onTrigger(actions, "selectAll", this, [this] {
    QSet<int> all;
    for (int i = 0; i < static_cast<int>(model_->committed().inputs.loop.size()); ++i) {
      all.insert(i);
    }
    editor_->select(all);
  });
  onTrigger(actions, "repeat", this, [this] {
    if (lastTool_ && lastTool_->isEnabled()) {
      lastTool_->trigger();
    }
  });
  const auto preset = [&](const char* name, FCF::Preset curve) {
    tool(name, [this, curve] { model_->push(std::make_unique<SetFCFPreset>(*model_, curve)); });
  };
  preset("linear", FCF::Preset::Linear);
  preset("paste", FCF::Preset::Paste);
  preset("keepBaseSlope", FCF::Preset::KeepBaseSlope);
  preset("half", FCF::Preset::Half);
  tool("runAdjustment", [this] {
    const Fusion before = model_->committed();
    model_->push(std::make_unique<RunAdjustment>(*model_));
    if (model_->committed() == before) {
      runner_->requestAdjustment(model_->document(), model_->shown());
    }
  });
  connect(actions["paperPaths"], &QAction::triggered, this, [this](bool on) {
    Fusion after = model_->committed();
    after.inputs.paths = on ? PathMode::Paper : PathMode::Straightened;
    model_->push(std::make_unique<SetPathMode>(*model_, std::move(after)));
  });
  connect(actions["largeTile"], &QAction::triggered, this, [this](bool on) {
    Fusion after = model_->committed();
    after.inputs.tile.allowLargeTile = on;
    model_->push(std::make_unique<AllowLargeTile>(*model_, std::move(after)));
  });
  onTrigger(actions, "cancel", this, [this] {
    runner_->cancel();
    jobs_->cancel();
  });
  connect(tiles_, &TilesPage::backedOut, actions["cancel"], &QAction::trigger);
  connect(tiles_, &TilesPage::remedyWanted, this, [this](Remedy remedy) {
    const char* name = remedy == Remedy::ReverseLoop ? "reverse"
                       : remedy == Remedy::OpenLoop  ? "openLoop"
                                                     : "closeLoop";
    (*actions_)[name]->trigger();
  });

  // Keys that mean something else in the curve's editor, in lists and on buttons belong to the panes alone.
  for (const char* name : {"removePairs", "repeat", "selectAll"}) {
    actions[name]->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    removeAction(actions[name]);
    tiles_->addAction(actions[name]);
  }
  fusion_->addAction(actions["repeat"]);
  curve_->editor()->addAction(actions["repeat"]);
}

void MainWindow::connectFusions() {
  const Actions& actions = *actions_;
  onTrigger(actions, "newFusion", this, [this] { outline_->addEmpty(); });
  onTrigger(actions, "fuseOnto", this, [this] { outline_->fuseOnto(model_->shown()); });
  onTrigger(actions, "removeFusion", this, [this] { outline_->remove(model_->shown()); });
  onTrigger(actions, "renameFusion", this, [this] {
    auto* dock = findChild<QDockWidget*>("fusionsDock");
    dock->show();
    dock->raise();
    outline_->editName(model_->shown());
  });
  for (const auto& [name, side] : {std::pair("takePartMenu", Side::Part), {"takeBaseMenu", Side::Base}}) {
    QMenu* menu = actions.menu(name);
    connect(menu, &QMenu::aboutToShow, outline_,
            [this, menu, side = side] { outline_->fillTakeMenu(*menu, side); });
  }
  connect(outline_, &FusionOutline::tilesWanted, this, [this] { setMode(Mode::Tiles); });
  connect(outline_, &FusionOutline::refused, this,
          [this](const Error& error) { status_->warn(QString::fromStdString(error.message)); });
  connect(model_, &DocumentModel::documentChanged, this, &MainWindow::showTitle);
  connect(model_, &DocumentModel::changed, this, [this](Change change) {
    if (change == Change::Shown) {
      showTitle();
    }
  });
}

void MainWindow::showUndoTexts() {
  const auto show = [](QAction* action, const QString& verb, const QString& text) {
    action->setText(text.isEmpty() ? verb : QString("%1: %2").arg(verb, text));
    action->setIconText(verb);
  };
  show((*actions_)["undo"], tr("&Undo"), model_->history()->undoText());
  show((*actions_)["redo"], tr("&Redo"), model_->history()->redoText());
}

bool MainWindow::canCancel() const {
  return runner_->busy() || jobs_->busy() || variants_->pictures()->missing() > 0 ||
         (suggester_ && suggester_->busy()) || (sweep_ && sweep_->busy());
}

void MainWindow::enableActions() {
  const Fusion& fusion = model_->fusion();
  const std::size_t pairs = fusion.inputs.loop.size();
  const auto enable = [this](const char* name, bool on) { (*actions_)[name]->setEnabled(on); };
  enable("undo", model_->history()->canUndo() || model_->dragging());
  enable("redo", model_->history()->canRedo());
  enable("clearHistory", model_->history()->count() > 0);
  enable("removePairs", !editor_->selection().isEmpty());
  enable("selectAll", pairs > 0);
  enable("repeat", lastTool_ != nullptr);
  enable("closeLoop", !fusion.closed && pairs >= 3);
  enable("openLoop", fusion.closed);
  enable("reverse", pairs >= 2);
  enable("shift", pairs >= 2);
  enable("mirror", pairs >= 3);
  enable("clearLoop", pairs > 0);
  enable("runAdjustment", fusion.closed);
  adjustment_->setRunnable(fusion.closed);
  const bool fused = fusion_->shown() != nullptr;
  const bool current = fused && fusion.closed && same(fusion_->shown()->inputs, fusion.inputs);
  enable("exportResult", current);
  enable("exportPicture", fused);
  enable("exportFrames", current);
  enable("fuseOnto", fusion.part && fusion.base);
  const bool anything = model_->document().fusions.size() > 1 || fusion.part || fusion.base;
  enable("removeFusion", anything);
  enable("keepVariant", anything);
  enable("cancel", canCancel());
  (*actions_)["paperPaths"]->setChecked(fusion.inputs.paths == PathMode::Paper);
  (*actions_)["largeTile"]->setChecked(fusion.inputs.tile.allowLargeTile);
  for (const char* name : {"nextColouring", "seam", "edges", "wireframe"}) {
    enable(name, mode() == Mode::Fusion);
  }
  for (const char* name : {"frame", "front", "back", "right", "left", "top", "bottom", "otherUp"}) {
    enable(name, currentViewport() != nullptr);
  }
  enable("link", mode() == Mode::Tiles);
}

}  // namespace graftsman
