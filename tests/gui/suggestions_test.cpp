#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QSettings>
#include <QToolButton>
#include <algorithm>

#include "app/document/commands.h"
#include "app/workbench/suggester.h"
#include "tests/support/stacked.h"
#include "tests/support/workbench.h"
#include "widgets/panels/elided_label.h"
#include "widgets/variants/suggestion_strip.h"
#include "widgets/variants/suggestions_model.h"

using namespace graftsman;

namespace {

// The strip under a test's hands.
struct StripHands {
  const Workbench& bench;

  [[nodiscard]] SuggestionStrip* strip() const {
    return bench.window->findChild<SuggestionStrip*>("suggestionStrip");
  }
  [[nodiscard]] QListView* view() const { return strip()->view(); }
  [[nodiscard]] QComboBox* orders() const { return bench.window->findChild<QComboBox*>("suggestionsOrder"); }
  [[nodiscard]] QString reason() const {
    return bench.window->findChild<QLabel*>("suggestionsReason")->text();
  }
  [[nodiscard]] QString sentence() const {
    return bench.window->findChild<ElidedLabel*>("suggestionsSentence")->text();
  }
  void open() const { QTest::keyClick(bench.window.get(), Qt::Key_G, Qt::ControlModifier); }

  [[nodiscard]] int count() const { return strip()->model()->rowCount(); }
  [[nodiscard]] QVariant data(int row, int role = Qt::DisplayRole) const {
    return strip()->model()->index(row).data(role);
  }
  [[nodiscard]] QStringList shown() const {
    QStringList shown;
    for (int row = 0; row < count(); ++row) {
      shown.append(data(row).toString() + " | " + data(row, SuggestionsModel::Measure).toString());
    }
    return shown;
  }
  /// Rows that are marked as the document's state.
  [[nodiscard]] QList<int> taken() const {
    QList<int> taken;
    for (int row = 0; row < count(); ++row) {
      if (data(row, SuggestionsModel::Taken).toBool()) {
        taken.append(row);
      }
    }
    return taken;
  }
  [[nodiscard]] bool outdated() const { return strip()->model()->outdated(); }
  void click(int row) const {
    const QModelIndex index = strip()->model()->index(row);
    view()->scrollTo(index);
    QTest::mouseClick(view()->viewport(), Qt::LeftButton, {}, view()->visualRect(index).center());
  }
  /// An edit that no suggestion is like.
  void edit() const {
    AdjustmentSettings settings = bench.fusion().inputs.adjustment;
    settings.falloff += 0.7;
    bench.window->model().push(std::make_unique<SetAdjustment>(bench.window->model(), settings));
  }
  /// True once nothing is looked for and every suggestion has its picture.
  [[nodiscard]] bool ready() const {
    return QTest::qWaitFor(
        [this] {
          if (bench.window->runner().busy() || bench.window->suggester().busy() || outdated() ||
              count() == 0) {
            return false;
          }
          for (int row = 0; row < count(); ++row) {
            if (data(row, SuggestionsModel::Picture).value<QImage>().isNull()) {
              return false;
            }
          }
          return true;
        },
        kPatienceMs);
  }
};

}  // namespace

