#include "app/workbench/sweep_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QTreeWidget>
#include <algorithm>
#include <utility>

#include "app/document/document_commands.h"
#include "app/workbench/sweep_form.h"
#include "widgets/panels/problem_line.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr auto kSweepFolderKey = "files/folder";
constexpr int kBarSteps = 1000;
constexpr int kFailuresHeight = 88;

std::filesystem::path pathOf(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

}  // namespace

SweepDialog::SweepDialog(DocumentModel& model, QWidget* parent)
    : QDialog(parent), model_(model), runner_(new SweepRunner(this)), form_(new SweepForm) {
  setObjectName("sweepDialog");
  setWindowTitle(tr("Sweep"));
  count_ = new QLabel;
  count_->setObjectName("sweepCount");
  QFont bold = count_->font();
  bold.setBold(true);
  count_->setFont(bold);
  problem_ = new ProblemLine;
  problem_->setObjectName("sweepProblem");
  problem_->setHint(
      tr("Tick values; every combination becomes a variant. Where nothing is ticked, the fusion stays as it "
         "is."));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(sizes::kGrid);
  column->addWidget(form_, 1);
  column->addWidget(count_);
  column->addWidget(problem_);
  column->addLayout(folderLines());
  column->addLayout(runLines());

  connect(form_, &SweepForm::edited, this, &SweepDialog::showChoice);
  connect(runner_, &SweepRunner::progressed, this, [this](int done, int of, double fraction) {
    bar_->setValue(static_cast<int>(fraction * kBarSteps));
    bar_->setFormat(tr("%1 of %2").arg(done).arg(of));
  });
  connect(runner_, &SweepRunner::finished, this, &SweepDialog::finish);
  connect(runner_, &SweepRunner::idle, this, &SweepDialog::showRunning);
  connect(&model, &DocumentModel::changed, this, [this](Change change) {
    if (change == Change::Reset) {
      // Another document: what is under way belongs to none.
      abandon();
    }
    QTimer::singleShot(0, this, &SweepDialog::keepVariants);
    refreshSoon();
  });
  connect(&model, &DocumentModel::documentChanged, this, &SweepDialog::refreshSoon);
  showRunning();
}

QLayout* SweepDialog::folderLines() {
  files_ = new QCheckBox(tr("Also &write a folder with meshes, pictures and a table of measures"));
  files_->setObjectName("sweepFiles");
  files_->setToolTip(tr("A file for each result, and one table.csv with what was measured"));
  folder_ = new QLineEdit;
  folder_->setObjectName("sweepFolder");
  folder_->setAccessibleName(tr("Folder"));
  folder_->setPlaceholderText(tr("Folder"));
  browse_ = new QPushButton(tr("&Browse…"));
  browse_->setObjectName("sweepBrowse");
  browse_->setToolTip(tr("Choose the folder"));
  browse_->setAutoDefault(false);
  format_ = new QComboBox;
  format_->setObjectName("sweepFormat");
  format_->setAccessibleName(tr("Format of the meshes"));
  format_->setToolTip(tr("Format of the meshes; GLB holds the morph from base to part"));
  for (const char* ending : {"ply", "obj", "stl", "off", "glb"}) {
    format_->addItem(QString(ending).toUpper(), ending);
  }
  format_->addItem(tr("No meshes"), QString());
  pictures_ = new QCheckBox(tr("P&ictures"));
  pictures_->setObjectName("sweepPictures");
  pictures_->setToolTip(tr("A picture of each result, all from one camera"));
  pictures_->setChecked(true);
  const auto enable = [this] {
    for (QWidget* widget : std::initializer_list<QWidget*>{folder_, browse_, format_, pictures_}) {
      widget->setEnabled(files_->isChecked() && !busy());
    }
    files_->setEnabled(!busy());
    showChoice();
  };
  connect(files_, &QCheckBox::toggled, this, enable);
  connect(this, &SweepDialog::busyChanged, this, enable);
  connect(folder_, &QLineEdit::textChanged, this, &SweepDialog::showChoice);
  connect(browse_, &QPushButton::clicked, this, &SweepDialog::askFolder);
  auto* lines = new QVBoxLayout;
  lines->setSpacing(sizes::kGrid / 2);
  lines->addWidget(files_);
  auto* line = new QHBoxLayout;
  line->addWidget(folder_, 1);
  line->addWidget(browse_);
  line->addWidget(format_);
  line->addWidget(pictures_);
  lines->addLayout(line);
  return lines;
}

