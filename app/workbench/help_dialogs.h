#pragma once

#include <QAction>
#include <QDialog>
#include <QList>
#include <QPointer>

class QLineEdit;
class QListWidget;

namespace graftsman {

class Actions;

/// Finds an action by what it is called or says of itself, and runs it: also samples, recent projects,
/// panels, and results to take.
class ActionFinder : public QDialog {
  Q_OBJECT

 public:
  ActionFinder(const Actions& actions, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Candidate {
    QPointer<QAction> action;
    QString name;
    QString tip;
  };

  void collect();
  void list(const QString& words);
  void run();

  const Actions& actions_;
  QLineEdit* words_ = nullptr;
  QListWidget* found_ = nullptr;
  QList<Candidate> all_;
};

/// Every shortcut, and what the mouse does in each navigation.
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  ShortcutsDialog(const Actions& actions, QWidget* parent);
};

/// "About Graftsman".
void showAbout(QWidget* parent);

}  // namespace graftsman
