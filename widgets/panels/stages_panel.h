#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "core/fusion/update.h"

class QTableWidget;

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

 private:
  enum class State { NotReached, Ran, Reused, Failed };
  struct Row {
    State state = State::NotReached;
    double milliseconds = 0;
    QString problem;
  };

  void show(Stage stage);
  void showAll();

  std::array<Row, kStageCount> rows_;
  std::optional<Stage> running_;
  QTableWidget* table_ = nullptr;
};

}  // namespace graftsman
