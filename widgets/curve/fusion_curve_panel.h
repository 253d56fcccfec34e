#pragma once

#include <QWidget>
#include <array>

#include "core/fusion/fcf.h"

class QCheckBox;
class QDoubleSpinBox;
class QLayout;
class QToolButton;

namespace graftsman {

class FusionCurveEditor;
class ProblemLine;

/// The editor with what stands round it: a button for each preset, s and f of the selected point as numbers
/// (accepted as one move of that point), monotone, and a line that says what was refused and why. Preset and
/// monotone are wishes: whoever owns the curve answers them by setCurve().
class FusionCurvePanel : public QWidget {
  Q_OBJECT

 public:
  explicit FusionCurvePanel(QWidget* parent = nullptr);

  [[nodiscard]] FusionCurveEditor* editor() const { return editor_; }
  void setCurve(const FCF& curve);

 Q_SIGNALS:
  void presetChosen(graftsman::FCF::Preset preset);
  void monotoneChosen(const graftsman::FCF& curve);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QLayout* presetRow();
  [[nodiscard]] QLayout* numberRow();
  [[nodiscard]] QDoubleSpinBox* numberBox(const QString& name, const QString& toolTip);
  void commitNumbers();
  void showCurve();  // in the buttons and boxes
  void showIcons();

  FusionCurveEditor* editor_ = nullptr;
  std::array<QToolButton*, 4> presets_ = {};
  QDoubleSpinBox* s_ = nullptr;
  QDoubleSpinBox* f_ = nullptr;
  QCheckBox* monotone_ = nullptr;
  ProblemLine* line_ = nullptr;
};

}  // namespace graftsman
