#include <QMenu>
#include <QUndoView>

#include "app/workbench/actions.h"
#include "app/workbench/compare_window.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/main_window.h"
#include "app/workbench/status_line.h"
#include "app/workbench/sweep_dialog.h"
#include "app/workbench/variant_pictures.h"
#include "app/workbench/variants_page.h"
#include "widgets/variants/variants_gallery.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/result_pane.h"

// The window's variants: what their actions do, and the history's.
namespace graftsman {

VariantsPage::View MainWindow::resultView() const {
  const ResultPane& pane = *fusion_->pane();
  if (!fusion_->shownResults()) {
    return {};
  }
  return {fusion_->shownResults(), CameraView{pane.camera(), pane.size(), pane.devicePixelRatioF()}};
}

void MainWindow::connectVariants() {
  const auto on = [this](const char* name, auto what) {
    connect((*actions_)[name], &QAction::triggered, variants_, what);
  };
  on("keepVariant", &VariantsPage::keep);
  on("applyVariant", qOverload<>(&VariantsPage::apply));
  on("starVariants", &VariantsPage::toggleStar);
  on("removeVariants", &VariantsPage::remove);
  on("giveCurve", &VariantsPage::giveCurve);
  on("giveAdjustment", &VariantsPage::giveAdjustment);
  on("crossVariants", &VariantsPage::cross);
  on("picturesFromHere", &VariantsPage::takeView);
  connect((*actions_)["compareVariants"], &QAction::triggered, this, &MainWindow::compareVariants);
  connect((*actions_)["sweep"], &QAction::triggered, this, &MainWindow::showSweep);
  VariantsGallery* gallery = variants_->gallery();
  connect((*actions_)["renameVariant"], &QAction::triggered, gallery, &VariantsGallery::rename);
  (*actions_)["crossVariants"]->setIconText(tr("Cross"));
  (*actions_)["giveCurve"]->setIconText(tr("This curve"));
  (*actions_)["giveAdjustment"]->setIconText(tr("This adjustment"));
  (*actions_)["keepVariant"]->setIconText(tr("Keep"));
  for (const char* name : {"giveCurve", "giveAdjustment", "crossVariants"}) {
    gallery->addAction((*actions_)[name], true);
  }
  for (const char* name : {"compareVariants", "applyVariant", "starVariants", "removeVariants"}) {
    gallery->addAction((*actions_)[name], false);
  }

  connect(variants_, &VariantsPage::selectionChanged, this, &MainWindow::enableVariants);
  connect(variants_, &VariantsPage::told, status_, &StatusLine::tell);
  connect(gallery, &VariantsGallery::contextMenuWanted, this,
          [this](const QPoint& position) { actions_->menu("variantsMenu")->popup(position); });
  connect(fusion_->pane(), &ResultPane::resultsShown, variants_, &VariantsPage::requestPictures);
  connect((*actions_)["cancel"], &QAction::triggered, variants_->pictures(), &VariantPictures::cancel);
  connect(variants_->pictures(), &VariantPictures::missingChanged, this, &MainWindow::enableActions);

  auto* history = findChild<QUndoView*>("historyView");
  history->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(history, &QWidget::customContextMenuRequested, this, [this, history](const QPoint& position) {
    const QModelIndex state = history->indexAt(position);
    if (!state.isValid()) {
      return;
    }
    auto* menu = new QMenu(history);
    menu->setObjectName("historyMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* keep = menu->addAction((*actions_)["keepVariant"]->icon(), tr("Keep this state as a variant"));
    keep->setObjectName("keepState");
    connect(keep, &QAction::triggered, variants_, [this, row = state.row()] { variants_->keepState(row); });
    menu->popup(history->viewport()->mapToGlobal(position));
  });
  enableVariants();
}

void MainWindow::showSweep() {
  if (sweep_ == nullptr) {
    sweep_ = new SweepDialog(*model_, this);
    connect(sweep_, &SweepDialog::busyChanged, this, &MainWindow::enableActions);
    connect(sweep_, &SweepDialog::told, status_, &StatusLine::tell);
    connect((*actions_)["cancel"], &QAction::triggered, sweep_, &SweepDialog::cancel);
    connect(files_, &ProjectFiles::stateChanged, sweep_, [this] { sweep_->setProjectPath(files_->path()); });
    sweep_->setProjectPath(files_->path());
  }
  sweep_->show();
  sweep_->raise();
  sweep_->activateWindow();
}

void MainWindow::enableVariants() {
  const std::size_t count = variants_->selected().size();
  const auto enable = [this](const char* name, bool on) { (*actions_)[name]->setEnabled(on); };
  enable("applyVariant", count == 1);
  enable("renameVariant", count == 1);
  enable("starVariants", count > 0);
  enable("removeVariants", count > 0);
  enable("giveCurve", count > 0);
  enable("giveAdjustment", count > 0);
  enable("crossVariants", count == 2);
  enable("compareVariants", count == 1 || count == 2);
}

void MainWindow::compareVariants() {
  const std::vector<VariantId> ids = variants_->selected();
  if (ids.size() != 1 && ids.size() != 2) {
    return;
  }
  auto* window = findChild<CompareWindow*>();
  if (window == nullptr) {
    window = new CompareWindow(
        *model_, [this] { return resultView(); }, this);
    window->setNavigation(fusion_->pane()->navigation());
  }
  window->compare(ids.front(), ids.size() == 2 ? ids.back() : VariantId{0});
  window->show();
  window->raise();
  window->activateWindow();
}

}  // namespace graftsman
