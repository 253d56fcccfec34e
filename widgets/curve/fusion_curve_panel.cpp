#include "widgets/curve/fusion_curve_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPolygonF>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/curve/curve_plot.h"
#include "widgets/curve/fusion_curve_editor.h"
#include "widgets/panels/number_box.h"
#include "widgets/panels/problem_line.h"
#include "widgets/theme/contrast.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

struct PresetButton {
  FCF::Preset preset;
  const char* name;
  const char* text;
  const char* toolTip;
};

constexpr std::array<PresetButton, 4> kPresets = {{
    {FCF::Preset::Linear, "presetLinear", "Linear",
     "Turn evenly from the base at the seam into the part at the centre (Shift+1)"},
    {FCF::Preset::Paste, "presetPaste", "Paste",
     "Take the part as it is, but for a narrow band along the seam (Shift+2)"},
    {FCF::Preset::KeepBaseSlope, "presetKeepBaseSlope", "Keep base slope",
     "Leave the seam in the base's direction and reach the part gently: no crease at the seam (Shift+3)"},
    {FCF::Preset::Half, "presetHalf", "Half", "Mix the base and the part half and half everywhere (Shift+4)"},
}};
constexpr int kPresetIconSize = 22;

QIcon presetIcon(FCF::Preset preset, const QPalette& palette, double ratio) {
  QPixmap pixmap(QSize(kPresetIconSize, kPresetIconSize) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor text = palette.color(QPalette::ButtonText);
  const CurvePlot plot{QRectF(3.5, 3.5, kPresetIconSize - 7, kPresetIconSize - 7)};
  painter.setPen(QPen(mixed(palette.color(QPalette::Button), text, 0.4), 1));
  painter.drawLine(plot.area.topLeft(), plot.area.bottomLeft());
  painter.drawLine(plot.area.bottomLeft(), plot.area.bottomRight());
  const FCF curve = FCF::preset(preset);
  QPolygonF line;
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = static_cast<double>(i) / kSteps;
    line.append(plot.toWidget({s, curve(s)}));
  }
  painter.setPen(QPen(text, 1.75, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  return {pixmap};
}

}  // namespace

FusionCurvePanel::FusionCurvePanel(QWidget* parent)
    : QWidget(parent), editor_(new FusionCurveEditor(this)), line_(new ProblemLine(this)) {
  setObjectName(QStringLiteral("fusionCurvePanel"));
  setAccessibleName(QStringLiteral("Fusion curve"));
  line_->setObjectName(QStringLiteral("curveLine"));
  line_->setHint(QStringLiteral("Drag a point; double-click for another one."));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(sizes::kGrid, sizes::kGrid, sizes::kGrid, sizes::kGrid);
  column->setSpacing(sizes::kGrid);
  column->addLayout(presetRow());
  column->addWidget(editor_, 1);
  column->addLayout(numberRow());
  column->addWidget(line_);
  setTabOrder(presets_.back(), editor_);
  setTabOrder(editor_, s_);
  // Room for a refusal of two lines, so that the curve doesn't jump when one comes.
  line_->setMinimumHeight(2 * fontMetrics().lineSpacing());

  const auto nextAction = [this] { line_->setProblem({}); };
  connect(editor_, &FusionCurveEditor::shownChanged, this, nextAction);
  connect(editor_, &FusionCurveEditor::shownChanged, this, &FusionCurvePanel::showCurve);
  connect(editor_, &FusionCurveEditor::refused, line_, &ProblemLine::setProblem);
  showCurve();
  showIcons();
}

QLayout* FusionCurvePanel::presetRow() {
  auto* row = new QHBoxLayout;
  row->setSpacing(sizes::kGrid / 2);
  for (std::size_t i = 0; i < kPresets.size(); ++i) {
    const PresetButton& shown = kPresets[i];
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(shown.name));
    button->setText(QLatin1String(shown.text));
    button->setAccessibleName(QStringLiteral("Preset %1").arg(QLatin1String(shown.text)));
    button->setToolTip(QLatin1String(shown.toolTip));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({kPresetIconSize, kPresetIconSize});
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, this, [this, preset = shown.preset] {
      line_->setProblem({});
      Q_EMIT presetChosen(preset);
      showCurve();  // a click checks the button; it is checked only if the curve is that preset
    });
    row->addWidget(button);
    presets_[i] = button;
  }
  row->addStretch(1);
  return row;
}

