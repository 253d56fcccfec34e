#pragma once

#include <QWidget>
#include <array>

#include "app/workbench/sweep_plan.h"

class QLineEdit;
class QListWidget;

namespace graftsman {

/// The lists of a sweep's values, to be ticked. Of a list of which nothing or the present value alone is
/// ticked, the fusion's own value stays.
class SweepForm : public QWidget {
  Q_OBJECT

 public:
  explicit SweepForm(QWidget* parent = nullptr);

  /// Shows what can be chosen; what was ticked and is still there stays ticked.
  void setOffer(SweepOffer offer);
  [[nodiscard]] const SweepOffer& offer() const { return offer_; }
  /// What is chosen. Error: SettingOutOfRange: the falloffs are no numbers.
  [[nodiscard]] Result<SweepPlan> plan() const;

 Q_SIGNALS:
  void edited();

 private:
  enum List { Curves, Adjustments, Parts, Embeddings, Shifts, ListCount };

  void fill(List list, const std::vector<std::pair<QString, bool>>& names);
  template <class T>
  void fillFrom(List list, const std::vector<Offered<T>>& offered);
  template <class T>
  [[nodiscard]] std::vector<Offered<T>> ticked(List list, const std::vector<Offered<T>>& offered) const;
  [[nodiscard]] Result<std::vector<double>> falloffs() const;

  SweepOffer offer_;
  std::array<QListWidget*, ListCount> lists_ = {};
  QLineEdit* falloffs_;
};

}  // namespace graftsman
