#pragma once

#include <QWidget>
#include <optional>

#include "core/fusion/adjustment.h"

namespace graftsman {

/// The adjustment's steps: what each reached, which are on, ε and falloff, and a button to run it.
class AdjustmentPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AdjustmentPanel(QWidget* parent = nullptr);

  /// Shows the document's settings, without any signal.
  void setSettings(const AdjustmentSettings& settings);
  /// Shows what the last adjustment did; nullopt: there is none.
  void setReport(const std::optional<AdjustmentReport>& report);

  enum class Shown { Result, Before, After };  // what the result's pane is to show of the part in place

 Q_SIGNALS:
  /// A person changed a setting (one signal for each change, when it is complete).
  void settingsEdited(const graftsman::AdjustmentSettings& settings);
  /// The button "Run adjustment".
  void runWanted();
  void shownChanged(graftsman::AdjustmentPanel::Shown shown);
};

}  // namespace graftsman
