#include "app/workbench/suggester.h"

#include <QEvent>
#include <algorithm>
#include <new>
#include <utility>

#include "app/document/commands.h"
#include "app/workbench/job_queue.h"
#include "app/workbench/suggestion_words.h"
#include "app/workbench/variant_pictures.h"
#include "core/picture/fusion_view.h"
#include "widgets/theme/theme.h"
#include "widgets/variants/suggestion_strip.h"
#include "widgets/variants/suggestions_model.h"

namespace graftsman {
namespace {

constexpr double kAspect = 4.0 / 3;        // of the pictures
constexpr double kSurroundings = 1.3;      // of what the tile fills, so that what is round it is seen, too
constexpr int kCameraRestsMs = 300;        // before pictures are drawn from another side
constexpr std::size_t kPicturesKept = 36;  // that are not shown, for another order

// Why there can be no suggestions; empty: there can.
QString reasonAgainst(const Fusion& fusion) {
  if (!fusion.part || !fusion.base) {
    return Suggester::tr("Suggestions are other settings of a fusion: load a part and a base first.");
  }
  if (!fusion.closed) {
    return Suggester::tr("Suggestions are other settings of a fusion: close the loop first, in Tiles mode.");
  }
  if (!fusion.inputs.part || !fusion.inputs.base) {
    return Suggester::tr("The fusion that this one is made of has no result.");
  }
  return {};
}

bool sameState(const Fusion& a, const Fusion& b) {
  return a.id == b.id && same(a.inputs, b.inputs);
}

// The fusion on meshes of its own, whatever they are results of.
Fusion onItsOwn(Fusion fusion) {
  for (const Side side : {Side::Part, Side::Base}) {
    auto asset = std::make_shared<MeshAsset>(*fusion.of(side));
    asset->mesh = side == Side::Part ? fusion.inputs.part : fusion.inputs.base;
    asset->result = 0;
    (side == Side::Part ? fusion.part : fusion.base) = std::move(asset);
  }
  return fusion;
}

VariantList statesOf(const Fusion& fusion, const Suggestions& suggestions) {
  VariantList states;
  Fusion state = onItsOwn(fusion);
  for (const Suggestion& suggestion : suggestions.candidates) {
    state.inputs = suggestion.inputs;
    Variant variant;
    variant.id = static_cast<VariantId>(states.size()) + 1;
    variant.shown = state.id;
    variant.fusions = {std::make_shared<const Fusion>(state)};
    states.push_back(std::make_shared<const Variant>(std::move(variant)));
  }
  return states;
}

}  // namespace

struct Suggester::Search {
  Result<Suggestions> suggestions;
  std::shared_ptr<const NearestSurface> base;
};

Suggester::Suggester(DocumentModel& model, StageRunner& runner, SuggestionStrip& strip,
                     std::function<VariantsPage::View()> view, QObject* parent)
    : QObject(parent),
      model_(model),
      runner_(runner),
      strip_(strip),
      view_(std::move(view)),
      jobs_(new JobQueue(this)),
      pictures_(new VariantPictures(this, kPicturesKept)) {
  refresh_.setSingleShot(true);
  connect(&refresh_, &QTimer::timeout, this, &Suggester::refreshNow);
  cameraRests_.setSingleShot(true);
  cameraRests_.setInterval(kCameraRestsMs);
  connect(&cameraRests_, &QTimer::timeout, this, &Suggester::takeView);

  connect(&model, &DocumentModel::changed, this, &Suggester::refresh);
  connect(&runner, &StageRunner::finished, this,
          [this](const std::shared_ptr<const Outcome>& outcome) { outcome_ = outcome; });
  connect(&runner, &StageRunner::busyChanged, this, &Suggester::refresh);
  connect(jobs_, &JobQueue::busyChanged, this, [this] {
    refresh();
    Q_EMIT busyChanged();
  });
  connect(jobs_, &JobQueue::progressed, this, [this](const QString& what, double done) {
    if (searching_) {
      strip_.setSentence(tr("%1: %2 %").arg(what).arg(static_cast<int>(100 * done)));
    }
  });
  connect(pictures_, &VariantPictures::drawn, this, &Suggester::showPictures);
  connect(pictures_, &VariantPictures::missingChanged, this, &Suggester::busyChanged);

  strip.setOrders(orderNames());
  strip.installEventFilter(this);
  pictures_->setDark(themeFor(strip.palette()).dark);
  connect(&strip, &SuggestionStrip::orderChosen, this, &Suggester::showFound);
  connect(&strip, &SuggestionStrip::takeWanted, this, &Suggester::take);
  connect(&strip, &SuggestionStrip::paletteChanged, this, [this] {
    pictures_->setDark(themeFor(strip_.palette()).dark);
    requestPictures();
  });
}

Suggester::~Suggester() {
  stopSearch();
}

bool Suggester::busy() const {
  return jobs_->busy() || pictures_->missing() > 0;
}

void Suggester::cancel() {
  if (searching_) {
    cancelled_ = searching_;
    stopSearch();
  }
  pictures_->cancel();
}

void Suggester::stopSearch() {
  if (stop_) {
    *stop_ = true;
  }
}

void Suggester::refresh() {
  refresh_.start(0);
}

bool Suggester::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &strip_ && (event->type() == QEvent::Show || event->type() == QEvent::Hide)) {
    cancelled_.reset();
    setCamera();
    refresh();
  }
  return QObject::eventFilter(watched, event);
}