QDoubleSpinBox* FusionCurvePanel::numberBox(const QString& name, const QString& toolTip) {
  auto* box = new RealBox(this);
  box->setObjectName(name);
  box->setAccessibleName(toolTip);
  box->setToolTip(toolTip);
  box->setRange(0, 1);
  box->setDecimals(3);
  box->setSingleStep(0.01);
  connect(box, &QDoubleSpinBox::valueChanged, this, &FusionCurvePanel::commitNumbers);
  return box;
}

QLayout* FusionCurvePanel::numberRow() {
  s_ = numberBox(QStringLiteral("pointS"),
                 QStringLiteral("s of the selected point: 0 at the seam, 1 at the centre"));
  f_ = numberBox(QStringLiteral("pointF"),
                 QStringLiteral("f of the selected point: 0 is the base, 1 the part"));
  monotone_ = new QCheckBox(QStringLiteral("&Monotone"), this);
  monotone_->setObjectName(QStringLiteral("monotone"));
  monotone_->setToolTip(
      QStringLiteral("Between two points the curve never goes above or below both of them (no overshoot)"));
  connect(monotone_, &QCheckBox::clicked, this, [this](bool on) {
    line_->setProblem({});
    if (const Result<FCF> curve = FCF::through(editor_->curve().points(), on)) {
      Q_EMIT monotoneChosen(*curve);
    }
    showCurve();
  });
  auto* row = new QHBoxLayout;
  row->setSpacing(sizes::kGrid / 2);
  for (const auto& [text, box] : {std::pair(QStringLiteral("&s"), s_), std::pair(QStringLiteral("&f"), f_)}) {
    auto* label = new QLabel(text, this);
    label->setBuddy(box);
    row->addWidget(label);
    row->addWidget(box);
    row->addSpacing(sizes::kGrid);
  }
  row->addStretch(1);
  row->addWidget(monotone_);
  return row;
}

void FusionCurvePanel::setCurve(const FCF& curve) {
  editor_->setCurve(curve);
}

void FusionCurvePanel::commitNumbers() {
  const int point = editor_->selectedPoint();
  if (point < 0) {
    return;
  }
  // Only what was typed: the boxes show fewer digits than the curve has.
  FCFPoint wanted = editor_->curve().points()[static_cast<std::size_t>(point)];
  (sender() == s_ ? wanted.s : wanted.f) = sender() == s_ ? s_->value() : f_->value();
  editor_->movePoint(point, wanted);
  showCurve();
}

void FusionCurvePanel::showCurve() {
  const FCF& curve = editor_->curve();
  for (std::size_t i = 0; i < kPresets.size(); ++i) {
    presets_[i]->setChecked(curve == FCF::preset(kPresets[i].preset));
  }
  monotone_->setChecked(curve.monotone());
  const int point = editor_->selectedPoint();
  const bool any = point >= 0;
  const bool inner = point > 0 && point + 1 < static_cast<int>(curve.points().size());
  const FCFPoint shown = any ? curve.points()[static_cast<std::size_t>(point)] : FCFPoint{};
  const QSignalBlocker blockS(s_);
  const QSignalBlocker blockF(f_);
  s_->setValue(shown.s);
  f_->setValue(shown.f);
  s_->setEnabled(inner);
  f_->setEnabled(any);
}

void FusionCurvePanel::showIcons() {
  for (std::size_t i = 0; i < kPresets.size(); ++i) {
    presets_[i]->setIcon(presetIcon(kPresets[i].preset, palette(), devicePixelRatioF()));
  }
}

void FusionCurvePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    showIcons();
  }
  QWidget::changeEvent(event);
}

}  // namespace graftsman

#include "moc_fusion_curve_panel.cpp"  // NOLINT(bugprone-suspicious-include)
