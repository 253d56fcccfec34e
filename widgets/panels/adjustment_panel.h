#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "core/fusion/adjustment.h"

class QButtonGroup;
class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QSpinBox;

namespace graftsman {

/// The adjustment's steps: what each reached, which are on, ε and falloff, and a button to run it.
class AdjustmentPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AdjustmentPanel(QWidget* parent = nullptr);

  /// Shows the document's settings, without any signal.
  void setSettings(const AdjustmentSettings& settings);
  /// The same for what undo and redo bring back: scrolls to what is different and shows it, once.
  void showChange(const AdjustmentSettings& settings);
  /// Shows what the last adjustment did; nullopt: there is none.
  void setReport(const std::optional<AdjustmentReport>& report);
  /// Whether there is something to adjust.
  void setRunnable(bool runnable);

  /// All of it without scrolling.
  [[nodiscard]] QSize sizeHint() const override;

  enum class Shown { Result, Before, After };  // what the result's pane is to show of the part in place

 Q_SIGNALS:
  /// A person changed a setting (one signal for each change, when it is complete).
  void settingsEdited(const graftsman::AdjustmentSettings& settings);
  /// The button "Run adjustment".
  void runWanted();
  void shownChanged(graftsman::AdjustmentPanel::Shown shown);

 private:
  /// A step as a line of the panel: a switch, and the mean distance of the pairs after it.
  struct StepLine {
    bool AdjustmentSettings::*setting = nullptr;
    AdjustmentStep step = AdjustmentStep::None;
    QCheckBox* box = nullptr;
    QLabel* distance = nullptr;
    QLabel* reached = nullptr;
  };

  [[nodiscard]] QLayout* stepLines();
  [[nodiscard]] QLayout* numbers();
  [[nodiscard]] QLayout* shownChoice();
  void edit(const AdjustmentSettings& settings);
  void showReport();
  void keepWidth();
  void flashControl(QWidget* control);

  AdjustmentSettings settings_;
  std::optional<AdjustmentReport> report_;
  std::array<StepLine, 4> steps_;
  QLabel* before_ = nullptr;
  QDoubleSpinBox* epsilon_ = nullptr;
  QDoubleSpinBox* falloff_ = nullptr;
  QSpinBox* iterations_ = nullptr;
  QPushButton* run_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QButtonGroup* shown_ = nullptr;
};

}  // namespace graftsman