QLayout* SweepDialog::runLines() {
  bar_ = new QProgressBar;
  bar_->setObjectName("sweepProgress");
  bar_->setAccessibleName(tr("Progress of the sweep"));
  bar_->setRange(0, kBarSteps);
  QSizePolicy keepsItsPlace = bar_->sizePolicy();
  keepsItsPlace.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(keepsItsPlace);
  summary_ = new QLabel;
  summary_->setObjectName("sweepSummary");
  summary_->setWordWrap(true);
  failures_ = new QTreeWidget;
  failures_->setObjectName("sweepFailures");
  failures_->setAccessibleName(tr("Combinations that do not fuse"));
  failures_->setHeaderLabels({tr("Does not fuse"), tr("Why")});
  failures_->setRootIsDecorated(false);
  failures_->setWordWrap(true);
  failures_->setMaximumHeight(kFailuresHeight);
  failures_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  run_ = new QPushButton(icon("run"), tr("&Run"));
  run_->setObjectName("sweepRun");
  run_->setToolTip(tr("Compute all combinations (Enter)"));
  run_->setDefault(true);
  cancel_ = new QPushButton(icon("cancel"), tr("Ca&ncel"));
  cancel_->setObjectName("sweepCancel");
  cancel_->setToolTip(tr("Stop; what is done becomes variants"));
  cancel_->setAutoDefault(false);
  auto* close = new QPushButton(tr("C&lose"));
  close->setObjectName("sweepClose");
  close->setToolTip(tr("A sweep under way goes on (Esc)"));
  close->setAutoDefault(false);
  connect(run_, &QPushButton::clicked, this, &SweepDialog::run);
  connect(cancel_, &QPushButton::clicked, this, &SweepDialog::cancel);
  connect(close, &QPushButton::clicked, this, &SweepDialog::reject);
  auto* lines = new QVBoxLayout;
  lines->setSpacing(sizes::kGrid);
  lines->addWidget(summary_);
  lines->addWidget(failures_);
  auto* line = new QHBoxLayout;
  line->addWidget(bar_, 1);
  line->addWidget(cancel_);
  line->addWidget(run_);
  line->addWidget(close);
  lines->addLayout(line);
  return lines;
}

void SweepDialog::showEvent(QShowEvent* event) {
  refresh();
  QDialog::showEvent(event);
}

// Once for all that changes at this moment.
void SweepDialog::refreshSoon() {
  if (isVisible() && !model_.dragging() && !std::exchange(refreshing_, true)) {
    QTimer::singleShot(0, this, &SweepDialog::refresh);
  }
}

void SweepDialog::refresh() {
  refreshing_ = false;
  form_->setOffer(sweepOffer(model_.document(), model_.shown()));
}

Result<SweepPlan> SweepDialog::chosen() const {
  const auto refuse = [](const QString& message) {
    return fail(ErrorCode::SettingOutOfRange, message.toStdString());
  };
  if (!form_->offer().problem.isEmpty()) {
    return refuse(form_->offer().problem);
  }
  Result<SweepPlan> plan = form_->plan();
  if (!plan) {
    return plan;
  }
  // Before core's check, which has the words of the command line's files.
  if (const std::size_t count = plan->count(); count > kMostResults) {
    const bool capped = count > Sweep::kMostCombinations;
    return refuse(tr("%1 would be more variants than %2. Tick fewer values; graftsman-cli sweep makes files "
                     "of as many results as you like.")
                      .arg(capped ? tr("More than %1").arg(Sweep::kMostCombinations) : QString::number(count))
                      .arg(kMostResults));
  }
  if (Result<void> checked = check(plan->checked()); !checked) {
    return fail(std::move(checked.error()));
  }
  if (files_->isChecked() && folder_->text().trimmed().isEmpty()) {
    return refuse(tr("Choose a folder for the files, or write none."));
  }
  return plan;
}

void SweepDialog::showChoice() {
  const Result<SweepPlan> plan = chosen();
  const Result<SweepPlan> values = form_->plan();
  const bool anything = values && form_->offer().problem.isEmpty() && !countText(*values).startsWith(" = ");
  count_->setText(anything ? countText(*values) : tr("Nothing is varied yet"));
  problem_->setProblem(plan ? QString() : QString::fromStdString(plan.error().message));
  run_->setEnabled(plan && anything && !busy());
}

void SweepDialog::askFolder() {
  auto* dialog = new QFileDialog(this, tr("Folder for the results"), folder_->text());
  dialog->setObjectName("sweepFolderDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  if (folder_->text().isEmpty()) {
    dialog->setDirectory(QSettings().value(kSweepFolderKey).toString());
  }
  connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
  dialog->open();
}

