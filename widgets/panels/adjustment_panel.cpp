#include "widgets/panels/adjustment_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "widgets/panels/flash.h"
#include "widgets/panels/number_box.h"
#include "widgets/panels/numbers.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr int kDigits = 3;
constexpr double kPercent = 100;
constexpr int kStepIconSize = 14;

enum Column { SwitchColumn, DistanceColumn, ReachedColumn };

struct StepTexts {
  const char* name;
  const char* text;
  const char* tip;
};

constexpr std::array<StepTexts, 4> kTexts = {{
    {"rigidStep", QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel", "1 rigid"),
     QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel",
                       "Turn and move the part so that its points come to the base's")},
    {"scaleStep", QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel", "2 scale"),
     QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel", "Grow or shrink the part, too, as often as it helps")},
    {"lineFieldStep", QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel", "3 line field"),
     QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel",
                       "Bend the part so that the sides of its loop come to the base's")},
    {"exactFitStep", QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel", "exact fit"),
     QT_TRANSLATE_NOOP("graftsman::AdjustmentPanel",
                       "Carry the part's whole boundary onto the base's: the seam has no steps")},
}};

QLabel* numberLabel(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return label;
}

}  // namespace

AdjustmentPanel::AdjustmentPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("adjustmentPanel");
  setAccessibleName(tr("Adjustment"));
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(sizes::kGrid, sizes::kGrid, sizes::kGrid, sizes::kGrid);
  column->setSpacing(sizes::kGrid);
  column->addLayout(stepLines());
  column->addLayout(numbers());
  run_ = new QPushButton(tr("Run adjustment"));
  run_->setObjectName("runAdjustment");
  run_->setToolTip(tr("Bring the part to the base by all steps, again if need be (F5)"));
  run_->setIcon(icon("run"));
  connect(run_, &QPushButton::clicked, this, &AdjustmentPanel::runWanted);
  column->addWidget(run_);
  column->addLayout(shownChoice());
  column->addStretch(1);

  scroll_ = new QScrollArea;
  scroll_->setObjectName("adjustmentScroll");
  scroll_->setAccessibleName(tr("Adjustment"));
  scroll_->setWidget(content);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll_);
  setSettings({});
  keepWidth();
  setReport({});
}

// Wide enough for the numbers that are to come: the docks would move with them.
void AdjustmentPanel::keepWidth() {
  constexpr double kWide = 0.00888;
  AdjustmentReport report;
  report.reached = AdjustmentStep::LineField;
  report.iterations = 88;
  report.scale = 88.8;
  report.distanceBefore = report.distanceAfterRigid = report.distanceAfterScale =
      report.distanceAfterLineField = kWide;
  setReport(report);
  scroll_->widget()->layout()->activate();
  scroll_->setMinimumWidth(scroll_->widget()->minimumSizeHint().width() +
                           scroll_->verticalScrollBar()->sizeHint().width());
}

QSize AdjustmentPanel::sizeHint() const {
  return scroll_->widget()->sizeHint();
}

