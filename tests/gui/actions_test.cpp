#include <QAccessible>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableWidget>

#include "tests/support/panes.h"
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
                            widget->inherits("QScrollBar") || widget->inherits("QComboBoxListView") ||
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

  // Every control on every page: its tooltip, and in it the shortcut where there is one.
  void everyControlHasATooltipWithItsShortcut() {
    Workbench bench;
    QStringList without;
    const auto look = [&] {
      for (const QWidget* widget : bench.window->findChildren<QWidget*>()) {
        const bool control = widget->inherits("QAbstractButton") || widget->inherits("QAbstractSpinBox") ||
                             widget->inherits("QComboBox");
        const bool ours =
            !widget->objectName().startsWith("qt_") && !widget->inherits("QDockWidgetTitleButton") &&
            widget->objectName() != "ScrollLeftButton" && widget->objectName() != "ScrollRightButton";
        if (control && ours && widget->isVisible() && widget->toolTip().isEmpty()) {
          without.append(widget->objectName());
        }
      }
    };
    look();
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    look();
    bench.window->setMode(MainWindow::Mode::Tiles);
    look();
    QVERIFY2(without.isEmpty(), qPrintable(without.join(", ")));
    const std::pair<const char*, const char*> shortcuts[] = {{"startLoadPart", "loadPart"},
                                                             {"startLoadBase", "loadBase"},
                                                             {"startOpen", "openProject"},
                                                             {"presetLinear", "linear"},
                                                             {"presetPaste", "paste"},
                                                             {"presetKeepBaseSlope", "keepBaseSlope"},
                                                             {"presetHalf", "half"},
                                                             {"runAdjustment", "runAdjustment"},
                                                             {"seam", "seam"},
                                                             {"colouring", "nextColouring"},
                                                             {"statusCancel", "cancel"}};
    for (const auto& [widget, action] : shortcuts) {
      const auto* control = bench.window->findChild<QWidget*>(widget);
      QVERIFY2(control, widget);
      const QString keys = bench.action(action)->shortcut().toString(QKeySequence::NativeText);
      QVERIFY2(control->toolTip().contains(QString("(%1").arg(keys)), qPrintable(control->toolTip()));
    }
  }

  void tabFollowsReadingOrder() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    for (const MainWindow::Mode mode : {MainWindow::Mode::Tiles, MainWindow::Mode::Fusion}) {
      bench.window->setMode(mode);
      QStringList order;
      QWidget* const first = QApplication::focusWidget();
      do {
        const QWidget* now = QApplication::focusWidget();
        order.append(now->objectName());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      } while (QApplication::focusWidget() != first && order.size() < 60);
      const QStringList wanted =
          mode == MainWindow::Mode::Tiles
              ? QStringList{"partPane", "basePane", "pairsView",     "rigidStep",    "scaleStep",
                            "epsilon",  "falloff",  "maxIterations", "runAdjustment"}
              : QStringList{"resultPane", "presetLinear", "presetHalf",    "fusionCurveEditor",
                            "pointF",     "monotone",     "rigidStep",     "scaleStep",
                            "epsilon",    "falloff",      "maxIterations", "runAdjustment"};
      QStringList found;
      const auto start = order.indexOf(wanted.first());
      for (int i = 0; i < order.size(); ++i) {
        const QString& name = order[(start + i) % order.size()];
        if (wanted.contains(name)) {
          found.append(name);
        }
      }
      QVERIFY2(found == wanted, qPrintable(order.join(" ")));
    }
  }

  void theNavigationIsChosenAndRemembered() {
    QTemporaryDir folder;
    const std::pair<const char*, Qt::KeyboardModifiers> pans[] = {{"navigateCad", Qt::NoModifier},
                                                                  {"navigateBlender", Qt::ShiftModifier}};
    for (const auto& [name, modifiers] : pans) {
      {
        Workbench bench;
        bench.action(name)->trigger();
      }
      Workbench bench;
      QVERIFY(bench.action(name)->isChecked());
      QVERIFY(bench.openSample("fig4c_cone_sphere"));
      const Camera before = bench.resultPane()->camera();
      panes::drag(*bench.resultPane(), {200, 200}, {240, 220}, Qt::MiddleButton, modifiers);
      const Camera after = bench.resultPane()->camera();
      // Moved, not turned.
      QVERIFY(((after.position - after.pivot) - (before.position - before.pivot)).norm() < 1e-9);
      QVERIFY((after.pivot - before.pivot).norm() > 0);
    }
  }

  void keysOfTheViewGoToThePaneUnderThePointer() {
    Workbench bench;
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    bench.window->setMode(MainWindow::Mode::Tiles);
    MeshPane* part = bench.pane(Side::Part);
    MeshPane* base = bench.pane(Side::Base);
    part->setFocus();
    QTest::mouseMove(base, base->rect().center());
    QTRY_VERIFY(base->underMouse());
    const Camera partBefore = part->camera();
    std::vector<Eigen::Vector3d> seen;
    for (const auto& [key, modifiers] :
         {std::pair{Qt::Key_1, Qt::NoModifier}, {Qt::Key_3, Qt::NoModifier}, {Qt::Key_7, Qt::NoModifier}}) {
      QTest::keyClick(part, key, modifiers);
      const Camera camera = base->camera();
      seen.push_back((camera.position - camera.pivot).normalized());
      QTest::keyClick(part, key, Qt::ControlModifier);
      const Camera other = base->camera();
      QVERIFY((seen.back() + (other.position - other.pivot).normalized()).norm() < 1e-6);
    }
    QVERIFY(std::abs(seen[0].dot(seen[1])) < 1e-6 && std::abs(seen[0].dot(seen[2])) < 1e-6);
    QTest::keyClick(part, Qt::Key_F);
    QVERIFY(part->camera() == partBefore);
  }

  void darkAndLightFollowThePalette() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const QPalette light = QApplication::palette();
    const QImage before = bench.resultPane()->picture();
    QApplication::setPalette(panes::darkPalette());
    QCoreApplication::processEvents();
    const QImage dark = bench.resultPane()->picture();
    QVERIFY(dark.pixelColor(3, 3).lightness() < 100 && before.pixelColor(3, 3).lightness() > 200);
    QApplication::setPalette(light);
    QCoreApplication::processEvents();
    QVERIFY(bench.resultPane()->picture() == before);
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

  void whatSubmenusHoldIsFoundToo() {
    Workbench bench;
    bench.action("findAction")->trigger();
    auto* words = bench.window->findChild<QLineEdit*>("actionWords");
    auto* found = bench.window->findChild<QListWidget*>("actionsFound");
    QTest::keyClicks(words, "take result part");
    QCOMPARE(found->count(), 1);  // "There is no other fusion"
    QVERIFY(!(found->item(0)->flags() & Qt::ItemIsEnabled));
    words->clear();
    QTest::keyClicks(words, "open sample penguin");
    QCOMPARE(found->count(), 1);
    QTest::keyClick(words, Qt::Key_Return);
    QTRY_VERIFY(bench.fusion().part);
    QVERIFY(QString::fromStdString(bench.fusion().part->name).contains("penguin"));
    QVERIFY(bench.settle());
  }

  void theShortcutsAreListed() {
    Workbench bench;
    bench.action("shortcuts")->trigger();
    auto* table = bench.window->findChild<QTableWidget*>("shortcutsTable");
    QVERIFY(table && table->rowCount() > 30);
  }

  void theDocksKeepTheirHeightsWhenTheModeChanges() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    auto* curve = bench.window->findChild<QWidget*>("curveDock");
    auto* pairs = bench.window->findChild<QWidget*>("pairsDock");
    auto* adjustment = bench.window->findChild<QDockWidget*>("adjustmentDock");
    // At first the adjustment needs no scrolling, and the curve has room.
    auto* scroll = bench.window->findChild<QScrollArea*>("adjustmentScroll");
    QTRY_VERIFY(scroll->verticalScrollBar()->maximum() == 0);
    const int first = curve->height();
    QVERIFY2(first > 300, qPrintable(QString::number(first)));
    bench.window->setMode(MainWindow::Mode::Tiles);
    QTRY_VERIFY2(std::abs(pairs->height() - first) < 8,
                 qPrintable(QString("%1 %2").arg(pairs->height()).arg(first)));
    // The person gives the lower docks less.
    bench.window->resizeDocks({static_cast<QDockWidget*>(pairs), adjustment}, {480, 180}, Qt::Vertical);
    QCoreApplication::processEvents();
    const int given = pairs->height();
    for (const MainWindow::Mode mode :
         {MainWindow::Mode::Fusion, MainWindow::Mode::Tiles, MainWindow::Mode::Fusion}) {
      bench.window->setMode(mode);
      QWidget* upper = mode == MainWindow::Mode::Tiles ? pairs : curve;
      QTRY_VERIFY2(std::abs(upper->height() - given) < 8, qPrintable(QString::number(upper->height())));
    }
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

  void theDocksKeepTheirHeightsFromOneStartToTheNext() {
    std::vector<int> heights;
    for (int start = 0; start < 4; ++start) {
      Workbench bench;
      QVERIFY(bench.openSample("fig4c_cone_sphere"));
      auto* curve = bench.window->findChild<QDockWidget*>("curveDock");
      auto* adjustment = bench.window->findChild<QDockWidget*>("adjustmentDock");
      if (start == 0) {
        bench.window->resizeDocks({curve, adjustment}, {400, 300}, Qt::Vertical);
      } else {
        QTRY_VERIFY2(std::abs(curve->height() - heights.back()) < 8,
                     qPrintable(QString("%1 %2").arg(curve->height()).arg(heights.back())));
      }
      QCoreApplication::processEvents();
      heights.push_back(curve->height());
      bench.window->close();
    }
    QVERIFY2(std::abs(heights.back() - heights.front()) < 8, qPrintable(QString::number(heights.back())));
  }

  void aLongMessageDoesNotWidenTheWindow() {
    Workbench bench;
    const QSize before = bench.window->size();
    const QString name = QString(200, 'n') + ".graft";
    const QString path = bench.folder.filePath(name);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("garbage");
    file.close();
    bench.window->openFile(path);
    QVERIFY(bench.settle());
    QVERIFY2(bench.status().contains(QString(100, 'n')), qPrintable(bench.status()));
    QCoreApplication::processEvents();
    QVERIFY(bench.window->minimumSizeHint().width() <= before.width());
    QCOMPARE(bench.window->size(), before);
  }
};

QTEST_MAIN(ActionsTest)
#include "actions_test.moc"