void SweepDialog::run() {
  Result<SweepPlan> plan = chosen();
  if (!plan || busy()) {
    return;
  }
  if (!files_->isChecked()) {
    start(std::move(*plan));
    return;
  }
  const QString folder = QDir(folder_->text().trimmed()).absolutePath();
  plan->folder = pathOf(folder);
  plan->output.mesh = format_->currentData().toString().toStdString();
  if (pictures_->isChecked()) {
    plan->output.picture = SweepPicture();
  }
  const Fusion& fusion = *graftsman::find(plan->fusions, plan->shown);
  plan->sources = {fusion.part->source, fusion.base->source, pathOf(projectPath_)};
  for (const auto& part : plan->parts) {
    plan->sources.push_back(part.value.part->source);
  }
  if (!QDir(folder).exists() ||
      QDir(folder).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden)) {
    start(std::move(*plan));
    return;
  }
  auto* box = new QMessageBox(QMessageBox::Question, tr("Folder is not empty"),
                              tr("“%1” is not empty.").arg(QDir::toNativeSeparators(folder)),
                              QMessageBox::NoButton, this);
  box->setObjectName("sweepFolderBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(tr("Files of the same names, and table.csv, would be replaced."));
  QPushButton* write = box->addButton(tr("Write into it"), QMessageBox::AcceptRole);
  write->setObjectName("sweepOverwrite");
  QPushButton* other = box->addButton(QMessageBox::Cancel);
  other->setObjectName("sweepKeepFolder");
  box->setDefaultButton(other);
  box->setEscapeButton(other);
  connect(box, &QMessageBox::finished, this, [this, box, write, plan = std::move(*plan)] {
    if (box->clickedButton() == write && !busy()) {
      start(plan);
    }
  });
  box->open();
}

void SweepDialog::start(SweepPlan plan) {
  summary_->clear();
  failures_->clear();
  bar_->setValue(0);
  bar_->setFormat(tr("%1 of %2").arg(0).arg(plan.count()));
  runner_->start(std::move(plan));
  showRunning();
  cancel_->setFocus();
}

void SweepDialog::cancel() {
  runner_->cancel();
}

void SweepDialog::abandon() {
  runner_->abandon();
  kept_.reset();
  summary_->clear();
  failures_->clear();
  showRunning();
}

void SweepDialog::showRunning() {
  bar_->setVisible(busy());
  cancel_->setEnabled(busy());
  summary_->setVisible(!summary_->text().isEmpty());
  failures_->setVisible(failures_->topLevelItemCount() > 0);
  Q_EMIT busyChanged(busy());
}

void SweepDialog::finish(const SweepOutcome& outcome) {
  for (const auto& [name, why] : outcome.failures) {
    auto* item = new QTreeWidgetItem(failures_, {name, why});
    item->setToolTip(1, why);
  }
  QStringList sentences;
  if (outcome.error) {
    sentences.append(QString::fromStdString(outcome.error->message));
  }
  const auto variants = static_cast<int>(outcome.states.size());
  if (outcome.cancelled || outcome.error) {
    sentences.append(tr("Stopped after %1 of %2.").arg(outcome.done).arg(outcome.of));
  }
  sentences.append(variants == 1 ? tr("1 result is a variant now.")
                                 : tr("%1 results are variants now.").arg(variants));
  if (!outcome.failures.empty()) {
    sentences.append(outcome.failures.size() == 1 ? tr("1 does not fuse.")
                                                  : tr("%1 do not fuse.").arg(outcome.failures.size()));
  }
  summary_->setText(sentences.join(' '));
  kept_ = outcome;
  keepVariants();
  Q_EMIT told(tr("Sweep: %1").arg(summary_->text()));
}

// A drag under way is not disturbed: it is one step of history, and this another.
void SweepDialog::keepVariants() {
  if (!kept_ || model_.dragging()) {
    return;
  }
  const SweepOutcome outcome = *std::exchange(kept_, std::nullopt);
  if (outcome.states.empty()) {
    return;
  }
  std::vector<QString> names;
  for (const auto& state : outcome.states) {
    names.push_back(state.second);
  }
  names = uniqueNames(names, model_.document().variants);
  std::vector<std::pair<FusionList, QString>> states;
  for (std::size_t i = 0; i < names.size(); ++i) {
    states.emplace_back(outcome.states[i].first, names[i]);
  }
  model_.push(std::make_unique<AddVariants>(
      model_, states, outcome.shown,
      names.size() == 1 ? tr("Sweep: 1 variant") : tr("Sweep: %1 variants").arg(names.size())));
}

}  // namespace graftsman
