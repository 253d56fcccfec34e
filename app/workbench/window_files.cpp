#include <QBuffer>
#include <QCloseEvent>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>

#include "app/document/loop_editor.h"
#include "app/document/stage_runner.h"
#include "app/workbench/actions.h"
#include "app/workbench/autosave.h"
#include "app/workbench/frames_dialog.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/job_queue.h"
#include "app/workbench/main_window.h"
#include "app/workbench/samples.h"
#include "app/workbench/start_page.h"
#include "app/workbench/status_line.h"
#include "app/workbench/sweep_dialog.h"
#include "app/workbench/tiles_page.h"
#include "app/workbench/variant_pictures.h"
#include "app/workbench/view_state.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/result_pane.h"

// The window's files: dialogs, drops, what is asked before unsaved work would be lost.
namespace graftsman {
namespace {

constexpr auto kFolderKey = "files/folder";
constexpr QSize kThumbnail(256, 256);

QString meshFilter() {
  return MainWindow::tr("Meshes (*.obj *.ply *.stl *.off);;All files (*)");
}

bool isProjectName(const QString& path) {
  return path.endsWith(".graft", Qt::CaseInsensitive) || path.endsWith(".json", Qt::CaseInsensitive);
}

}  // namespace

ProjectView MainWindow::projectView() {
  return {[this]() -> std::string {
            if (!fusion_->shown()) {
              return {};
            }
            QByteArray bytes;
            QBuffer buffer(&bytes);
            fusion_->pane()->picture(kThumbnail).save(&buffer, "PNG");
            return bytes.toStdString();
          },
          [this] { return writeViewState(*this); },
          [this](const std::string& state) { readViewState(state, *this); },
          [this] { return variants_->pictures()->files(model_->document().variants); },
          [this](const Document& document, std::map<VariantId, std::string> files) {
            variants_->pictures()->restore(document.variants, std::move(files));
          }};
}

void MainWindow::connectFiles() {
  connect(files_, &ProjectFiles::stateChanged, this, &MainWindow::showTitle);
  connect(files_, &ProjectFiles::told, status_, &StatusLine::tell);
  connect(files_, &ProjectFiles::failed, this, &MainWindow::showDamage);
  connect(autosave_, &Autosave::failed, this,
          [this](const QString& message) { status_->warn(tr("Autosave failed: %1").arg(message)); });
  connect(tiles_, &TilesPage::loadWanted, this, [this](Side side, const QString& path) {
    if (isProjectName(path)) {
      openFile(path);
    } else {
      files_->importMesh(side, path);
    }
  });
  connect(fusion_->pane(), &Viewport::fileDropped, this, &MainWindow::openFile);
  connect(start_, &StartPage::openWanted, this, &MainWindow::openFile);
  connect(start_, &StartPage::loadWanted, this, &MainWindow::askLoad);
  connect(start_, &StartPage::openDialogWanted, this, &MainWindow::askOpen);
  connect(files_, &ProjectFiles::stateChanged, this, [this] {
    fillRecentMenu();
    start_->setRecent(ProjectFiles::recent());
  });
  QMenu* samples = actions_->menu("sampleMenu");
  for (const Sample& sample : findSamples()) {
    connect(samples->addAction(sample.title), &QAction::triggered, this,
            [this, path = sample.path] { openFile(path); });
  }
  fillRecentMenu();
  start_->setRecent(ProjectFiles::recent());

  connect(tiles_, &TilesPage::contextMenuWanted, this,
          [this](const QPoint& position) { actions_->menu("fusionMenu")->popup(position); });
  connect(fusion_, &FusionPage::contextMenuWanted, this,
          [this](const QPoint& position) { actions_->menu("viewMenu")->popup(position); });
}

void MainWindow::fillRecentMenu() {
  QMenu* menu = actions_->menu("recentMenu");
  menu->clear();
  for (const QString& path : ProjectFiles::recent()) {
    QAction* action = menu->addAction(QFileInfo(path).fileName());
    action->setToolTip(path);
    connect(action, &QAction::triggered, this, [this, path] { openFile(path); });
  }
  menu->setEnabled(!menu->isEmpty());
}

void MainWindow::openFile(const QString& path) {
  if (isProjectName(path)) {
    askUnsaved([this, path] { files_->open(path); });
    return;
  }
  files_->importMesh(model_->fusion().part ? Side::Base : Side::Part, path);
}

QFileDialog* MainWindow::fileDialog(const QString& name, const QString& title, const QString& filter) {
  auto* dialog = new QFileDialog(this, title, QSettings().value(kFolderKey).toString(), filter);
  dialog->setObjectName(name);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QFileDialog::fileSelected, this,
          [](const QString& path) { QSettings().setValue(kFolderKey, QFileInfo(path).absolutePath()); });
  return dialog;
}

void MainWindow::askOpen() {
  QFileDialog* dialog =
      fileDialog("openDialog", tr("Open"), tr("Projects and scenarios (*.graft *.json);;All files (*)"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openFile);
  dialog->open();
}

void MainWindow::askLoad(Side side) {
  QFileDialog* dialog =
      fileDialog("loadDialog", side == Side::Part ? tr("Load part") : tr("Load base"), meshFilter());
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, side](const QString& path) { files_->importMesh(side, path); });
  dialog->open();
}

void MainWindow::save() {
  if (files_->path().isEmpty()) {
    askSaveAs();
  } else {
    files_->save(files_->path());
  }
}