// Suggestions for the fusion that is shown, with real mouse and keys on the real window.
class SuggestionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void theStripIsClosedAtFirstAndNothingIsLookedFor() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QVERIFY(!hands.strip()->isVisible());
    QVERIFY(!bench.window->suggester().busy());
    QTest::mouseClick(bench.window->findChild<QToolButton*>("suggest"), Qt::LeftButton);
    QVERIFY(hands.strip()->isVisible());
    QVERIFY(bench.action("suggestions")->isChecked());
    QVERIFY(hands.ready());
    QTest::mouseClick(bench.window->findChild<QToolButton*>("suggestionsClose"), Qt::LeftButton);
    QVERIFY(!hands.strip()->isVisible());
    QVERIFY(!bench.action("suggestions")->isChecked());
  }

  void theNextStartHasItAsItWasLeft() {
    for (const bool open : {false, true, true, false}) {
      {
        Workbench bench;
        const StripHands hands{bench};
        bench.window->setMode(MainWindow::Mode::Fusion);
        if (hands.strip()->isVisible() != open) {
          hands.open();
        }
        QVERIFY(bench.window->close());
      }
      Workbench bench;
      const StripHands hands{bench};
      QCOMPARE(bench.action("suggestions")->isChecked(), open);
      QVERIFY(!hands.strip()->isVisible());  // on the start page
      QVERIFY(bench.openSample("fig4c_cone_sphere"));
      bench.window->setMode(MainWindow::Mode::Fusion);
      QCOMPARE(hands.strip()->isVisible(), open);
      QVERIFY(!open || hands.ready());
    }
  }

  void aClickTakesOneInOneStepAndTheStripStays() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    hands.open();
    QVERIFY(hands.ready());
    QVERIFY2(hands.count() >= 6 && hands.count() <= 9, qPrintable(QString::number(hands.count())));
    QVERIFY(hands.taken().isEmpty());
    // All pictures differ, and so do the words.
    const QStringList shown = hands.shown();
    QCOMPARE(QSet<QString>(shown.begin(), shown.end()).size(), shown.size());
    for (int a = 0; a < hands.count(); ++a) {
      for (int b = 0; b < a; ++b) {
        QVERIFY(hands.data(a, SuggestionsModel::Picture) != hands.data(b, SuggestionsModel::Picture));
      }
    }

    const Fusion before = bench.fusion();
    QUndoStack& history = *bench.window->model().history();
    const int steps = history.count();
    hands.click(2);
    QCOMPARE(history.count(), steps + 1);
    QCOMPARE(history.undoText(), "Take suggestion: " + hands.data(2).toString());
    QVERIFY(!(bench.fusion() == before));
    QVERIFY(bench.settle());
    QVERIFY(hands.ready());
    QCOMPARE(hands.taken(), QList<int>{2});
    QCOMPARE(hands.shown(), shown);
    QVERIFY(bench.window->fusionPage().shown()->fused->points ==
            update(bench.fusion().inputs, {}, {}).fused->points);

    // From one to the next: each is one step, from the same present state.
    hands.click(hands.count() - 1);
    QCOMPARE(history.count(), steps + 2);
    QVERIFY(hands.ready());
    QCOMPARE(hands.taken(), QList<int>{hands.count() - 1});
    hands.click(hands.count() - 1);
    QCOMPARE(history.count(), steps + 2);  // it is so already

    bench.action("undo")->trigger();
    QVERIFY(hands.ready());
    QCOMPARE(hands.taken(), QList<int>{2});
    bench.action("undo")->trigger();
    QVERIFY(bench.fusion() == before);
    QVERIFY(hands.ready());
    QVERIFY(hands.taken().isEmpty());
    QCOMPARE(hands.shown(), shown);
  }

  void keysGoThroughThemAndEnterTakes() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    hands.open();
    QVERIFY(hands.ready());
    QVERIFY(hands.view()->hasFocus());
    QTest::keyClick(hands.view(), Qt::Key_Right);
    QTest::keyClick(hands.view(), Qt::Key_Right);
    QTest::keyClick(hands.view(), Qt::Key_Left);
    QCOMPARE(hands.view()->currentIndex().row(), 1);
    QTest::keyClick(hands.view(), Qt::Key_Return);
    QVERIFY(hands.ready());
    QCOMPARE(hands.taken(), QList<int>{1});
    QTest::keyClick(hands.view(), Qt::Key_Escape);
    QVERIFY(bench.resultPane()->hasFocus());
    QVERIFY(hands.strip()->isVisible());
  }

  void theBoxChoosesAndSortsByAnotherMeasure() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    hands.open();
    QVERIFY(hands.ready());
    const QStringList bySeam = hands.shown();
    const QString sentence = hands.sentence();
    QVERIFY2(sentence.contains("angle at the seam"), qPrintable(sentence));
    QVERIFY(bySeam.front().contains(QString::fromUtf8("°")));
    hands.orders()->setFocus();
    for (int i = 0; i < 3; ++i) {
      QTest::keyClick(hands.orders(), Qt::Key_Down);
    }
    QCOMPARE(hands.orders()->currentText(), QString("Distance, greatest first"));
    QVERIFY(hands.ready());
    QVERIFY(hands.shown() != bySeam);
    QVERIFY(hands.sentence() != sentence);
    QVERIFY(hands.shown().front().contains("away"));
    QTest::keyClick(hands.orders(), Qt::Key_Home);
    QVERIFY(hands.ready());
    QCOMPARE(hands.shown(), bySeam);
  }

  void editsBringOthers() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    hands.open();
    QVERIFY(hands.ready());
    const QStringList before = hands.shown();
    hands.edit();
    // What is shown is of the state before, and is not to be taken.
    QTRY_VERIFY_WITH_TIMEOUT(hands.outdated() || hands.shown() != before, kPatienceMs);
    QVERIFY(hands.ready());
    QVERIFY(hands.shown() != before);
    // Another fusion altogether.
    QVERIFY(bench.window->model().history()->canUndo());
    bench.window->model().history()->setClean();
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    QVERIFY(hands.ready());
    hands.click(0);
    QVERIFY(hands.ready());
    QCOMPARE(hands.taken(), QList<int>{0});
  }

  void anOutdatedOneIsNotTaken() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    hands.open();
    QVERIFY(hands.ready());
    const int steps = bench.window->model().history()->count();
    hands.edit();
    hands.click(0);
    QCOMPARE(bench.window->model().history()->count(), steps + 1);  // the edit alone
    QVERIFY(hands.ready());
  }

  void withoutAClosedLoopASentenceSaysWhatToDo() {
    Workbench bench;
    const StripHands hands{bench};
    bench.window->setMode(MainWindow::Mode::Fusion);
    hands.open();
    QTRY_VERIFY_WITH_TIMEOUT(hands.reason().contains("load a part and a base"), kPatienceMs);
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QVERIFY(hands.ready());
    QVERIFY(hands.reason().isEmpty());
    bench.action("openLoop")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(hands.reason().contains("close the loop"), kPatienceMs);
    QCOMPARE(hands.count(), 0);
    QVERIFY(!bench.window->suggester().busy());
    bench.action("closeLoop")->trigger();
    QVERIFY(hands.ready());
  }

  void aFusionThatFailsSaysWhy() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    hands.open();
    QVERIFY(hands.ready());
    bench.action("reverse")->trigger();  // the tile is most of the sphere
    QTRY_VERIFY_WITH_TIMEOUT(!hands.reason().isEmpty() && !bench.window->suggester().busy(), kPatienceMs);
    QCOMPARE(hands.count(), 0);
    bench.action("undo")->trigger();
    QVERIFY(hands.ready());
  }

  void cancelStopsTheSearchAndOpeningTheStripAgainGoesOn() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    hands.open();
    QTRY_VERIFY_WITH_TIMEOUT(hands.sentence().startsWith("Looking"), kPatienceMs);
    QVERIFY(bench.action("cancel")->isEnabled());
    bench.action("cancel")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(hands.sentence().startsWith("Cancelled"), kPatienceMs);
    QCOMPARE(hands.count(), 0);
    QVERIFY(!bench.window->suggester().busy());
    hands.open();
    hands.open();
    QVERIFY(hands.ready());
  }

  void anotherModeLooksForNothingAndTheActionLeadsBack() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    hands.open();
    QVERIFY(hands.ready());
    const QStringList before = hands.shown();
    bench.window->setMode(MainWindow::Mode::Tiles);
    hands.edit();
    QVERIFY(bench.settle());
    QVERIFY(!bench.window->suggester().busy());
    QCOMPARE(hands.shown(), before);
    hands.open();
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Fusion);
    QVERIFY(hands.strip()->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(hands.shown() != before, kPatienceMs);
    QVERIFY(hands.ready());
  }

  void picturesFollowTheView() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    hands.open();
    QVERIFY(hands.ready());
    const auto before = hands.data(0, SuggestionsModel::Picture).value<QImage>();
    QTest::keyClick(bench.resultPane(), Qt::Key_3);
    QTRY_VERIFY_WITH_TIMEOUT(hands.data(0, SuggestionsModel::Picture).value<QImage>() != before, kPatienceMs);
    QVERIFY(hands.ready());
  }

  void aFusionOnAResultHasSuggestionsAsWell() {
    Workbench bench;
    const StripHands hands{bench};
    bench.window->model().reset(samples::twoConesOnASphere(), 2);
    bench.window->setMode(MainWindow::Mode::Fusion);
    QVERIFY(bench.settle());
    hands.open();
    QVERIFY(hands.ready());
    hands.click(1);
    QVERIFY(hands.ready());
    QCOMPARE(hands.taken(), QList<int>{1});
    Evaluated nothing;
    QVERIFY(bench.window->fusionPage().shown()->fused->points ==
            evaluate(bench.window->model().document().fusions, 2, nothing, {}).results.fused->points);
    // The fusion below is another one: other suggestions.
    bench.window->model().show(1);
    QVERIFY(hands.ready());
    QVERIFY(hands.taken().isEmpty());
  }

  void aTakenOneStaysThePresentStateInAnotherOrder() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig8b_cone_nose"));
    hands.open();
    QVERIFY(hands.ready());
    hands.click(0);
    QVERIFY(hands.ready());
    const QString taken = hands.data(0).toString();
    const QStringList before = hands.shown();
    hands.orders()->setCurrentIndex(3);
    QVERIFY(hands.ready());
    hands.orders()->setCurrentIndex(0);
    QVERIFY(hands.ready());
    QCOMPARE(hands.shown(), before);
    QCOMPARE(hands.data(hands.taken().value(0, -1)).toString(), taken);
  }

  void theWindowClosesDuringTheSearch() {
    Workbench bench;
    const StripHands hands{bench};
    QVERIFY(bench.openSample("fig9b_bird_plane"));
    hands.open();
    QTRY_VERIFY_WITH_TIMEOUT(bench.window->suggester().busy(), kPatienceMs);
    bench.window->model().history()->setClean();
    bench.window.reset();
  }
};

QTEST_MAIN(SuggestionsTest)
#include "suggestions_test.moc"
