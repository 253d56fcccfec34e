#include "app/workbench/sweep_form.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <set>

#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

// The name without what tells that it is the present one.
constexpr int kNameRole = Qt::UserRole;
constexpr int kListHeight = 128;
constexpr int kListWidth = 200;

}  // namespace

SweepForm::SweepForm(QWidget* parent) : QWidget(parent), falloffs_(new QLineEdit) {
  setObjectName("sweepForm");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(2 * sizes::kGrid);
  grid->setVerticalSpacing(sizes::kGrid / 2);
  const auto addList = [&](List list, const char* name, const QString& title, const QString& tip) {
    auto* view = new QListWidget;
    view->setObjectName(name);
    view->setAccessibleName(QString(title).remove('&'));
    view->setToolTip(tip);
    view->setMinimumSize(kListWidth, kListHeight);
    view->setSpacing(1);
    view->setTextElideMode(Qt::ElideMiddle);
    view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* label = new QLabel(title);
    label->setBuddy(view);
    const int row = list < Embeddings ? 0 : 2;
    const int column = list < Embeddings ? list : list - Embeddings;
    grid->addWidget(label, row, column);
    grid->addWidget(view, row + 1, column);
    grid->setColumnStretch(column, 1);
    connect(view, &QListWidget::itemChanged, this, &SweepForm::edited);
    lists_[list] = view;
  };
  addList(Curves, "sweepCurves", tr("&Curves"), tr("Presets, the present curve and those of the variants"));
  addList(Adjustments, "sweepAdjustments", tr("&Adjustments"), tr("Which steps bring the part to the base"));
  addList(Parts, "sweepParts", tr("&Parts"),
          tr("The present part, and parts and pairs of variants on the same base"));
  addList(Embeddings, "sweepEmbeddings", tr("&Embeddings"), tr("How the tiles are laid out in the plane"));
  addList(Shifts, "sweepShifts", tr("&Shifts"),
          tr("By how many pairs the correspondence of part and base is turned"));

  falloffs_->setObjectName("sweepFalloffs");
  falloffs_->setAccessibleName(tr("Falloffs"));
  falloffs_->setToolTip(
      tr("n of the line field, several as “1, 3, 5”: the greater, the nearer to a side its bending stays"));
  auto* label = new QLabel(tr("&Falloffs"));
  label->setBuddy(falloffs_);
  grid->addWidget(label, 2, 2);
  grid->addWidget(falloffs_, 3, 2, Qt::AlignTop);
  connect(falloffs_, &QLineEdit::textChanged, this, &SweepForm::edited);
}

void SweepForm::fill(List list, const std::vector<std::pair<QString, bool>>& names) {
  QListWidget* view = lists_[list];
  const QSignalBlocker quiet(view);
  const bool first = view->count() == 0;
  QStringList kept;
  for (int row = 0; row < view->count(); ++row) {
    if (view->item(row)->checkState() == Qt::Checked) {
      kept.append(view->item(row)->data(kNameRole).toString());
    }
  }
  view->clear();
  for (const auto& [name, present] : names) {
    auto* item = new QListWidgetItem(present ? tr("%1 (now)").arg(name) : name, view);
    item->setData(kNameRole, name);
    item->setToolTip(present ? tr("%1: as the fusion is now").arg(name) : name);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState((first ? present : kept.contains(name)) ? Qt::Checked : Qt::Unchecked);
  }
}

template <class T>
void SweepForm::fillFrom(List list, const std::vector<Offered<T>>& offered) {
  std::vector<std::pair<QString, bool>> names;
  names.reserve(offered.size());
  for (const Offered<T>& one : offered) {
    names.emplace_back(one.name, one.present);
  }
  fill(list, names);
}

void SweepForm::setOffer(SweepOffer offer) {
  offer_ = std::move(offer);
  fillFrom(Curves, offer_.curves);
  fillFrom(Adjustments, offer_.adjustments);
  fillFrom(Parts, offer_.parts);
  fillFrom(Embeddings, offer_.embeddings);
  fillFrom(Shifts, offer_.shifts);
  falloffs_->setPlaceholderText(offer_.falloff > 0 ? tr("now %1").arg(QLocale().toString(
                                                         offer_.falloff, 'g', QLocale::FloatingPointShortest))
                                                   : QString());
  setEnabled(offer_.problem.isEmpty());
  Q_EMIT edited();
}

template <class T>
std::vector<Offered<T>> SweepForm::ticked(List list, const std::vector<Offered<T>>& offered) const {
  std::vector<Offered<T>> result;
  for (int row = 0; row < lists_[list]->count(); ++row) {
    if (lists_[list]->item(row)->checkState() == Qt::Checked) {
      result.push_back(offered[static_cast<std::size_t>(row)]);
    }
  }
  return result.size() == 1 && result.front().present ? std::vector<Offered<T>>() : result;
}

Result<std::vector<double>> SweepForm::falloffs() const {
  static const QRegularExpression kBetween("[,;\\s]+");
  const auto refuse = [](const QString& message) {
    return fail(ErrorCode::SettingOutOfRange, message.toStdString());
  };
  std::vector<double> values;
  std::set<double> seen;
  for (const QString& word : falloffs_->text().split(kBetween, Qt::SkipEmptyParts)) {
    bool isNumber = false;
    const double value = QLocale::c().toDouble(word, &isNumber);
    if (!isNumber || !std::isfinite(value)) {
      return refuse(tr("“%1” is no number. Write falloffs as “1, 3.5, 5”.").arg(word));
    }
    if (value <= 0) {
      return refuse(tr("“%1” is no falloff. Write numbers greater than 0.").arg(word));
    }
    if (!seen.insert(value).second) {
      return refuse(tr("“%1” is among the falloffs twice. Write it once.").arg(word));
    }
    values.push_back(value);
  }
  return values;
}

Result<SweepPlan> SweepForm::plan() const {
  Result<std::vector<double>> falloffs = this->falloffs();
  if (!falloffs) {
    return fail(falloffs.error());
  }
  SweepPlan plan;
  plan.fusions = offer_.fusions;
  plan.shown = offer_.shown;
  plan.parts = ticked(Parts, offer_.parts);
  for (const auto& curve : ticked(Curves, offer_.curves)) {
    plan.values.curves.push_back({curve.name.toStdString(), curve.value});
  }
  for (const auto& adjustment : ticked(Adjustments, offer_.adjustments)) {
    plan.values.adjustments.push_back({adjustment.name.toStdString(), adjustment.value});
  }
  for (const auto& embedding : ticked(Embeddings, offer_.embeddings)) {
    plan.values.embeddings.push_back(embedding.value);
  }
  for (const auto& shift : ticked(Shifts, offer_.shifts)) {
    plan.values.shifts.push_back(shift.value);
  }
  plan.values.falloffs = std::move(*falloffs);
  return plan;
}

}  // namespace graftsman
