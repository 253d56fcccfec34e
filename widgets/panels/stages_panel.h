#pragma once

#include <QWidget>
#include <optional>

#include "core/fusion/update.h"

namespace graftsman {

/// State and time of each stage of the fusion: reused, ran, running, failed, not reached.
class StagesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StagesPanel(QWidget* parent = nullptr);

  void setResults(const FusionResults& results);
  /// The stage that runs now, nullopt: none.
  void setRunning(std::optional<Stage> stage);
  void clear();
};

}  // namespace graftsman
