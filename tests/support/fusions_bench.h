#pragma once

#include <QAbstractButton>
#include <QDockWidget>
#include <QLineEdit>
#include <QTreeView>

#include "app/document/commands.h"
#include "core/project/edits.h"
#include "core/project/evaluate.h"
#include "tests/support/stacked.h"
#include "tests/support/workbench.h"
#include "widgets/panels/elided_label.h"
#include "widgets/panels/fusion_tree_panel.h"
#include "widgets/panels/pairs_model.h"

namespace graftsman {

// The window with a hand on its tree.
struct Bench : Workbench {
  [[nodiscard]] DocumentModel& model() const { return window->model(); }
  [[nodiscard]] const FusionList& fusions() const { return model().document().fusions; }
  [[nodiscard]] FusionTreePanel* tree() const { return window->findChild<FusionTreePanel*>(); }
  void raiseTree() const { window->findChild<QDockWidget*>("fusionsDock")->raise(); }
  [[nodiscard]] const std::vector<Point>& fused() const {
    return window->fusionPage().shown()->fused->points;
  }
  // Whether the window shows what the shown fusion comes to when everything is computed afresh.
  [[nodiscard]] bool showsTheResult() const {
    Evaluated nothing;
    const FusionResults fresh = evaluate(fusions(), model().shown(), nothing, {}).results;
    return fresh.fused && window->fusionPage().shown() && fresh.fused->points == fused() &&
           fresh.fused->faces() == window->fusionPage().shown()->fused->faces();
  }
  void clickRow(FusionId id) const {
    raiseTree();
    QTreeView* view = tree()->view();
    view->scrollTo(tree()->model()->find(id));
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                      view->visualRect(tree()->model()->find(id)).center());
  }
  [[nodiscard]] QWidget* frame(Side side) const {
    return window->findChild<QWidget*>(side == Side::Part ? "partFrame" : "baseFrame");
  }
  [[nodiscard]] QString problem(Side side) const {
    auto* icon = frame(side)->findChild<QLabel*>("problemIcon");
    return icon->isHidden() ? QString() : frame(side)->findChild<QLabel*>("problemText")->text();
  }
  [[nodiscard]] QAbstractButton* remedy(Side side) const {
    return frame(side)->findChild<QAbstractButton*>("remedy");
  }
  [[nodiscard]] QString title(Side side) const {
    return frame(side)->findChild<ElidedLabel*>("paneTitle")->text();
  }
  [[nodiscard]] QString pairProblem(int row) const {
    const auto* model = window->findChild<PairsModel*>();
    return model->index(row, PairsModel::Problem).data().toString();
  }
  void name(FusionId id, const QString& name) const {
    raiseTree();
    tree()->editName(id);
    typeName(id, name);
  }
  // Into the editor that is open in the tree.
  void typeName(FusionId id, const QString& name) const {
    auto* editor = tree()->view()->viewport()->findChild<QLineEdit*>();
    if (!editor) {
      qFatal("no editor of the name");
    }
    editor->selectAll();
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(QString::fromStdString(find(fusions(), id)->name), name);
  }
};

}  // namespace graftsman
