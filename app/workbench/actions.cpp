#include "app/workbench/actions.h"

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include "widgets/theme/icon.h"

namespace graftsman {
namespace {

// What an action is like. The texts are translated where they are used.
struct Entry {
  const char* menu;
  const char* name;  // empty: a separator; ending in "Menu": a submenu
  const char* text = "";
  const char* icon = "";
  const char* shortcut = "";
  const char* tip = "";
  const char* group = "";  // of actions of which one is checked; "-": checkable alone
};

#define TEXT(text) QT_TRANSLATE_NOOP("graftsman::Actions", text)

constexpr Entry kEntries[] = {
    {"fileMenu", "newProject", TEXT("&New"), "new", "Ctrl+N", TEXT("Start an empty project")},
    {"fileMenu", "openProject", TEXT("&Open…"), "open", "Ctrl+O", TEXT("Open a project or a scenario")},
    {"fileMenu", "recentMenu", TEXT("Open &recent")},
    {"fileMenu", "sampleMenu", TEXT("Open s&ample")},
    {"fileMenu", ""},
    {"fileMenu", "save", TEXT("&Save"), "save", "Ctrl+S", TEXT("Save the project")},
    {"fileMenu", "saveAs", TEXT("Save &as…"), "", "Ctrl+Shift+S",
     TEXT("Save the project under another name")},
    {"fileMenu", ""},
    {"fileMenu", "loadPart", TEXT("Load &part…"), "load-part", "Ctrl+Shift+P",
     TEXT("Read the mesh that is pasted")},
    {"fileMenu", "loadBase", TEXT("Load &base…"), "load-base", "Ctrl+Shift+B",
     TEXT("Read the mesh that receives the part")},
    {"fileMenu", ""},
    {"fileMenu", "exportResult", TEXT("&Export result…"), "export", "Ctrl+E",
     TEXT("Write the fused mesh to a file")},
    {"fileMenu", "exportPicture", TEXT("Export p&icture…"), "picture", "Ctrl+Shift+E",
     TEXT("Write what the result's pane shows as a picture")},
    {"fileMenu", "exportFrames", TEXT("Export &frames…"), "", "Ctrl+Alt+E",
     TEXT("Write the pictures of a film: once round the result, or from the base's shape to the part's")},
    {"fileMenu", ""},
    {"fileMenu", "quit", TEXT("&Quit"), "", "Ctrl+Q", TEXT("End the program")},

    {"editMenu", "undo", TEXT("&Undo"), "undo", "Ctrl+Z", TEXT("Undo the last edit")},
    {"editMenu", "redo", TEXT("&Redo"), "redo", "Ctrl+Shift+Z", TEXT("Do what was undone again")},
    {"editMenu", "clearHistory", TEXT("Clear the &history"), "", "",
     TEXT("Forget every step of undo and redo; the document stays as it is")},
    {"editMenu", ""},
    {"editMenu", "removePairs", TEXT("Re&move pairs"), "delete", "Del", TEXT("Remove the selected pairs")},
    {"editMenu", "selectAll", TEXT("Select &all pairs"), "", "Ctrl+A", TEXT("Select every pair")},
    {"editMenu", "repeat", TEXT("Repeat the last &tool"), "", "Space", TEXT("Do the last tool again")},

    {"viewMenu", "tilesMode", TEXT("&Tiles"), "tiles", "F2", TEXT("Part and base, with the loop on both"),
     "mode"},
    {"viewMenu", "fusionMode", TEXT("&Fusion"), "fusion", "F3", TEXT("The result and the fusion curve"),
     "mode"},
    {"viewMenu", "variantsMode", TEXT("&Variants"), "variants", "F4", TEXT("The variants that were kept"),
     "mode"},
    {"viewMenu", "startPage", TEXT("&Start page"), "", "Alt+Home", TEXT("Samples and recent projects"),
     "mode"},
    {"viewMenu", ""},
    {"viewMenu", "frame", TEXT("Fr&ame all"), "frame", "F", TEXT("Bring all of the pane's shape into view")},
    {"viewMenu", "front", TEXT("Front"), "", "1", TEXT("Look from the front")},
    {"viewMenu", "back", TEXT("Back"), "", "Ctrl+1", TEXT("Look from behind")},
    {"viewMenu", "right", TEXT("Right"), "", "3", TEXT("Look from the right")},
    {"viewMenu", "left", TEXT("Left"), "", "Ctrl+3", TEXT("Look from the left")},
    {"viewMenu", "top", TEXT("Top"), "", "7", TEXT("Look from above")},
    {"viewMenu", "bottom", TEXT("Bottom"), "", "Ctrl+7", TEXT("Look from below")},
    {"viewMenu", "otherUp", TEXT("Change what is &up"), "", "U",
     TEXT("Take y as up instead of z, or z instead of y")},
    {"viewMenu", "link", TEXT("&Link the views"), "link", "L", TEXT("Part and base turn together"), "-"},
    {"viewMenu", ""},
    {"viewMenu", "nextColouring", TEXT("Next &colours"), "", "C",
     TEXT("Colour the result by the next measure")},
    {"viewMenu", "seam", TEXT("&Seam"), "seam", "S", TEXT("Show where the part meets the base"), "-"},
    {"viewMenu", "edges", TEXT("&Edges"), "edges", "E", TEXT("Show the triangles' edges"), "-"},
    {"viewMenu", "wireframe", TEXT("&Wireframe"), "wireframe", "W", TEXT("Show the edges alone"), "-"},
    {"viewMenu", ""},
    {"viewMenu", "navigationMenu", TEXT("Mouse &navigation")},
    {"navigationMenu", "navigateBlender", TEXT("As in &Blender"), "", "",
     TEXT("Middle button turns, Shift moves"), "navigation"},
    {"navigationMenu", "navigateCad", TEXT("As in &CAD programs"), "", "",
     TEXT("Middle button moves, Shift turns"), "navigation"},
    {"navigationMenu", "navigateMaya", TEXT("As in &Maya"), "", "",
     TEXT("Alt with the buttons turns, moves, zooms"), "navigation"},
    {"viewMenu", "docksMenu", TEXT("&Panels")},

    {"fusionMenu", "closeLoop", TEXT("&Close the loop"), "close-loop", "Ctrl+Return",
     TEXT("Join the last pair to the first: the tiles appear")},
    {"fusionMenu", "openLoop", TEXT("&Open the loop"), "", "Ctrl+Shift+Return",
     TEXT("Go on adding pairs at the end")},
    {"fusionMenu", "reverse", TEXT("&Reverse"), "reverse", "R",
     TEXT("Turn the loop round: the tile is the other side")},
    {"fusionMenu", "shift", TEXT("S&hift"), "shift", "T",
     TEXT("Pair each point of the part with the base's next")},
    {"fusionMenu", "mirror", TEXT("&Mirror"), "mirror", "M",
     TEXT("Pair the part's points in the other direction")},
    {"fusionMenu", "clearLoop", TEXT("Remove &all pairs"), "clear", "Ctrl+Shift+Del",
     TEXT("Start the loop anew")},
    {"fusionMenu", ""},
    {"fusionMenu", "linear", TEXT("Curve: &Linear"), "", "Shift+1",
     TEXT("f grows evenly from seam to centre")},
    {"fusionMenu", "paste", TEXT("Curve: &Paste"), "", "Shift+2",
     TEXT("The part's shape almost up to the seam")},
    {"fusionMenu", "keepBaseSlope", TEXT("Curve: &Keep base slope"), "", "Shift+3",
     TEXT("Leaves the base's surface smoothly")},
    {"fusionMenu", "half", TEXT("Curve: &Half"), "", "Shift+4", TEXT("Half of each shape everywhere")},
    {"fusionMenu", ""},
    {"fusionMenu", "suggestions", TEXT("Su&ggestions"), "suggest", "Ctrl+G",
     TEXT("Small results of other settings, to take one by a click"), "-"},
    {"fusionMenu", "runAdjustment", TEXT("Run the ad&justment"), "run", "F5",
     TEXT("Bring the part to the base by all steps")},
    {"fusionMenu", "paperPaths", TEXT("Paths as in the pa&per"), "", "",
     TEXT("Shortest over the refined edges instead of straightened"), "-"},
    {"fusionMenu", "largeTile", TEXT("Allow a large tile"), "", "",
     TEXT("The base's tile may be most of the mesh"), "-"},
    {"fusionMenu", ""},
    {"fusionMenu", "newFusion", TEXT("&New fusion"), "", "Ctrl+Shift+N",
     TEXT("Another fusion in this project, without meshes yet")},
    {"fusionMenu", "fuseOnto", TEXT("&Fuse onto this result"), "result", "Ctrl+Shift+F",
     TEXT("Another fusion whose base is the result that is shown")},
    {"fusionMenu", "takePartMenu", TEXT("Take a result as the pa&rt")},
    {"fusionMenu", "takeBaseMenu", TEXT("Take a result as the bas&e")},
    {"fusionMenu", "renameFusion", TEXT("Rena&me the fusion"), "", "Ctrl+Shift+R",
     TEXT("Give the fusion that is shown a name")},
    {"fusionMenu", "removeFusion", TEXT("Remove the fus&ion"), "delete", "Ctrl+Shift+D",
     TEXT("What is made of its result takes its base instead")},
    {"fusionMenu", ""},
    {"fusionMenu", "cancel", TEXT("Ca&ncel"), "cancel", "Ctrl+.", TEXT("Stop what is being computed")},

    {"variantsMenu", "keepVariant", TEXT("&Keep as a variant"), "keep", "Ctrl+B",
     TEXT("Keep the present state among the variants")},
    {"variantsMenu", ""},
    {"variantsMenu", "applyVariant", TEXT("&Apply"), "", "",
     TEXT("Make the selected variant the present state: Enter or a double click")},
    {"variantsMenu", "renameVariant", TEXT("Re&name"), "", "Shift+F2",
     TEXT("Give the selected variant another name")},
    {"variantsMenu", "starVariants", TEXT("&Star"), "star", "Ctrl+D",
     TEXT("Give the selected variants a star, or take it: S")},
    {"variantsMenu", "removeVariants", TEXT("Re&move"), "delete", "",
     TEXT("Remove the selected variants: Delete")},
    {"variantsMenu", ""},
    {"variantsMenu", "giveCurve", TEXT("Give them this &curve"), "", "Ctrl+Shift+C",
     TEXT("The selected variants take the fusion curve that is shown")},
    {"variantsMenu", "giveAdjustment", TEXT("Give them this a&djustment"), "", "Ctrl+Shift+A",
     TEXT("The selected variants take the adjustment that is shown")},
    {"variantsMenu", "crossVariants", TEXT("Cross: &loop of the first, curve of the second"), "",
     "Ctrl+Shift+X", TEXT("A new variant of two: all of the first, but the curve of the one selected last")},
    {"variantsMenu", ""},
    {"variantsMenu", "compareVariants", TEXT("C&ompare"), "", "Ctrl+Shift+M",
     TEXT("Two variants beside each other, or the selected one and the present state")},
    {"variantsMenu", "sweep", TEXT("S&weep…"), "", "Ctrl+Shift+W",
     TEXT("Many variants at once: every combination of curves, adjustments and other values")},
    {"variantsMenu", "picturesFromHere", TEXT("&Pictures from this view"), "picture", "Ctrl+Shift+V",
     TEXT("Draw all variants from where the result is seen now")},

    {"helpMenu", "findAction", TEXT("&Find an action…"), "find", "Ctrl+K",
     TEXT("Find what the program can do by name")},
    {"helpMenu", "shortcuts", TEXT("&Shortcuts"), "help", "F1", TEXT("Every key and mouse button")},
    {"helpMenu", "about", TEXT("&About Graftsman"), "", "",
     TEXT("Version, licence and where the idea comes from")},
};

#undef TEXT

}  // namespace

Actions::Actions(QWidget* window) : QObject(window) {
  QHash<QString, QActionGroup*> groups;
  for (const Entry& entry : kEntries) {
    const QString name = entry.name;
    if (name.isEmpty() || name.endsWith("Menu")) {
      continue;
    }
    auto* action = new QAction(tr(entry.text), window);
    action->setObjectName(name);
    action->setShortcut(QKeySequence(entry.shortcut));
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    action->setStatusTip(tr(entry.tip));
    action->setToolTip(keys.isEmpty() ? tr(entry.tip) : tr("%1 (%2)").arg(tr(entry.tip), keys));
    action->setData(QString(entry.icon));
    const QString group = entry.group;
    action->setCheckable(!group.isEmpty());
    if (group.size() > 1) {
      if (!groups.contains(group)) {
        groups[group] = new QActionGroup(this);
      }
      groups[group]->addAction(action);
    }
    window->addAction(action);
    actions_[name] = action;
    inOrder_.append(action);
  }
  (*this)["redo"]->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  (*this)["removePairs"]->setShortcuts({QKeySequence("Del"), QKeySequence("Backspace")});
  refreshIcons();
}

void Actions::fill(QMenuBar* bar) {
  const auto add = [&](const char* name, const QString& text) {
    menus_[name] = bar->addMenu(text);
    menus_[name]->setObjectName(name);
    menus_[name]->setToolTipsVisible(true);
  };
  add("fileMenu", tr("&File"));
  add("editMenu", tr("&Edit"));
  add("viewMenu", tr("&View"));
  add("fusionMenu", tr("F&usion"));
  add("variantsMenu", tr("V&ariants"));
  add("helpMenu", tr("&Help"));
  for (const Entry& entry : kEntries) {
    QMenu* menu = menus_.value(entry.menu);
    const QString name = entry.name;
    if (name.isEmpty()) {
      menu->addSeparator();
    } else if (name.endsWith("Menu")) {
      menus_[name] = menu->addMenu(tr(entry.text));
      menus_[name]->setObjectName(name);
    } else {
      menu->addAction(actions_.value(name));
    }
  }
}

QList<QMenu*> Actions::changingMenus() const {
  QList<QMenu*> menus;
  for (const char* name : {"recentMenu", "sampleMenu", "docksMenu", "takePartMenu", "takeBaseMenu"}) {
    menus.append(menu(name));
  }
  return menus;
}

void Actions::refreshIcons() {
  for (QAction* action : std::as_const(inOrder_)) {
    const QString name = action->data().toString();
    if (!name.isEmpty()) {
      action->setIcon(icon(name));
    }
  }
}

}  // namespace graftsman