QLayout* AdjustmentPanel::stepLines() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(sizes::kGrid);
  grid->setVerticalSpacing(sizes::kGrid / 2);
  grid->setColumnStretch(DistanceColumn, 1);
  grid->addWidget(new QLabel(tr("Mean CV distance as given")), 0, SwitchColumn);
  before_ = numberLabel("distanceBefore");
  before_->setToolTip(tr("Mean distance of the pairs before the adjustment, in the base's unit"));
  grid->addWidget(before_, 0, DistanceColumn);
  constexpr std::array<std::pair<bool AdjustmentSettings::*, AdjustmentStep>, 4> kSteps = {
      {{&AdjustmentSettings::rigid, AdjustmentStep::Rigid},
       {&AdjustmentSettings::scale, AdjustmentStep::Scale},
       {&AdjustmentSettings::lineField, AdjustmentStep::LineField},
       {&AdjustmentSettings::exactFit, AdjustmentStep::None}}};
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    StepLine& line = steps_[i];
    line.setting = kSteps[i].first;
    line.step = kSteps[i].second;
    line.box = new QCheckBox(tr(kTexts[i].text));
    line.box->setObjectName(kTexts[i].name);
    line.box->setToolTip(tr(kTexts[i].tip));
    line.distance = numberLabel(QString("%1Distance").arg(kTexts[i].name));
    line.distance->setToolTip(tr("Mean distance of the pairs after this step, in the base's unit"));
    line.reached = new QLabel;
    line.reached->setObjectName(QString("%1Reached").arg(kTexts[i].name));
    const int row = static_cast<int>(i) + 1;
    grid->addWidget(line.box, row, SwitchColumn);
    grid->addWidget(line.distance, row, DistanceColumn);
    grid->addWidget(line.reached, row, ReachedColumn);
    connect(line.box, &QCheckBox::clicked, this, [this, setting = line.setting](bool on) {
      AdjustmentSettings settings = settings_;
      settings.*setting = on;
      edit(settings);
    });
  }
  grid->setColumnMinimumWidth(ReachedColumn, kStepIconSize);
  return grid;
}

QLayout* AdjustmentPanel::numbers() {
  epsilon_ = new RealBox;
  epsilon_->setObjectName("epsilon");
  epsilon_->setRange(0, kPercent);
  epsilon_->setDecimals(3);
  epsilon_->setSingleStep(0.05);
  epsilon_->setSuffix(tr(" %"));
  epsilon_->setAccessibleName(tr("ε"));
  epsilon_->setToolTip(
      tr("ε: the steps end when the pairs are this near on average, as part of the loop's diameter"));
  falloff_ = new RealBox;
  falloff_->setObjectName("falloff");
  falloff_->setRange(0.1, 50);
  falloff_->setDecimals(1);
  falloff_->setSingleStep(1);
  falloff_->setAccessibleName(tr("Falloff"));
  falloff_->setToolTip(tr("n of the line field: the greater, the nearer to a side its bending stays"));
  iterations_ = new WholeBox;
  iterations_->setObjectName("maxIterations");
  iterations_->setRange(1, 1000);
  iterations_->setAccessibleName(tr("Greatest number of iterations"));
  iterations_->setToolTip(tr("How often the scale step may be repeated"));
  connect(epsilon_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
    AdjustmentSettings settings = settings_;
    settings.epsilon = percent / kPercent;
    edit(settings);
  });
  connect(falloff_, &QDoubleSpinBox::valueChanged, this, [this](double falloff) {
    AdjustmentSettings settings = settings_;
    settings.falloff = falloff;
    edit(settings);
  });
  connect(iterations_, &QSpinBox::valueChanged, this, [this](int iterations) {
    AdjustmentSettings settings = settings_;
    settings.maxIterations = iterations;
    edit(settings);
  });
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(sizes::kGrid);
  grid->setVerticalSpacing(sizes::kGrid / 2);
  grid->setColumnStretch(1, 1);
  int row = 0;
  for (const auto& [text, box] :
       std::initializer_list<std::pair<QString, QWidget*>>{{tr("&ε, of the loop"), epsilon_},
                                                           {tr("&Falloff n"), falloff_},
                                                           {tr("&Iterations up to"), iterations_}}) {
    auto* label = new QLabel(text);
    label->setBuddy(box);
    grid->addWidget(label, row, 0);
    grid->addWidget(box, row++, 1);
  }
  return grid;
}