void Suggester::refreshNow() {
  if (!strip_.isVisible()) {
    stopSearch();
    pictures_->cancel();
    return;
  }
  if (model_.dragging()) {
    return;  // at its end there is one more change
  }
  const Fusion& fusion = model_.committed();
  if (const QString reason = reasonAgainst(fusion); !reason.isEmpty()) {
    stopSearch();
    found_.reset();
    showNone(reason);
    return;
  }
  if (covers(fusion)) {
    stopSearch();
    if (strip_.model()->outdated()) {
      showFound();
    }
    showTaken();
    if (!runner_.busy()) {
      requestPictures();
    }
    return;
  }
  strip_.model()->setOutdated(true);
  pictures_->cancel();
  if (runner_.busy() || jobs_->busy()) {
    if (runner_.busy() || !searching_ || !sameState(*searching_, fusion)) {
      stopSearch();  // when all is idle, this is called again
    }
  } else if (cancelled_ && sameState(*cancelled_, fusion)) {
    strip_.setSentence(tr("Cancelled. Close the strip and open it to look again."));
  } else {
    search(fusion);
  }
}

void Suggester::search(const Fusion& fusion) {
  cancelled_.reset();
  searching_ = fusion;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  // From the present state's results nearly all that does not change is taken over.
  FusionResults present;
  if (outcome_ && outcome_->results) {
    present = *outcome_->results;
  }
  if (!same(present.inputs, fusion.inputs)) {
    present = {};
    present.inputs = fusion.inputs;
  }
  const auto known = base_ && base_->mesh() == fusion.inputs.base ? base_ : nullptr;
  strip_.setSentence(tr("Looking for suggestions"));
  strip_.setReason({});
  jobs_->start<Search>(
      tr("Looking for suggestions"),
      [present = std::move(present), known, stop = stop_](const Progress& progress) -> Search {
        const Progress watched([progress, stop](double done) { return progress.keepGoing(done) && !*stop; });
        try {
          const auto base = known ? known : std::make_shared<const NearestSurface>(present.inputs.base);
          return {suggest(present, *base, watched), base};
        } catch (const std::bad_alloc&) {
          return {fail(ErrorCode::OutOfMemory, "There is not enough memory to look for suggestions."), {}};
        }
      },
      [this, fusion](Search search) { finish(fusion, std::move(search)); });
}

void Suggester::finish(const Fusion& fusion, Search search) {
  searching_.reset();
  stop_.reset();
  base_ = search.base;
  const bool cancelled = !search.suggestions && search.suggestions.error().code == ErrorCode::Cancelled;
  if (cancelled || !sameState(fusion, model_.committed())) {
    return;
  }
  found_.emplace();
  found_->fusion = fusion;
  if (search.suggestions) {
    found_->states = statesOf(fusion, *search.suggestions);
    found_->suggestions = std::move(*search.suggestions);
  } else {
    found_->error = std::move(search.suggestions.error());
  }
  setCamera();
  showFound();
}

// Which of all that were tried the fusion is as.
std::optional<std::size_t> Suggester::candidateOf(const Fusion& fusion) const {
  if (found_ && found_->fusion.id == fusion.id) {
    const std::vector<Suggestion>& candidates = found_->suggestions.candidates;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (same(candidates[i].inputs, fusion.inputs)) {
        return i;
      }
    }
  }
  return std::nullopt;
}

