#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTreeView>
#include <QtTest>
#include <random>

#include "widgets/panels/fusion_tree_panel.h"

using namespace graftsman;

namespace {

FusionRow mesh(FusionId owner, Side side, const QString& name) {
  FusionRow row;
  row.owner = owner;
  row.side = side;
  row.name = name;
  return row;
}

FusionRow fusion(FusionId id, FusionRow part, FusionRow base) {
  FusionRow row;
  row.fusion = id;
  row.name = QString("Fusion %1").arg(id);
  row.rows = {std::move(part), std::move(base)};
  return row;
}

// The row as the part or base of another.
FusionRow as(FusionRow row, FusionId owner, Side side) {
  row.owner = owner;
  row.side = side;
  return row;
}

FusionRow nose() {
  return fusion(1, mesh(1, Side::Part, "cone.stl"), mesh(1, Side::Base, "head.obj"));
}

// Fusion 2 on the result of fusion 1.
FusionRow hornOnNose() {
  return fusion(2, mesh(2, Side::Part, "horn.stl"), as(nose(), 2, Side::Base));
}

// "2(horn.stl 1(cone.stl head.obj))".
QString told(const FusionTreeModel& model, const QModelIndex& parent = {}) {
  QStringList parts;
  for (int i = 0; i < model.rowCount(parent); ++i) {
    const QModelIndex index = model.index(i, 0, parent);
    const FusionRow& row = model.row(index);
    parts.append(row.fusion != 0 ? QString("%1(%2)").arg(row.fusion).arg(told(model, index)) : row.name);
  }
  return parts.join(' ');
}

}  // namespace

class FusionTreeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aResultIsNestedInWhatIsMadeOfIt() {
    FusionTreeModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setRows({hornOnNose()});
    QCOMPARE(told(model), QString("2(horn.stl 1(cone.stl head.obj))"));
    const QModelIndex inner = model.index(1, 0, model.index(0, 0));
    QCOMPARE(inner.data().toString(), QString("Fusion 1"));
    QCOMPARE(inner.data(Qt::ToolTipRole).toString(), QString("Base: Fusion 1"));
    QCOMPARE(inner.parent(), model.index(0, 0));
    QCOMPARE(model.rowCount(inner), 2);
    QCOMPARE(model.rowCount(model.index(0, 0, inner)), 0);
    QCOMPARE(model.find(1), inner);
    QVERIFY(!model.find(3).isValid() && !model.find(0).isValid());
  }

  void aChangeOfOneRowLeavesTheOthersAlone() {
    FusionTreeModel model;
    model.setRows({hornOnNose()});
    const QPersistentModelIndex inner = model.find(1);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    FusionRow renamed = hornOnNose();
    renamed.rows[1].rows[1].name = "other.obj";
    model.setRows({renamed});
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed[0][0].toModelIndex(), model.index(1, 0, inner));
    QVERIFY(removed.isEmpty() && inserted.isEmpty());
    // A fusion comes before it: it stays, one further down.
    FusionRow first = fusion(3, mesh(3, Side::Part, "a"), mesh(3, Side::Base, "b"));
    model.setRows({first, renamed});
    QCOMPARE(inserted.size(), 1);
    QVERIFY(removed.isEmpty());
    QCOMPARE(QModelIndex(inner).parent().row(), 1);
  }

  void anySequenceOfTreesKeepsTheModelWhole() {
    std::mt19937 random(4);
    FusionTreeModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (int step = 0; step < 200; ++step) {
      std::vector<FusionRow> rows;
      std::vector<FusionRow> made;
      for (FusionId id = 1; id <= 6; ++id) {
        const auto side = [&](Side which) {
          const bool result = !made.empty() && random() % 2 == 0;
          return result ? as(made[random() % made.size()], id, which)
                        : mesh(id, which, QString("m%1").arg(random() % 3));
        };
        made.push_back(fusion(id, side(Side::Part), side(Side::Base)));
        if (random() % 2 == 0) {
          rows.push_back(made.back());
        }
      }
      QStringList wanted;
      const std::function<QString(const FusionRow&)> text = [&](const FusionRow& row) {
        return row.fusion == 0
                   ? row.name
                   : QString("%1(%2 %3)").arg(row.fusion).arg(text(row.rows[0]), text(row.rows[1]));
      };
      for (const FusionRow& row : rows) {
        wanted.append(text(row));
      }
      model.setRows(rows);
      QCOMPARE(told(model), wanted.join(' '));
    }
  }

  void theShownOneIsBoldAndSelected() {
    FusionTreePanel panel;
    FusionRow tree = hornOnNose();
    tree.rows[1].shown = true;
    panel.setRows({tree});
    const QModelIndex inner = panel.model()->find(1);
    QCOMPARE(panel.view()->currentIndex(), inner);
    QVERIFY(panel.view()->isExpanded(panel.model()->find(2)));
    QVERIFY(inner.data(Qt::FontRole).value<QFont>().bold());
    QVERIFY(!panel.model()->find(2).data(Qt::FontRole).value<QFont>().bold());
    // What the person selected since stays while the shown one does.
    panel.view()->setCurrentIndex(panel.model()->find(2));
    tree.what = "12 faces";
    panel.setRows({tree});
    QCOMPARE(panel.view()->currentIndex(), panel.model()->find(2));
  }

  void aResultThatIsMissingSaysWhyWithAnIcon() {
    FusionTreeModel model;
    FusionRow broken = nose();
    broken.what = "no result";
    broken.problem = "The loop crosses itself.";
    model.setRows({broken});
    const QModelIndex what = model.index(0, FusionTreeModel::What);
    QVERIFY(!what.data(Qt::DecorationRole).value<QIcon>().isNull());
    QVERIFY(what.data(Qt::ToolTipRole).toString().contains("The loop crosses itself."));
    model.setRows({nose()});
    QVERIFY(!what.data(Qt::DecorationRole).isValid());
  }

  void clickAndEnterShowAndDeleteRemoves() {
    FusionTreePanel panel;
    panel.resize(360, 300);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    FusionRow tree = hornOnNose();
    tree.shown = true;
    panel.setRows({tree});
    QSignalSpy shown(&panel, &FusionTreePanel::showWanted);
    QSignalSpy removed(&panel, &FusionTreePanel::removeWanted);
    QTreeView* view = panel.view();
    const auto click = [&](const QModelIndex& index) {
      QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, view->visualRect(index).center());
    };
    click(panel.model()->find(2));
    QVERIFY2(shown.isEmpty(), "it is shown already");
    click(panel.model()->find(1));
    QCOMPARE(shown.size(), 1);
    QCOMPARE(shown[0][0].toInt(), 1);
    QTest::keyClick(view, Qt::Key_Return);
    QCOMPARE(shown.size(), 2);
    QTest::keyClick(view, Qt::Key_Delete);
    QCOMPARE(removed.size(), 1);
    QCOMPARE(removed[0][0].toInt(), 1);
    // A mesh is neither shown nor removed.
    click(panel.model()->index(0, 0, panel.model()->find(2)));
    QTest::keyClick(view, Qt::Key_Delete);
    QCOMPARE(shown.size(), 2);
    QCOMPARE(removed.size(), 1);
  }

  void f2EditsANameInPlace() {
    FusionTreePanel panel;
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    panel.setRows({hornOnNose()});
    QSignalSpy renamed(&panel, &FusionTreePanel::renameWanted);
    panel.view()->setCurrentIndex(panel.model()->find(1));
    panel.view()->setFocus();
    const auto type = [&](const QString& text, Qt::Key end) {
      QTest::keyClick(panel.view(), Qt::Key_F2);
      auto* editor = panel.view()->viewport()->findChild<QLineEdit*>();
      QVERIFY(editor);
      editor->selectAll();
      QTest::keyClicks(editor, text);
      QTest::keyClick(editor, end);
      QTRY_VERIFY(!panel.view()->viewport()->findChild<QLineEdit*>());
    };
    type(" Nose ", Qt::Key_Return);
    QCOMPARE(renamed.size(), 1);
    QCOMPARE(renamed[0][0].toInt(), 1);
    QCOMPARE(renamed[0][1].toString(), QString("Nose"));
    type("Beak", Qt::Key_Escape);
    QCOMPARE(renamed.size(), 1);
    type("Fusion 1", Qt::Key_Return);
    QVERIFY2(renamed.size() == 1, "it is its name already");
    panel.view()->setCurrentIndex(panel.model()->index(0, 0, panel.model()->find(2)));
    QTest::keyClick(panel.view(), Qt::Key_F2);
    QVERIFY2(!panel.view()->viewport()->findChild<QLineEdit*>(), "a mesh has the name of its file");
  }
};

QTEST_MAIN(FusionTreeTest)
#include "fusion_tree_test.moc"