QLayout* AdjustmentPanel::shownChoice() {
  struct Choice {
    Shown shown;
    const char* name;
    QString text;
    QString tip;
  };
  const Choice choices[] = {{Shown::Result, "showResult", tr("Result"), tr("Show the result")},
                            {Shown::Before, "showBefore", tr("Before"),
                             tr("Show the part's tile as it was given, beside the base")},
                            {Shown::After, "showAfter", tr("After"),
                             tr("Show the part's tile as the adjustment left it, in place")}};
  shown_ = new QButtonGroup(this);
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * sizes::kGrid);
  for (const Choice& choice : choices) {
    auto* button = new QRadioButton(choice.text);
    button->setObjectName(choice.name);
    button->setToolTip(choice.tip);
    shown_->addButton(button, static_cast<int>(choice.shown));
    row->addWidget(button);
  }
  row->addStretch(1);
  shown_->button(static_cast<int>(Shown::Result))->setChecked(true);
  connect(shown_, &QButtonGroup::idClicked, this,
          [this](int id) { Q_EMIT shownChanged(static_cast<Shown>(id)); });
  return row;
}

void AdjustmentPanel::setSettings(const AdjustmentSettings& settings) {
  settings_ = settings;
  for (const StepLine& line : steps_) {
    line.box->setChecked(settings.*line.setting);
  }
  const QSignalBlocker epsilonBlocker(epsilon_);
  const QSignalBlocker falloffBlocker(falloff_);
  const QSignalBlocker iterationsBlocker(iterations_);
  epsilon_->setValue(settings.epsilon * kPercent);
  falloff_->setValue(settings.falloff);
  iterations_->setValue(settings.maxIterations);
}

void AdjustmentPanel::showChange(const AdjustmentSettings& settings) {
  const AdjustmentSettings before = settings_;
  setSettings(settings);
  for (const StepLine& line : steps_) {
    if (before.*line.setting != settings.*line.setting) {
      flashControl(line.box);
    }
  }
  for (const auto& [differs, box] : std::initializer_list<std::pair<bool, QWidget*>>{
           {before.epsilon != settings.epsilon, epsilon_},
           {before.falloff != settings.falloff, falloff_},
           {before.maxIterations != settings.maxIterations, iterations_}}) {
    if (differs) {
      flashControl(box);
    }
  }
}

void AdjustmentPanel::flashControl(QWidget* control) {
  scroll_->ensureWidgetVisible(control);
  flash(*scroll_->widget(), control->geometry());
}

void AdjustmentPanel::setRunnable(bool runnable) {
  run_->setEnabled(runnable);
}

void AdjustmentPanel::edit(const AdjustmentSettings& settings) {
  if (!(settings == settings_)) {
    settings_ = settings;
    Q_EMIT settingsEdited(settings);
  }
}

void AdjustmentPanel::setReport(const std::optional<AdjustmentReport>& report) {
  report_ = report;
  showReport();
}

void AdjustmentPanel::showReport() {
  const AdjustmentReport done = report_.value_or(AdjustmentReport{});
  const std::array<double, 3> after = {done.distanceAfterRigid, done.distanceAfterScale,
                                       done.distanceAfterLineField};
  for (QAbstractButton* button : shown_->buttons()) {
    button->setEnabled(report_.has_value());
  }
  before_->setText(report_ ? significant(done.distanceBefore, kDigits) : QString());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    StepLine& line = steps_[i];
    const bool isStep = line.step != AdjustmentStep::None;
    const bool ran = report_ && isStep && line.step <= done.reached;
    line.distance->setText(ran ? significant(after[i], kDigits) : QString());
    const bool last = ran && line.step == done.reached;
    line.reached->setPixmap(last ? icon("ok").pixmap(kStepIconSize) : QPixmap());
    line.reached->setAccessibleName(last ? tr("The step reached") : QString());
    line.reached->setToolTip(last ? tr("The adjustment ended with this step") : QString());
  }
  const bool scaled = report_ && done.reached >= AdjustmentStep::Scale;
  steps_[1].box->setText(
      scaled ? tr("2 scale ×%1 (%n times)", nullptr, done.iterations).arg(significant(done.scale, kDigits))
             : tr("2 scale"));
}

}  // namespace graftsman
