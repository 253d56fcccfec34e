#pragma once

#include <QMainWindow>
#include <memory>

#include "app/document/document_model.h"
#include "app/document/stage_runner.h"
#include "app/workbench/project_files.h"
#include "app/workbench/variants_page.h"

class QDockWidget;
class QFileDialog;
class QStackedWidget;

namespace graftsman {

class Actions;
class AdjustmentPanel;
class Autosave;
class FusionCurvePanel;
class FusionOutline;
class FusionPage;
class JobQueue;
class LoopEditor;
class PairsPanel;
class StagesPanel;
class StartPage;
class StatusLine;
class SuggestionStrip;
class Suggester;
class SweepDialog;
class TilesPage;
class Viewport;

/// The workbench's window: creates its parts, lays them out, connects them.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// `recoveryFolder`: where unsaved states are kept, and looked for by offerRecovery().
  explicit MainWindow(const QString& recoveryFolder, QWidget* parent = nullptr);
  ~MainWindow() override;

  enum class Mode { Start, Tiles, Fusion, Variants };
  void setMode(Mode mode);
  [[nodiscard]] Mode mode() const;

  [[nodiscard]] DocumentModel& model() const { return *model_; }
  [[nodiscard]] StageRunner& runner() const { return *runner_; }
  [[nodiscard]] JobQueue& jobs() const { return *jobs_; }
  [[nodiscard]] ProjectFiles& files() const { return *files_; }
  [[nodiscard]] Autosave& autosave() const { return *autosave_; }
  [[nodiscard]] const Actions& actions() const { return *actions_; }
  [[nodiscard]] FusionPage& fusionPage() const { return *fusion_; }
  [[nodiscard]] VariantsPage& variantsPage() const { return *variants_; }
  [[nodiscard]] Suggester& suggester() const { return *suggester_; }

  /// Opens a project or a scenario, or a mesh as the side that is still missing.
  void openFile(const QString& path);
  /// Turns every pane to where its mesh is best seen from at first.
  void lookAtFirst();
  /// If a crash left something behind, asks what to do with it.
  void offerRecovery();
  /// What the result's pane shows, as a picture.
  [[nodiscard]] QImage resultPicture(const QSize& size);

 Q_SIGNALS:
  /// The stages have caught up with the document: what the panes show is its present state.
  void settled();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  // main_window.cpp
  void connectDocument();
  void connectPanels();
  void requestRun(StageRunner::Urgency urgency);
  void showOutcome(const std::shared_ptr<const Outcome>& outcome);
  void showBusy();
  [[nodiscard]] bool canCancel() const;
  void showTitle();
  [[nodiscard]] Viewport* currentViewport() const;

  // window_layout.cpp
  void makePanels();
  void makeToolBar();
  [[nodiscard]] QDockWidget* addDock(const QString& name, const QString& title, QWidget* content);
  void showDocksOf(Mode mode);
  void shareDocks(Mode mode);
  [[nodiscard]] int docksHeight() const;  // of all above each other
  [[nodiscard]] int lowerDocks() const;   // the height of those that both modes have; 0: not known yet
  void restoreLayout();
  void saveLayout() const;

  // window_actions.cpp
  void connectActions();
  void connectViews();
  void connectTools();
  void connectFusions();
  void enableActions();
  void showUndoTexts();

  // window_variants.cpp
  [[nodiscard]] VariantsPage::View resultView() const;
  void connectVariants();
  void enableVariants();
  void compareVariants();
  void showSweep();

  // window_suggestions.cpp
  void makeSuggestions();
  void showSuggestions(bool shown);

  // window_files.cpp
  [[nodiscard]] ProjectView projectView();
  void connectFiles();
  void fillRecentMenu();
  void askOpen();
  void askLoad(Side side);
  void save();
  void askSaveAs(std::function<void()> then = {});
  void askExport();
  void askPicture();
  void askFrames();
  /// Calls `then` at once if nothing is unsaved, else when the person has saved or let go.
  void askUnsaved(std::function<void()> then);
  [[nodiscard]] QFileDialog* fileDialog(const QString& name, const QString& title, const QString& filter);
  void showDamage(const QString& message);

  DocumentModel* model_;
  StageRunner* runner_;
  JobQueue* jobs_;
  LoopEditor* editor_;
  Actions* actions_;
  ProjectFiles* files_ = nullptr;
  Autosave* autosave_ = nullptr;
  QString recoveryFolder_;

  QStackedWidget* pages_;
  StartPage* start_;
  TilesPage* tiles_;
  FusionPage* fusion_;
  VariantsPage* variants_;
  PairsPanel* pairs_;
  FusionCurvePanel* curve_;
  AdjustmentPanel* adjustment_;
  StagesPanel* stages_;
  FusionOutline* outline_;
  StatusLine* status_;
  SuggestionStrip* suggestions_ = nullptr;
  Suggester* suggester_ = nullptr;
  SweepDialog* sweep_ = nullptr;  // once it was asked for
  QDockWidget* pairsDock_ = nullptr;
  QDockWidget* curveDock_ = nullptr;
  QDockWidget* adjustmentDock_ = nullptr;
  QList<QDockWidget*> sharedDocks_;
  bool laidOut_ = false;      // as the person left it the last time
  bool docksShared_ = false;  // the docks of the mode have their heights
  int lowerDocks_ = 0;        // height of those that both modes have; 0: not known yet
  QAction* lastTool_ = nullptr;
  bool closing_ = false;  // the person has answered what to do with unsaved work
};

}  // namespace graftsman