bool Suggester::covers(const Fusion& fusion) const {
  if (!found_ || sameState(found_->fusion, fusion)) {
    return found_.has_value();
  }
  const std::optional<std::size_t> candidate = candidateOf(fusion);
  return candidate && (found_->taken.contains(*candidate) ||
                       std::ranges::find(found_->chosen, *candidate) != found_->chosen.end());
}

void Suggester::showNone(const QString& reason) {
  pictures_->cancel();
  strip_.model()->setRows({});
  strip_.model()->setOutdated(false);
  strip_.setSentence({});
  strip_.setReason(reason);
}

void Suggester::showFound() {
  if (!found_) {
    return;
  }
  if (found_->error) {
    showNone(QString::fromStdString(found_->error->message));
    return;
  }
  const Suggestions& suggestions = found_->suggestions;
  if (suggestions.candidates.empty()) {
    showNone(
        tr("%1 other settings were tried: none makes a result that looks different.").arg(suggestions.tried));
    return;
  }
  const auto order = static_cast<SuggestionOrder>(strip_.order());
  found_->chosen = choose(suggestions, order);
  std::vector<SuggestionRow> rows;
  for (const std::size_t i : found_->chosen) {
    const Suggestion& suggestion = suggestions.candidates[i];
    rows.push_back({found_->states[i]->id, differenceText(found_->fusion.inputs, suggestion),
                    measureText(suggestion.measures, order)});
  }
  strip_.setReason({});
  strip_.model()->setRows(std::move(rows));
  strip_.model()->setOutdated(!covers(model_.committed()));
  strip_.setSentence(tr("%1 of %2 that were tried: %3")
                         .arg(found_->chosen.size())
                         .arg(suggestions.tried)
                         .arg(orderSentence(order)));
  showTaken();
  showPictures();
  requestPictures();
}

void Suggester::showTaken() {
  const std::optional<std::size_t> candidate = candidateOf(model_.committed());
  strip_.model()->setTaken(candidate ? found_->states[*candidate]->id : 0);
}

void Suggester::showPictures() {
  if (!found_) {
    return;
  }
  for (const std::size_t i : found_->chosen) {
    const VariantPictures::Shown shown = pictures_->shown(*found_->states[i]);
    if (!shown.picture.isNull()) {
      strip_.model()->setPicture(found_->states[i]->id, shown.picture);
    }
  }
}

// The first of them is drawn first.
void Suggester::requestPictures() {
  if (!found_ || !strip_.isVisible() || strip_.model()->outdated()) {
    return;
  }
  VariantList states;
  for (const std::size_t i : found_->chosen) {
    states.insert(states.begin(), found_->states[i]);
  }
  pictures_->request(states, outcome_ ? outcome_->results : nullptr);
}

void Suggester::takeView() {
  setCamera();
  requestPictures();
}

void Suggester::moveView() {
  cameraRests_.start();
}

void Suggester::setCamera() {
  if (!found_) {
    return;
  }
  // The tile as the pane sees it, larger: that is where they differ.
  if (const VariantsPage::View view = view_(); view.results && view.results->combined) {
    std::vector<Point> tile = view.results->combined->base;
    const std::vector<Point>& part = view.results->combined->part;
    tile.insert(tile.end(), part.begin(), part.end());
    PictureCamera camera = pictureCamera(view.pane, tile, kAspect);
    camera.viewAngle *= kSurroundings;
    pictures_->setCamera(camera);
  } else if (outcome_ && outcome_->results) {
    const FusionInputs& inputs = found_->fusion.inputs;
    const ViewDirection direction = firstDirection(inputs, guessYUp(inputs, true));
    pictures_->setCamera(cameraFor(*outcome_->results, FusionView::Whole, direction, kAspect));
  }
}

void Suggester::take(int id) {
  const auto i = static_cast<std::size_t>(id) - 1;
  if (!found_ || model_.dragging() || !covers(model_.committed()) ||
      i >= found_->suggestions.candidates.size()) {
    return;
  }
  const Suggestion& suggestion = found_->suggestions.candidates[i];
  const QString difference = differenceText(found_->fusion.inputs, suggestion);
  found_->taken.insert(i);
  model_.push(std::make_unique<TakeSuggestion>(model_, suggestion.inputs, difference));
  Q_EMIT told(tr("Taken: %1. Ctrl+Z takes it back.").arg(difference));
}

}  // namespace graftsman