void MainWindow::askSaveAs(std::function<void()> then) {
  QFileDialog* dialog = fileDialog("saveDialog", tr("Save the project"), tr("Graftsman projects (*.graft)"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("graft");
  dialog->selectFile(files_->name() + ".graft");
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, then = std::move(then)](const QString& path) { files_->save(path, then); });
  dialog->open();
}

void MainWindow::askExport() {
  QFileDialog* dialog = fileDialog("exportDialog", tr("Export the result"),
                                   tr("Meshes (*.obj *.ply *.stl *.off);;Morph from base to part (*.glb)"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("obj");
  dialog->selectFile(files_->name() + ".obj");
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.contains("*.glb") ? "glb" : "obj");
  });
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    files_->exportResult(path, std::make_shared<const FusionResults>(*fusion_->shown()));
  });
  dialog->open();
}

void MainWindow::askPicture() {
  QFileDialog* dialog = fileDialog("pictureDialog", tr("Export a picture"), tr("Pictures (*.png *.jpg)"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("png");
  dialog->selectFile(files_->name() + ".png");
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    if (fusion_->pane()->picture().save(path)) {
      status_->tell(tr("Wrote %1").arg(path));
    } else {
      showDamage(tr("%1: cannot be written. Choose another folder or name.").arg(path));
    }
  });
  dialog->open();
}

void MainWindow::askFrames() {
  const VariantsPage::View view = resultView();
  if (!view.results || !view.results->fused) {
    return;
  }
  auto* dialog = new FramesDialog(this);
  connect(dialog, &FramesDialog::accepted, this, [this, dialog, view] {
    const QString folder = dialog->folder();
    jobs_->start<Result<void>>(
        tr("Exporting frames"),
        [view, folder, film = dialog->film()](const Progress& progress) {
          return writeFrames(std::filesystem::path(folder.toStdU16String()), *view.results,
                             withCameras(film, *view.results, view.pane), progress);
        },
        [this, folder, count = dialog->film().count](const Result<void>& written) {
          if (written) {
            status_->tell(tr("Exported %1 frames to %2").arg(count).arg(QDir::toNativeSeparators(folder)));
          } else if (written.error().code == ErrorCode::Cancelled) {
            status_->tell(
                tr("Cancelled. The frames that were done are in %1").arg(QDir::toNativeSeparators(folder)));
          } else {
            showDamage(QString::fromStdString(written.error().message));
          }
        },
        JobQueue::AtEnd::Stop);
    enableActions();
  });
  dialog->open();
}

void MainWindow::askUnsaved(std::function<void()> then) {
  if (model_->history()->isClean()) {
    then();
    return;
  }
  auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                              tr("“%1” has unsaved changes.").arg(files_->name()),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName("unsavedBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(tr("Save them first, or let them go?"));
  box->setDefaultButton(QMessageBox::Save);
  connect(box, &QMessageBox::finished, this, [this, then = std::move(then)](int answer) {
    if (answer == QMessageBox::Discard) {
      then();
    } else if (answer == QMessageBox::Save && files_->path().isEmpty()) {
      askSaveAs(then);
    } else if (answer == QMessageBox::Save) {
      files_->save(files_->path(), then);
    }
  });
  box->open();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!closing_ && !model_->history()->isClean()) {
    event->ignore();
    askUnsaved([this] {
      closing_ = true;
      close();
    });
    return;
  }
  if (sweep_ != nullptr) {
    sweep_->abandon();
  }
  saveLayout();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.first().isLocalFile()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  openFile(event->mimeData()->urls().first().toLocalFile());
}

void MainWindow::showDamage(const QString& message) {
  status_->warn(message);
}

void MainWindow::offerRecovery() {
  const std::vector<Recoverable> found = Autosave::findRecoverable(recoveryFolder_);
  if (found.empty()) {
    return;
  }
  const Recoverable& left = found.front();
  const QString name = left.originalPath.isEmpty()
                           ? tr("an unsaved project")
                           : tr("“%1”").arg(QFileInfo(left.originalPath).completeBaseName());
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Recover unsaved work"),
                              tr("Graftsman ended unexpectedly with unsaved changes in %1.").arg(name),
                              QMessageBox::NoButton, this);
  box->setObjectName("recoveryBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(tr("They were last kept at %1. Recover them now?")
                              .arg(QLocale().toString(left.savedAt, QLocale::ShortFormat)));
  QPushButton* recover = box->addButton(tr("Recover"), QMessageBox::AcceptRole);
  QPushButton* later = box->addButton(tr("Ask again later"), QMessageBox::RejectRole);
  QPushButton* discard = box->addButton(tr("Throw them away"), QMessageBox::DestructiveRole);
  recover->setObjectName("recover");
  later->setObjectName("recoverLater");
  discard->setObjectName("recoverDiscard");
  box->setDefaultButton(recover);
  box->setEscapeButton(later);
  connect(recover, &QPushButton::clicked, this, [this, left] {
    connect(
        files_, &ProjectFiles::opened, autosave_, [this, left] { autosave_->adopt(left); },
        Qt::SingleShotConnection);
    files_->recover(left.path, left.originalPath);
  });
  connect(discard, &QPushButton::clicked, this, [this, left] {
    Autosave::discard(left);
    offerRecovery();
  });
  box->open();
}

}  // namespace graftsman
