#include "app/workbench/compare_window.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariantAnimation>
#include <algorithm>
#include <utility>

#include "app/workbench/first_view.h"
#include "widgets/panels/pane_frame.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/surface_pane.h"

namespace graftsman {
namespace {

constexpr QSize kWindowSize(1120, 720);

// What a state's result depends on: the fusions that it is made of.
std::vector<const Fusion*> madeOf(const ComparedState& state) {
  std::vector<const Fusion*> fusions;
  for (const FusionId id : upstreamOf(state.fusions, state.shown)) {
    fusions.push_back(find(state.fusions, id));
  }
  return fusions;
}

// The camera from which a pane of another shape sees all that the view's pane does.
Camera asSeenIn(const CameraView& view, const QSize& pane) {
  const double wider = view.size.width() / std::max(1.0, view.size.height()) /
                       (std::max(1.0, static_cast<double>(pane.width())) / std::max(1, pane.height()));
  Camera camera = view.camera;
  camera.position = camera.pivot + std::max(1.0, wider) * (camera.position - camera.pivot);
  return camera;
}

QString length(double value) {
  return QLocale().toString(value, 'g', 3);
}

}  // namespace

CompareWindow::CompareWindow(DocumentModel& model, const std::function<VariantsPage::View()>& view,
                             QWidget* parent)
    : QWidget(parent, Qt::Window),
      model_(model),
      view_(view),
      comparison_(new Comparison(this)),
      modes_(new QButtonGroup(this)),
      animation_(new QVariantAnimation(this)) {
  setObjectName("compareWindow");
  setAttribute(Qt::WA_DeleteOnClose);
  resize(kWindowSize);
  auto* beside = new QHBoxLayout;
  beside->setSpacing(sizes::kGrid / 2);
  for (const std::size_t side : {0U, 1U}) {
    const QString role = side == 0 ? tr("A") : tr("B");
    auto* pane = new SurfacePane(this);
    pane->setObjectName(side == 0 ? "comparePaneA" : "comparePaneB");
    pane->setAccessibleName(tr("%1, 3D view").arg(role));
    auto* frame = new PaneFrame(role, {}, pane, this);
    frame->setObjectName(side == 0 ? "compareFrameA" : "compareFrameB");
    frame->setEnlargeable(false);
    beside->addWidget(frame, 1);
    panes_[side] = pane;
    frames_[side] = frame;
    connect(pane, &Viewport::cameraChanged, this, [this, side](const Camera& camera) {
      seen_ = true;
      panes_[1 - side]->setCamera(camera);
    });
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(modeRow());
  layout->addLayout(beside, 1);
  layout->addWidget(morphRow());
  connectKeys();

  connect(&model, &DocumentModel::changed, this, &CompareWindow::follow);
  connect(&model, &DocumentModel::documentChanged, this, &CompareWindow::refresh);
  connect(comparison_, &Comparison::compared, this, &CompareWindow::take);
  connect(comparison_, &Comparison::progressed, this, [this](double done) {
    for (SurfacePane* pane : panes_) {
      pane->setBusy(done);
    }
  });
  setMode(Mode::SideBySide);
}

CompareWindow::~CompareWindow() {
  animation_->disconnect(this);
}

QWidget* CompareWindow::modeRow() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(sizes::kGrid, sizes::kGrid / 2, sizes::kGrid, sizes::kGrid / 2);
  row->setSpacing(0);
  const auto add = [&](Mode mode, const char* objectName, const QString& text, const QString& tip) {
    QToolButton* button = textButton(objectName, text, tip, bar);
    button->setCheckable(true);
    modes_->addButton(button, static_cast<int>(mode));
    row->addWidget(button);
  };
  add(Mode::SideBySide, "compareSideBySide", tr("Side by side"), tr("Both, seen from one place"));
  add(Mode::Difference, "compareDifference", tr("Difference"), tr("B, coloured by its distance from A"));
  add(Mode::Morph, "compareMorph", tr("Morph"), tr("A becomes B"));
  row->addStretch(1);
  connect(modes_, &QButtonGroup::idClicked, this, [this](int id) { setMode(static_cast<Mode>(id)); });
  return bar;
}

void CompareWindow::connectKeys() {
  const auto on = [this](const QKeySequence& keys, const auto& what) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, what);
  };
  on(QKeySequence("Esc"), [this] { close(); });
  on(QKeySequence("F"), [this] { leading()->frameAll(); });
  const std::pair<const char*, AxisView> views[] = {{"1", AxisView::Front}, {"Ctrl+1", AxisView::Back},
                                                    {"3", AxisView::Right}, {"Ctrl+3", AxisView::Left},
                                                    {"7", AxisView::Top},   {"Ctrl+7", AxisView::Bottom}};
  for (const auto& [keys, view] : views) {
    on(QKeySequence(keys), [this, view = view] { leading()->lookFrom(view); });
  }
  on(QKeySequence("X"), [this] {
    if (mode() == Mode::Morph) {
      flip_->click();
    }
  });
  on(QKeySequence("P"), [this] {
    if (mode() == Mode::Morph) {
      play_->click();
    }
  });
}

// The first pane that is seen: the other one follows it.
SurfacePane* CompareWindow::leading() const {
  return panes_[mode() == Mode::SideBySide ? 0 : 1];
}

void CompareWindow::setNavigation(Navigation navigation) {
  for (SurfacePane* pane : panes_) {
    pane->setNavigation(navigation);
  }
}

CompareWindow::Mode CompareWindow::mode() const {
  return static_cast<Mode>(modes_->checkedId());
}

