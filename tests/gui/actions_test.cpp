#include <QAccessible>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QTableWidget>

#include "tests/support/workbench.h"

using namespace graftsman;

class ActionsTest : public QObject {
  Q_OBJECT

 private:
  static void closeDialogs(const Workbench& bench) {
    for (QDialog* dialog : bench.window->findChildren<QDialog*>()) {
      dialog->reject();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

 private Q_SLOTS:
  void everyActionIsReachedByItsShortcut() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    for (QAction* action : bench.window->actions().all()) {
      if (action->shortcut().isEmpty() || action->objectName() == "quit") {
        continue;
      }
      // The panes' own keys work in Tiles mode.
      bench.window->setMode(action->objectName() == "nextColouring" || action->objectName() == "seam" ||
                                    action->objectName() == "edges" || action->objectName() == "wireframe"
                                ? MainWindow::Mode::Fusion
                                : MainWindow::Mode::Tiles);
      bench.window->activateWindow();
      bench.pane(Side::Base)->setFocus();
      if (bench.window->mode() == MainWindow::Mode::Fusion) {
        bench.resultPane()->setFocus();
      }
      QWidget* focused = QApplication::focusWidget();
      QVERIFY(focused);
      action->setEnabled(true);
      QSignalSpy triggered(action, &QAction::triggered);
      for (const QKeySequence& keys : action->shortcuts()) {
        action->setEnabled(true);
        QTest::keySequence(focused, keys);
      }
      QVERIFY2(triggered.size() >= action->shortcuts().size(), qPrintable(action->objectName()));
      closeDialogs(bench);
      QVERIFY(bench.settle());
    }
  }

  void noTwoActionsShareAShortcut() {
    Workbench bench;
    QHash<QKeySequence, QString> taken;
    for (const QAction* action : bench.window->actions().all()) {
      for (const QKeySequence& keys : action->shortcuts()) {
        QVERIFY2(!taken.contains(keys), qPrintable(action->objectName() + " and " + taken.value(keys)));
        taken[keys] = action->objectName();
      }
    }
  }

  void everyActionHasATextATipAndAPlaceInTheMenus() {
    Workbench bench;
    for (const QAction* action : bench.window->actions().all()) {
      QVERIFY2(!action->text().isEmpty() && !action->statusTip().isEmpty(), qPrintable(action->objectName()));
      bool inMenu = false;
      for (QObject* object : action->associatedObjects()) {
        inMenu = inMenu || qobject_cast<QMenu*>(object);
      }
      QVERIFY2(inMenu, qPrintable(action->objectName()));
    }
  }

  void everyWidgetThatAPersonTouchesHasANameForTestsAndForReaders() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QStringList nameless;
    for (const QWidget* widget : bench.window->findChildren<QWidget*>()) {
      const bool internal = widget->isHidden() || widget->objectName().startsWith("qt_") ||
                            widget->inherits("QMenu") || widget->inherits("QTabBar") ||
                            widget->inherits("QScrollBar") ||
                            QString(widget->metaObject()->className()).startsWith("QDockWidget") ||
                            QString(widget->metaObject()->className()).startsWith("QToolBar");
      if (internal || widget->focusPolicy() == Qt::NoFocus) {
        continue;
      }
      const QString what =
          QString("%1 “%2” in %3")
              .arg(widget->metaObject()->className(), widget->objectName(),
                   widget->parentWidget() ? widget->parentWidget()->objectName() : QString());
      QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
      if (widget->objectName().isEmpty() || !accessible || accessible->text(QAccessible::Name).isEmpty()) {
        nameless.append(what);
      }
    }
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join("; ")));
  }

  void anActionIsFoundByItsText() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    bench.action("findAction")->trigger();
    auto* words = bench.window->findChild<QLineEdit*>("actionWords");
    QVERIFY(words);
    QTest::keyClicks(words, "keep base");
    auto* found = bench.window->findChild<QListWidget*>("actionsFound");
    QCOMPARE(found->count(), 1);
    QTest::keyClick(words, Qt::Key_Return);
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::KeepBaseSlope));
  }

  void theShortcutsAreListed() {
    Workbench bench;
    bench.action("shortcuts")->trigger();
    auto* table = bench.window->findChild<QTableWidget*>("shortcutsTable");
    QVERIFY(table && table->rowCount() > 30);
  }

  void theLayoutIsRemembered() {
    QTemporaryDir folder;
    {
      Workbench bench(folder.path());
      bench.window->resize(1100, 700);
      bench.window->close();
    }
    MainWindow again(folder.path());
    QCOMPARE(again.size(), QSize(1100, 700));
  }
};

QTEST_MAIN(ActionsTest)
#include "actions_test.moc"
