#include <QAbstractItemModelTester>
#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest>

#include "widgets/panels/numbers.h"
#include "widgets/panels/pairs_model.h"
#include "widgets/panels/pairs_panel.h"
#include "widgets/panels/problem_line.h"
#include "widgets/theme/theme.h"

using namespace graftsman;

namespace {

PairRow pair(Index part, Index base, double length = 1) {
  return {SurfacePoint::atVertex(part), SurfacePoint::atVertex(base), length, 2 * length, {}};
}

std::vector<PairRow> pairs(int count) {
  std::vector<PairRow> rows;
  for (int i = 0; i < count; ++i) {
    rows.push_back(pair(100 + i, 4400 + i, 0.1 * (i + 1)));
  }
  return rows;
}

QString shown(const PairsModel& model, int row, int column, int role = Qt::DisplayRole) {
  return model.data(model.index(row, column), role).toString();
}

/// A model with a tester, its signals caught.
struct Tested {
  PairsModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};
  QSignalSpy inserted{&model, &QAbstractItemModel::rowsInserted};
  QSignalSpy removed{&model, &QAbstractItemModel::rowsRemoved};
  QSignalSpy changed{&model, &QAbstractItemModel::dataChanged};
  QSignalSpy reset{&model, &QAbstractItemModel::modelReset};

  explicit Tested(std::vector<PairRow> rows) {
    model.setRows(std::move(rows));
    inserted.clear();
  }
  [[nodiscard]] std::array<qsizetype, 4> counts() const {
    return {inserted.count(), removed.count(), changed.count(), reset.count()};
  }
};

using Counts = std::array<qsizetype, 4>;

struct ShownPanel {
  PairsPanel panel;
  QSignalSpy selection{&panel, &PairsPanel::selectionChanged};
  QSignalSpy removeWanted{&panel, &PairsPanel::removeWanted};

  explicit ShownPanel(int rows) {
    panel.model()->setRows(pairs(rows));
    panel.resize(320, 300);
    panel.show();
    panel.activateWindow();
    panel.view()->setFocus();
  }
  [[nodiscard]] bool ready() {
    return QTest::qWaitForWindowExposed(&panel) && QTest::qWaitFor([&] { return panel.view()->hasFocus(); });
  }
  void click(int row, Qt::KeyboardModifiers modifiers = {}) {
    const QRect cell = panel.view()->visualRect(panel.model()->index(row, PairsModel::BaseVertex));
    QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, modifiers, cell.center());
  }
  [[nodiscard]] QSet<int> told() const { return selection.last().first().value<QSet<int>>(); }
};

}  // namespace

class PairsPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void equalRowsTellNothing() {
    Tested tested(pairs(5));
    tested.model.setRows(pairs(5));
    QCOMPARE(tested.counts(), (Counts{0, 0, 0, 0}));
  }

  void aMovedPointChangesItsRowAlone() {
    Tested tested(pairs(5));
    auto rows = pairs(5);
    rows[2].base = SurfacePoint::atVertex(7);
    tested.model.setRows(rows);
    QCOMPARE(tested.counts(), (Counts{0, 0, 1, 0}));
    QCOMPARE(tested.changed.first().at(0).value<QModelIndex>().row(), 2);
    QCOMPARE(tested.changed.first().at(1).value<QModelIndex>().row(), 2);
    QCOMPARE(shown(tested.model, 2, PairsModel::BaseVertex), "7");
  }

  void twoFarRowsChangeWithoutThoseBetween() {
    Tested tested(pairs(6));
    auto rows = pairs(6);
    rows[1].partLength = 9;
    rows[4].problem = "wrong";
    tested.model.setRows(rows);
    QCOMPARE(tested.counts(), (Counts{0, 0, 2, 0}));
  }

  void aPairAtTheEndIsInsertedThere() {
    Tested tested(pairs(3));
    tested.model.setRows(pairs(4));
    QCOMPARE(tested.counts(), (Counts{1, 0, 0, 0}));
    QCOMPARE(tested.inserted.first().at(1).toInt(), 3);
  }

  void aPairInTheMiddleIsInsertedThere() {
    Tested tested(pairs(4));
    auto rows = pairs(4);
    rows.insert(rows.begin() + 2, pair(1, 2));
    tested.model.setRows(rows);
    QCOMPARE(tested.inserted.count(), 1);
    QCOMPARE(tested.inserted.first().at(1).toInt(), 2);
    QCOMPARE(tested.inserted.first().at(2).toInt(), 2);
    QCOMPARE(tested.counts(), (Counts{1, 0, 1, 0}));  // the rows behind have other numbers
    QCOMPARE(tested.changed.first().at(0).value<QModelIndex>().row(), 3);
    QCOMPARE(tested.model.rows(), rows);
  }

  void removedPairsAreRemovedWhereTheyWere() {
    Tested tested(pairs(6));
    auto rows = pairs(6);
    rows.erase(rows.begin() + 1, rows.begin() + 3);
    rows[0].partLength = 5;
    tested.model.setRows(rows);
    QCOMPARE(tested.removed.count(), 1);
    QCOMPARE(tested.removed.first().at(1).toInt(), 1);
    QCOMPARE(tested.removed.first().at(2).toInt(), 2);
    QCOMPARE(tested.model.rows(), rows);
    tested.model.setRows({});
    QCOMPARE(tested.model.rowCount(), 0);
    QCOMPARE(tested.reset.count(), 0);
  }

  void anyRowsAfterAnyOthersAreShownRight() {
    Tested tested({});
    QRandomGenerator random(11);
    for (int i = 0; i < 300; ++i) {
      std::vector<PairRow> rows = tested.model.rows();
      for (int k = 0; k < 3; ++k) {
        const auto at = rows.begin() + static_cast<std::ptrdiff_t>(random.bounded(quint64(rows.size() + 1)));
        if (random.bounded(2) == 0 || at == rows.end()) {
          rows.insert(at, pair(random.bounded(9), random.bounded(9)));
        } else {
          rows.erase(at);
        }
      }
      tested.model.setRows(rows);
      QCOMPARE(tested.model.rows(), rows);
    }
    QCOMPARE(tested.reset.count(), 0);
  }

  void aRowReadsAsAPersonWouldSayIt() {
    PairsModel model;
    PairRow half;
    half.part = SurfacePoint{-1, 17, {0.2, 0.3, 0.5}};
    PairRow wrong = pair(812, 4410, 0.31234);
    wrong.problem = "Path 1 → 2 crosses path 3 → 4.";
    model.setRows({half, wrong});
    QCOMPARE(shown(model, 0, PairsModel::Number), "0");
    QCOMPARE(shown(model, 0, PairsModel::PartVertex), "face 17");
    QVERIFY(shown(model, 0, PairsModel::PartVertex, Qt::ToolTipRole).contains("0.200, 0.300, 0.500"));
    QCOMPARE(shown(model, 0, PairsModel::BaseVertex), "–");
    QVERIFY(shown(model, 0, PairsModel::BaseVertex, Qt::ToolTipRole).contains("Not picked yet"));
    QCOMPARE(shown(model, 0, PairsModel::PartLength), "–");
    QVERIFY(shown(model, 0, PairsModel::Number, Qt::AccessibleTextRole).contains("half made"));
    QCOMPARE(shown(model, 1, PairsModel::PartVertex), "812");
    QCOMPARE(shown(model, 1, PairsModel::PartLength), "0.312");
    QCOMPARE(shown(model, 1, PairsModel::BaseLength), "0.625");
    QCOMPARE(shown(model, 1, PairsModel::Problem), wrong.problem);
    QVERIFY(!model.data(model.index(1, PairsModel::Problem), Qt::DecorationRole).value<QIcon>().isNull());
    QVERIFY(!model.data(model.index(0, PairsModel::Problem), Qt::DecorationRole).isValid());
  }

  void theSwatchHasTheSpheresColourAndIsHollowForAHalfPair() {
    PairsModel model;
    PairRow half;
    half.part = SurfacePoint::atVertex(1);
    model.setRows({pair(1, 2), pair(3, 4), half});
    const auto middle = [&](int row) {
      const QIcon swatch = model.data(model.index(row, 0), Qt::DecorationRole).value<QIcon>();
      return swatch.pixmap(QSize(36, 36), 1.0).toImage().pixelColor(18, 18);
    };
    QCOMPARE(middle(1), cvColour(1));
    QCOMPARE(middle(2).alpha(), 0);
  }

  void lengthsHaveNoFalseDigits() {
    QCOMPARE(significant(0.0123456, 3), "0.0123");
    QCOMPARE(significant(0.9996, 3), "1.00");
    QCOMPARE(significant(12.345, 3), "12.3");
    QCOMPARE(significant(1234.5, 3), QLocale().toString(1234.5, 'f', 0));
    QCOMPARE(significant(0, 3), "0");
    QCOMPARE(significant(1.5e-7, 3), "1.50e-07");
    QCOMPARE(significant(-2.5, 3), "-2.50");
  }

  void aClickSelectsARowAndShiftSeveral() {
    ShownPanel shown(6);
    QVERIFY(shown.ready());
    shown.click(1);
    QCOMPARE(shown.told(), QSet<int>{1});
    shown.click(3, Qt::ShiftModifier);
    QCOMPARE(shown.told(), (QSet<int>{1, 2, 3}));
    shown.click(5, Qt::ControlModifier);
    QCOMPARE(shown.told(), (QSet<int>{1, 2, 3, 5}));
  }

  void arrowKeysSelectRows() {
    ShownPanel shown(4);
    QVERIFY(shown.ready());
    shown.click(0);
    QTest::keyClick(shown.panel.view(), Qt::Key_Down);
    QCOMPARE(shown.told(), QSet<int>{1});
    QTest::keyClick(shown.panel.view(), Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(shown.told(), (QSet<int>{1, 2}));
  }

  void aSelectionSetFromOutsideIsShownSilently() {
    ShownPanel shown(40);
    QVERIFY(shown.ready());
    shown.panel.setSelected({30, 31});
    QCOMPARE(shown.selection.count(), 0);
    QCOMPARE(shown.panel.view()->selectionModel()->selectedRows().size(), 2);
    const QRect row = shown.panel.view()->visualRect(shown.panel.model()->index(30, 0));
    QVERIFY2(shown.panel.view()->viewport()->rect().contains(row.center()), "scrolled to the first");
    shown.panel.setSelected({});
    QVERIFY(!shown.panel.view()->selectionModel()->hasSelection());
    QCOMPARE(shown.selection.count(), 0);
  }

  void aFlashedRowIsScrolledToAndLeavesTheSelection() {
    ShownPanel shown(40);
    QVERIFY(shown.ready());
    shown.panel.setSelected({2});
    shown.panel.flashRow(33);
    QTableView* view = shown.panel.view();
    const QRect row = view->visualRect(shown.panel.model()->index(33, 0));
    QVERIFY(view->viewport()->rect().contains(row.center()));
    auto* flash = view->findChild<QWidget*>("flash");
    QVERIFY(flash && flash->geometry().contains(row.center()));
    QCOMPARE(view->selectionModel()->selectedRows().size(), 1);
    QCOMPARE(shown.selection.count(), 0);
  }

  void aSelectionSurvivesAnInsertionBefore() {
    ShownPanel shown(5);
    QVERIFY(shown.ready());
    shown.click(3);
    auto rows = pairs(5);
    rows.insert(rows.begin() + 1, pair(1, 2));
    shown.panel.model()->setRows(rows);
    QCOMPARE(shown.selection.count(), 2);
    QCOMPARE(shown.told(), QSet<int>{4});  // the same pair, its new number
    shown.panel.model()->setRows(pairs(3));
    QCOMPARE(shown.told(), QSet<int>{});
  }

  void deleteAsksToRemoveTheSelectedPairs() {
    ShownPanel shown(5);
    QVERIFY(shown.ready());
    QTest::keyClick(shown.panel.view(), Qt::Key_Delete);
    QCOMPARE(shown.removeWanted.count(), 0);
    shown.panel.setSelected({1, 2});
    QTest::keyClick(shown.panel.view(), Qt::Key_Delete);
    QCOMPARE(shown.removeWanted.count(), 1);
    QCOMPARE(shown.removeWanted.first().first().value<QSet<int>>(), (QSet<int>{1, 2}));
    QCOMPARE(shown.panel.model()->rowCount(), 5);  // a wish
  }

  void aShortcutOfTheWindowDoesNotTakeDeleteAway() {
    QMainWindow window;
    auto* panel = new PairsPanel;
    window.setCentralWidget(panel);
    QAction remove("Delete");
    remove.setShortcut(Qt::Key_Delete);
    window.addAction(&remove);
    panel->model()->setRows(pairs(3));
    window.show();
    window.activateWindow();
    panel->view()->setFocus();
    QVERIFY(QTest::qWaitFor([&] { return panel->view()->hasFocus(); }));
    panel->setSelected({2});
    QSignalSpy wanted(panel, &PairsPanel::removeWanted);
    QSignalSpy triggered(&remove, &QAction::triggered);
    QTest::keyClick(window.windowHandle(), Qt::Key_Delete);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(triggered.count(), 0);
  }

  void anEmptyTableSaysHowToBegin() {
    ShownPanel shown(0);
    QVERIFY(shown.ready());
    const auto* empty = shown.panel.findChild<QLabel*>("pairsEmpty");
    QVERIFY(empty->isVisible());
    QVERIFY(empty->text().contains("Click a point on the part"));
    shown.panel.model()->setRows(pairs(1));
    QVERIFY(!empty->isVisible());
  }

  void theLineBelowTellsWhatComesNextOrWhatIsWrong() {
    ShownPanel shown(3);
    QVERIFY(shown.ready());
    shown.panel.setNext("next: on the base");
    const auto* line = shown.panel.findChild<ProblemLine*>("pairsNext");
    QCOMPARE(line->findChild<QLabel*>("problemText")->text(), "next: on the base");
    auto rows = pairs(3);
    rows[1].problem = "Path 1 → 2 runs along path 2 → 0.";
    shown.panel.model()->setRows(rows);
    QVERIFY(line->problem().isEmpty());
    shown.click(1);
    QCOMPARE(line->problem(), rows[1].problem);
    shown.panel.model()->setRows(pairs(3));
    QVERIFY(line->problem().isEmpty());
  }

  void everyColumnFitsIntoThreeHundredAndTwentyPixels() {
    ShownPanel shown(12);
    QVERIFY(shown.ready());
    const QHeaderView* header = shown.panel.view()->horizontalHeader();
    QVERIFY2(header->length() <= shown.panel.view()->viewport()->width(),
             qPrintable(QString::number(header->length())));
  }
};

QTEST_MAIN(PairsPanelTest)
#include "pairs_panel_test.moc"