void CompareWindow::setMode(Mode mode) {
  modes_->button(static_cast<int>(mode))->setChecked(true);
  play_->setChecked(false);
  frames_[0]->setVisible(mode == Mode::SideBySide);
  morph_->setVisible(mode == Mode::Morph);
  showNames();
  showContent();
  layout()->invalidate();
  layout()->activate();  // at once: no frame shows the new content in the old places
}

void CompareWindow::compare(VariantId a, VariantId b) {
  ids_ = {a, b};
  states_ = {};
  {
    const QSignalBlocker blocker(slider_);
    slider_->setValue(0);
  }
  refresh();
}

void CompareWindow::follow(Change change) {
  if (change == Change::Reset) {
    close();  // the numbers are those of another document's variants
  } else if (change == Change::Shown) {
    refresh();
  }
}

void CompareWindow::refresh() {
  std::array<ComparedState, 2> states;
  for (const std::size_t side : {0U, 1U}) {
    const Variant* variant = graftsman::find(model_.document().variants, ids_[side]);
    if (ids_[side] != 0 && variant == nullptr) {
      close();
      return;
    }
    states[side] = variant != nullptr ? ComparedState{variant->fusions, variant->shown}
                                      : ComparedState{model_.document().fusions, model_.shown()};
  }
  showNames();
  // The present lists are kept, so that no other fusion takes the address of one.
  if (madeOf(states[0]) == madeOf(states_[0]) && madeOf(states[1]) == madeOf(states_[1])) {
    return;
  }
  states_ = states;
  states[0].known = view_().results;
  comparison_->request(std::move(states));
  play_->setChecked(false);
  for (SurfacePane* pane : panes_) {
    pane->setBusy(0);
  }
}

void CompareWindow::take(const std::shared_ptr<const Compared>& compared) {
  shown_ = compared;
  for (SurfacePane* pane : panes_) {
    pane->setBusy(std::nullopt);
  }
  showNames();
  showContent();
  if (!seen_) {
    takeFirstView();
  }
}

// Where the result was seen from; without one, as any result is looked at first.
void CompareWindow::takeFirstView() {
  const VariantsPage::View view = view_();
  std::optional<Camera> camera;
  if (view.results) {
    camera = asSeenIn(view.pane, panes_[0]->size());
  } else {
    for (const std::size_t side : {1U, 0U}) {
      const Fusion* fusion = graftsman::find(states_[side].fusions, states_[side].shown);
      if (shown_->sides[side].drawn && fusion != nullptr) {
        panes_[side]->aim(firstView(*fusion, Side::Base));
        camera = panes_[side]->camera();
      }
    }
  }
  if (camera) {
    seen_ = true;
    for (SurfacePane* pane : panes_) {
      pane->setCamera(*camera);
    }
  }
}

QString CompareWindow::name(std::size_t side) const {
  const Variant* variant = graftsman::find(model_.document().variants, ids_[side]);
  return variant != nullptr ? tr("“%1”").arg(QString::fromStdString(variant->name)) : tr("the present state");
}

void CompareWindow::showNames() {
  setWindowTitle(tr("Compare %1 with %2").arg(name(0), name(1)));
  frames_[0]->setTitle(name(0));
  frames_[1]->setTitle(mode() == Mode::SideBySide   ? name(1)
                       : mode() == Mode::Difference ? tr("%1, by its distance from %2").arg(name(1), name(0))
                                                    : tr("from %1 to %2").arg(name(0), name(1)));
  if (shown_ && mode() == Mode::Difference) {
    showDifference();
  }
}

void CompareWindow::showContent() {
  frames_[1]->setHint({});
  panes_[1]->setLegend({});
  if (shown_) {
    panes_[0]->showSurface(shown_->sides[0].drawn);
    if (mode() == Mode::SideBySide) {
      panes_[1]->showSurface(shown_->sides[1].drawn);
    } else if (mode() == Mode::Difference) {
      panes_[1]->showSurface(shown_->coloured);
      showDifference();
    } else {
      enableMorph();
      showMorph();
    }
    showProblems();
  }
}

void CompareWindow::showDifference() {
  if (!shown_->difference) {
    return;
  }
  const SurfaceDifference& difference = *shown_->difference;
  const double farthest = std::max({0.0, difference.greatest, -difference.least});
  if (farthest == 0) {
    frames_[1]->setHint(tr("The two have the same surface."));
    panes_[1]->setLegend({});
    return;
  }
  frames_[1]->setHint(tr("Greatest outward %1, greatest inward %2, mean %3, in the model's unit.")
                          .arg(length(std::max(0.0, difference.greatest)),
                               length(std::max(0.0, -difference.least)), length(difference.meanAbsolute)));
  panes_[1]->setLegend(distanceLegend(tr("Distance from %1").arg(name(0)), difference.usual,
                                      difference.usual < farthest, tr("in the model's unit; + is outside")));
}

// Each pane says why it is empty.
void CompareWindow::showProblems() {
  const auto& [a, b] = shown_->sides;
  frames_[0]->setProblem(a.problem, {});
  QString problem = b.problem;
  if (mode() == Mode::Difference) {
    problem = without();
  } else if (mode() == Mode::Morph) {
    problem = share() < 0.5 ? a.problem : b.problem;
  }
  frames_[1]->setProblem(problem, {});
}

// Why there is no difference; empty: there is one.
QString CompareWindow::without() const {
  for (const std::size_t side : {0U, 1U}) {
    if (!shown_->sides[side].mesh) {
      return tr("No difference: %1 has no result. %2").arg(name(side), shown_->sides[side].problem);
    }
  }
  return {};
}

void CompareWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  leading()->setFocus();
}

void CompareWindow::hideEvent(QHideEvent* event) {
  play_->setChecked(false);
  QWidget::hideEvent(event);
}

}  // namespace graftsman
