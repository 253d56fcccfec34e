#include "app/workbench/frames_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include "app/workbench/variant_pictures.h"
#include "core/picture/fusion_view.h"
#include "widgets/panels/number_box.h"
#include "widgets/theme/icon.h"
#include "widgets/viewport/camera_view.h"

namespace graftsman {
namespace {

constexpr auto kFramesFolderKey = "files/framesFolder";
constexpr int kTurntableFrames = 72;
constexpr int kMostFrames = 10'000;
constexpr int kSmallestSide = 16;
constexpr int kFolderWidth = 320;

WholeBox* numberBox(const char* name, const QString& title, const QString& tip, int least, int most,
                    int value) {
  auto* box = new WholeBox;
  box->setObjectName(name);
  box->setAccessibleName(title);
  box->setToolTip(tip);
  box->setRange(least, most);
  box->setValue(value);
  return box;
}

}  // namespace

Film withCameras(Film film, const FusionResults& results, const CameraView& view) {
  const std::vector<Point> points = shownPoints(results, FusionView::Whole);
  const double aspect = static_cast<double>(film.size.width) / film.size.height;
  if (film.kind == Film::Kind::Turntable) {
    const ViewDirection direction{view.camera.position - view.camera.pivot, view.camera.axis};
    film.cameras = turntable(points, direction, aspect, film.count);
  } else {
    film.cameras = {pictureCamera(view, points, aspect)};
  }
  return film;
}

FramesDialog::FramesDialog(QWidget* parent)
    : QDialog(parent),
      kind_(new QComboBox),
      count_(numberBox("framesCount", tr("Frames"), tr("How many pictures are written"), 2, kMostFrames,
                       kTurntableFrames)),
      width_(numberBox("framesWidth", tr("Width"), tr("Width of each picture, in pixels"), kSmallestSide,
                       kGreatestPictureSide, 1280)),
      height_(numberBox("framesHeight", tr("Height"), tr("Height of each picture, in pixels"), kSmallestSide,
                        kGreatestPictureSide, 720)),
      folder_(new QLineEdit),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  setObjectName("framesDialog");
  setWindowTitle(tr("Export frames"));
  setAttribute(Qt::WA_DeleteOnClose);
  kind_->setObjectName("framesKind");
  kind_->setAccessibleName(tr("Film"));
  kind_->setToolTip(tr("What moves: the camera round the result, or the shape from base to part"));
  kind_->addItem(tr("Turntable: once round the result"), static_cast<int>(Film::Kind::Turntable));
  kind_->addItem(tr("Morph: from the base's shape to the part's"), static_cast<int>(Film::Kind::Morph));
  folder_->setObjectName("framesFolder");
  folder_->setAccessibleName(tr("Folder"));
  folder_->setText(QSettings().value(kFramesFolderKey).toString());
  folder_->setMinimumWidth(kFolderWidth);
  auto* browse = new QPushButton(tr("&Browse…"));
  browse->setObjectName("framesBrowse");
  browse->setToolTip(tr("Choose the folder"));
  browse->setAutoDefault(false);

  auto* size = new QHBoxLayout;
  size->addWidget(width_);
  size->addWidget(new QLabel(QStringLiteral("×")));
  size->addWidget(height_);
  size->addWidget(new QLabel(tr("pixels")));
  size->addStretch(1);
  auto* place = new QHBoxLayout;
  place->addWidget(folder_, 1);
  place->addWidget(browse);
  auto* form = new QFormLayout(this);
  form->addRow(tr("F&ilm"), kind_);
  form->addRow(tr("F&rames"), count_);
  // A row of several widgets: its key goes to the first.
  const auto addRow = [form](const QString& text, QLayout* row, QWidget* first) {
    auto* label = new QLabel(text);
    label->setBuddy(first);
    form->addRow(label, row);
  };
  addRow(tr("&Size"), size, width_);
  addRow(tr("&Folder"), place, folder_);
  auto* hint = new QLabel(tr("PNG files, frame-001.png and so on, seen from where the result's pane looks."));
  hint->setWordWrap(true);
  form->addRow(hint);
  QPushButton* write = buttons_->button(QDialogButtonBox::Ok);
  write->setText(tr("&Export"));
  write->setObjectName("framesExport");
  write->setIcon(icon("export"));
  write->setToolTip(tr("Write the pictures (Enter)"));
  write->setDefault(true);
  QPushButton* cancel = buttons_->button(QDialogButtonBox::Cancel);
  cancel->setObjectName("framesCancel");
  cancel->setToolTip(tr("Write nothing (Esc)"));
  form->addRow(buttons_);

  connect(browse, &QPushButton::clicked, this, &FramesDialog::askFolder);
  connect(folder_, &QLineEdit::textChanged, this, &FramesDialog::showWhole);
  connect(buttons_, &QDialogButtonBox::accepted, this, &FramesDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &FramesDialog::reject);
  showWhole();
}

QString FramesDialog::folder() const {
  return QDir(folder_->text().trimmed()).absolutePath();
}

Film FramesDialog::film() const {
  Film film;
  film.kind = static_cast<Film::Kind>(kind_->currentData().toInt());
  film.count = count_->value();
  film.size = {width_->value(), height_->value()};
  return film;
}

void FramesDialog::showWhole() {
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(!folder_->text().trimmed().isEmpty());
}

void FramesDialog::askFolder() {
  auto* dialog = new QFileDialog(this, tr("Folder for the frames"), folder_->text());
  dialog->setObjectName("framesFolderDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
  dialog->open();
}

void FramesDialog::accept() {
  const auto go = [this] {
    QSettings().setValue(kFramesFolderKey, folder());
    QDialog::accept();
  };
  // Frames of an older, longer film would make one with these: any frame counts.
  const QDir there(folder());
  if (there.entryList({"frame-*.png"}, QDir::AllEntries | QDir::Hidden).isEmpty()) {
    go();
    return;
  }
  auto* box =
      new QMessageBox(QMessageBox::Question, tr("There are frames already"),
                      tr("“%1” holds frames of another film.").arg(QDir::toNativeSeparators(folder())),
                      QMessageBox::NoButton, this);
  box->setObjectName("framesBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(tr("Those of the same numbers would be replaced, others stay."));
  QPushButton* write = box->addButton(tr("Write into it"), QMessageBox::AcceptRole);
  write->setObjectName("framesOverwrite");
  QPushButton* other = box->addButton(QMessageBox::Cancel);
  other->setObjectName("framesKeep");
  box->setDefaultButton(other);
  box->setEscapeButton(other);
  connect(box, &QMessageBox::finished, this, [box, write, go] {
    if (box->clickedButton() == write) {
      go();
    }
  });
  box->open();
}

}  // namespace graftsman
