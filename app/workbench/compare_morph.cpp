// The lower row of the comparison's window, and how one shape becomes the other.

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVariantAnimation>
#include <cmath>
#include <numbers>

#include "app/workbench/compare_window.h"
#include "widgets/panels/pane_frame.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/surface_pane.h"

namespace graftsman {
namespace {

constexpr int kSliderSteps = 1000;
constexpr int kToAndFroMilliseconds = 3000;

}  // namespace

QToolButton* CompareWindow::textButton(const char* objectName, const QString& text, const QString& tip,
                                       QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(objectName);
  button->setText(text);
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus in the pane
  return button;
}

QWidget* CompareWindow::morphRow() {
  morph_ = new QWidget(this);
  auto* row = new QHBoxLayout(morph_);
  row->setContentsMargins(sizes::kGrid, 0, sizes::kGrid, sizes::kGrid);
  row->setSpacing(sizes::kGrid);
  flip_ = textButton("compareFlip", tr("Flip"), tr("Show the other one at once (X)"), morph_);
  play_ =
      textButton("comparePlay", tr("Play"),
                 tr("From A to B and back, until pressed again (P); one in place of the other where there is "
                    "nothing between them"),
                 morph_);
  play_->setCheckable(true);
  slider_ = new QSlider(Qt::Horizontal, morph_);
  slider_->setObjectName("compareSlider");
  slider_->setAccessibleName(tr("From A to B"));
  slider_->setToolTip(tr("How much of B"));
  slider_->setRange(0, kSliderSteps);
  slider_->setPageStep(kSliderSteps / 10);
  slider_->setSingleStep(kSliderSteps / 100);
  row->addWidget(flip_);
  row->addWidget(play_);
  row->addWidget(new QLabel(tr("A"), morph_));
  row->addWidget(slider_, 1);
  row->addWidget(new QLabel(tr("B"), morph_));

  connect(flip_, &QToolButton::clicked, this, &CompareWindow::flip);
  connect(play_, &QToolButton::toggled, this, &CompareWindow::play);
  connect(slider_, &QSlider::valueChanged, this, &CompareWindow::showMorph);
  // The person's hand on it: the animation lets go.
  connect(slider_, &QSlider::actionTriggered, this, [this] { play_->setChecked(false); });
  animation_->setStartValue(0.0);
  animation_->setEndValue(1.0);
  animation_->setDuration(kToAndFroMilliseconds);
  animation_->setLoopCount(-1);
  connect(animation_, &QVariantAnimation::valueChanged, this, [this](const QVariant& phase) {
    if (play_->isChecked() && shown_) {
      const double smooth = (1 - std::cos(2 * std::numbers::pi * phase.toDouble())) / 2;
      const double t = shown_->sameFaces ? smooth : std::round(smooth);
      slider_->setValue(static_cast<int>(std::lround(t * kSliderSteps)));
    }
  });
  return morph_;
}

// Where there is nothing between the two, the slider shows either.
void CompareWindow::enableMorph() {
  const bool both = shown_->sides[0].mesh && shown_->sides[1].mesh;
  slider_->setEnabled(shown_->sameFaces);
  play_->setEnabled(both);
  if (!both) {
    play_->setChecked(false);
  }
  if (!shown_->sameFaces) {
    const QSignalBlocker blocker(slider_);
    slider_->setValue(share() < 0.5 ? 0 : kSliderSteps);
  }
}

void CompareWindow::showMorph() {
  if (mode() != Mode::Morph || !shown_) {
    return;
  }
  const auto& [a, b] = shown_->sides;
  if (shown_->sameFaces) {
    panes_[1]->showBetween(shown_->between, share());
  } else {
    panes_[1]->showSurface(share() < 0.5 ? a.drawn : b.drawn);
    if (a.mesh && b.mesh) {
      frames_[1]->setHint(tr(
          "There is nothing between the two: their combined tiles differ, so that the triangles of one are "
          "not those of the other. Flip and Play show them in turn."));
    }
  }
  showProblems();
}

double CompareWindow::share() const {
  return static_cast<double>(slider_->value()) / kSliderSteps;
}

void CompareWindow::flip() {
  play_->setChecked(false);
  slider_->setValue(share() < 0.5 ? kSliderSteps : 0);
}

void CompareWindow::play(bool on) {
  if (!on) {
    animation_->stop();
    return;
  }
  // From where the slider is.
  const double phase = std::acos(1 - 2 * share()) / (2 * std::numbers::pi);
  animation_->start();
  animation_->setCurrentTime(static_cast<int>(phase * kToAndFroMilliseconds));
}

}  // namespace graftsman
