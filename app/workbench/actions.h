#pragma once

#include <QAction>
#include <QHash>
#include <QList>
#include <QObject>

class QMenu;
class QMenuBar;

namespace graftsman {

/// Every action of the program, once: found by its object name, by text (find an action) and by shortcut.
/// What an action does is connected by the window.
class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QWidget* window);

  /// Precondition: there is one of that name.
  [[nodiscard]] QAction* operator[](const QString& name) const { return actions_.value(name); }
  [[nodiscard]] const QList<QAction*>& all() const { return inOrder_; }

  /// Fills the menu bar: File, Edit, View, Fusion, Help.
  void fill(QMenuBar* bar);
  /// The menu of that object name ("recentMenu", …).
  [[nodiscard]] QMenu* menu(const QString& name) const { return menus_.value(name); }

  /// The submenus whose entries are none of all(): recent projects, samples, panels, results to take. Some
  /// are filled when they are about to show.
  [[nodiscard]] QList<QMenu*> changingMenus() const;

  /// Loads each icon again, after the palette changed.
  void refreshIcons();

 private:
  QHash<QString, QAction*> actions_;
  QList<QAction*> inOrder_;
  QHash<QString, QMenu*> menus_;
};

}  // namespace graftsman
