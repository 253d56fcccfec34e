#include "app/workbench/help_dialogs.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "app/workbench/actions.h"
#include "widgets/theme/icon.h"

namespace graftsman {
namespace {

QString plainText(const QAction* action) {
  return action->text().remove('&').remove(QChar(0x2026));
}

QTableWidget* table(const QStringList& headers) {
  auto* table = new QTableWidget(0, static_cast<int>(headers.size()));
  table->setHorizontalHeaderLabels(headers);
  table->verticalHeader()->hide();
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setShowGrid(false);
  table->setTabKeyNavigation(false);
  table->horizontalHeader()->setStretchLastSection(true);
  return table;
}

void addRow(QTableWidget* table, const QStringList& texts) {
  const int row = table->rowCount();
  table->insertRow(row);
  for (int column = 0; column < texts.size(); ++column) {
    table->setItem(row, column, new QTableWidgetItem(texts[column]));
  }
}

}  // namespace

ActionFinder::ActionFinder(const Actions& actions, QWidget* parent)
    : QDialog(parent), actions_(actions), words_(new QLineEdit), found_(new QListWidget) {
  setObjectName("actionFinder");
  setWindowTitle(tr("Find an action"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(480, 360);
  words_->setObjectName("actionWords");
  words_->setAccessibleName(tr("Words of the action"));
  words_->setPlaceholderText(tr("What do you want to do?"));
  words_->installEventFilter(this);
  found_->setObjectName("actionsFound");
  found_->setAccessibleName(tr("Actions found"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(words_);
  layout->addWidget(found_);
  connect(words_, &QLineEdit::textChanged, this, &ActionFinder::list);
  connect(words_, &QLineEdit::returnPressed, this, &ActionFinder::run);
  connect(found_, &QListWidget::itemActivated, this, &ActionFinder::run);
  collect();
  list({});
}

void ActionFinder::collect() {
  for (QAction* action : actions_.all()) {
    all_.append({action, plainText(action), action->statusTip()});
  }
  for (QMenu* menu : actions_.changingMenus()) {
    Q_EMIT menu->aboutToShow();  // some are filled only then
    for (QAction* action : menu->actions()) {
      all_.append({action, plainText(menu->menuAction()) + QStringLiteral(" ▸ ") + plainText(action), {}});
    }
  }
}

void ActionFinder::list(const QString& words) {
  found_->clear();
  const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
  for (int i = 0; i < all_.size(); ++i) {
    const Candidate& candidate = all_[i];
    if (!candidate.action) {
      continue;
    }
    const QString text = candidate.name + ' ' + candidate.tip;
    bool matches = true;
    for (const QString& word : wanted) {
      matches = matches && text.contains(word, Qt::CaseInsensitive);
    }
    if (!matches) {
      continue;
    }
    const QString keys = candidate.action->shortcut().toString(QKeySequence::NativeText);
    auto* item =
        new QListWidgetItem(candidate.action->icon(),
                            keys.isEmpty() ? candidate.name : QString("%1   (%2)").arg(candidate.name, keys));
    item->setToolTip(candidate.tip);
    item->setData(Qt::UserRole, i);
    if (!candidate.action->isEnabled()) {
      item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    found_->addItem(item);
  }
  found_->setCurrentRow(0);
}

void ActionFinder::run() {
  const QListWidgetItem* item = found_->currentItem();
  if (item && (item->flags() & Qt::ItemIsEnabled)) {
    const QPointer<QAction> action = all_[item->data(Qt::UserRole).toInt()].action;
    accept();
    if (action) {
      action->trigger();
    }
  }
}

bool ActionFinder::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step != 0) {
      found_->setCurrentRow(std::clamp(found_->currentRow() + step, 0, std::max(found_->count() - 1, 0)));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

ShortcutsDialog::ShortcutsDialog(const Actions& actions, QWidget* parent) : QDialog(parent) {
  setObjectName("shortcutsDialog");
  setWindowTitle(tr("Shortcuts"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(640, 560);
  QTableWidget* keys = table({tr("Key"), tr("Action"), tr("What it does")});
  keys->setObjectName("shortcutsTable");
  for (const QAction* action : actions.all()) {
    if (!action->shortcut().isEmpty()) {
      addRow(keys, {QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText),
                    plainText(action), action->statusTip()});
    }
  }
  for (const auto& [key, what, tip] : std::initializer_list<std::array<QString, 3>>{
           {tr("Enter"), tr("Close the loop"), tr("In a pane; or pick, where the keyboard's cursor is")},
           {tr("Esc"), tr("Back out"), tr("A drag, a half-made pair, the selection")},
           {tr("Arrows"), tr("Walk"), tr("Over the mesh's vertices in a pane; move a point of the curve")},
           {tr("Enter"), tr("Apply"), tr("In Variants mode: the selected variant becomes the present state")},
           {tr("S"), tr("Star"), tr("In Variants mode: give the selected variants a star, or take it")},
           {tr("F2"), tr("Rename"), tr("In the list of fusions")},
           {tr("Del"), tr("Remove"), tr("In Variants mode and in the list of fusions: what is selected")}}) {
    addRow(keys, {key, what, tip});
  }
  keys->resizeColumnsToContents();

  QTableWidget* mouse = table({tr("Mouse"), tr("What it does")});
  mouse->setObjectName("mouseTable");
  for (const auto& [button, what] : std::initializer_list<std::pair<QString, QString>>{
           {tr("Left click"), tr("Pick a vertex; with Ctrl the very point")},
           {tr("Left drag on a CV"), tr("Move it along the surface")},
           {tr("Left click on a path"), tr("Insert a pair there")},
           {tr("Double click"), tr("The view turns about this point")},
           {tr("Right click"), tr("What can be done here")},
           {tr("Wheel"), tr("Zoom to the pointer")},
           {tr("Blender"), tr("Middle: turn. Shift+middle: move. Ctrl+middle: zoom")},
           {tr("CAD"), tr("Middle: move. Shift+middle: turn. Ctrl+middle: zoom")},
           {tr("Maya"), tr("Alt+left: turn. Alt+middle: move. Alt+right: zoom")}}) {
    addRow(mouse, {button, what});
  }
  mouse->resizeColumnsToContents();

  auto* tabs = new QTabWidget;
  tabs->addTab(keys, tr("Keyboard"));
  tabs->addTab(mouse, tr("Mouse"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(tabs);
  layout->addWidget(buttons);
}

void showAbout(QWidget* parent) {
  auto* box = new QMessageBox(parent);
  box->setObjectName("aboutBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowTitle(QDialog::tr("About Graftsman"));
  box->setIconPixmap(applicationIcon().pixmap(64));
  box->setText(
      QDialog::tr("<b>Graftsman %1</b><p>A workbench for mesh fusion.</p>"
                  "<p>After T. Kanai, H. Suzuki, J. Mitani, F. Kimura: “Interactive Mesh Fusion Based on "
                  "Local 3D Metamorphosis”, 1999.</p><p>GPL-3.0-or-later, without any warranty.</p>")
          .arg(GRAFTSMAN_VERSION));
  box->open();
}

}  // namespace graftsman
