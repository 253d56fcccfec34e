#include "app/workbench/actions.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/main_window.h"
#include "app/workbench/status_line.h"
#include "app/workbench/suggester.h"
#include "widgets/variants/suggestion_strip.h"
#include "widgets/viewport/result_pane.h"

#include <QListView>
#include <QToolButton>

// The strip of suggestions under the result: closed until the person opens it, and then as it was left.
namespace graftsman {

void MainWindow::makeSuggestions() {
  suggestions_ = new SuggestionStrip(fusion_);
  fusion_->addBelow(suggestions_);
  suggester_ = new Suggester(
      *model_, *runner_, *suggestions_, [this] { return resultView(); }, this);

  QAction* action = (*actions_)["suggestions"];
  action->setIconText(tr("Suggest…"));
  fusion_->suggestButton()->setDefaultAction(action);
  connect(action, &QAction::triggered, this, &MainWindow::showSuggestions);
  connect(suggestions_, &SuggestionStrip::closeWanted, action, &QAction::trigger);
  connect(suggestions_, &SuggestionStrip::left, fusion_->pane(), [this] { fusion_->pane()->setFocus(); });
  connect(suggester_, &Suggester::told, status_, &StatusLine::tell);
  connect(suggester_, &Suggester::busyChanged, this, &MainWindow::enableActions);
  connect(fusion_->pane(), &Viewport::cameraChanged, suggester_, &Suggester::moveView);
  connect((*actions_)["picturesFromHere"], &QAction::triggered, suggester_, &Suggester::takeView);
  connect((*actions_)["cancel"], &QAction::triggered, suggester_, &Suggester::cancel);
}

// In another mode than Fusion the action leads to the strip rather than closing it out of sight.
void MainWindow::showSuggestions(bool shown) {
  const bool elsewhere = mode() != Mode::Fusion;
  if (elsewhere) {
    setMode(Mode::Fusion);
  }
  suggestions_->setVisible(shown || elsewhere);
  (*actions_)["suggestions"]->setChecked(shown || elsewhere);
  if (suggestions_->isVisible()) {
    suggestions_->view()->setFocus();
  } else {
    fusion_->pane()->setFocus();
  }
}

}  // namespace graftsman
