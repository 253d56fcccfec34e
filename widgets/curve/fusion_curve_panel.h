#pragma once

#include <QWidget>

#include "core/fusion/fcf.h"

namespace graftsman {

class FusionCurveEditor;

/// The editor with what stands round it: a button for each preset, s and f of the selected point as numbers
/// (accepted as one move of that point), monotone, and a line that says what was refused and why.
class FusionCurvePanel : public QWidget {
  Q_OBJECT

 public:
  explicit FusionCurvePanel(QWidget* parent = nullptr);

  [[nodiscard]] FusionCurveEditor* editor() const { return editor_; }
  void setCurve(const FCF& curve);

 Q_SIGNALS:
  void presetChosen(graftsman::FCF::Preset preset);
  void monotoneChosen(const graftsman::FCF& curve);

 private:
  FusionCurveEditor* editor_ = nullptr;
};

}  // namespace graftsman
