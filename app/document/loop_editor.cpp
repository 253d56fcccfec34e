#include "app/document/loop_editor.h"

#include <utility>

#include "app/document/commands.h"
#include "app/document/document_model.h"
#include "core/fusion/path_position.h"
#include "core/mesh/attach.h"
#include "core/project/edits.h"

namespace graftsman {
namespace {

Error error(ErrorCode code, const QString& message, Side side) {
  return {code, message.toStdString(), side};
}

// The paths of one mesh that are seen in `outcome`.
const std::vector<std::shared_ptr<const Path>>* pathsOf(const Outcome& outcome, Side side) {
  const auto& open = side == Side::Part ? outcome.openPart : outcome.openBase;
  if (open) {
    return &open->paths;
  }
  if (!outcome.results) {
    return nullptr;
  }
  const SideResults& results = side == Side::Part ? outcome.results->part : outcome.results->base;
  return results.paths ? &results.paths->paths : nullptr;
}

// The mesh that those paths run on. Precondition: pathsOf() has one.
const AnchoredLoop& anchoredOf(const Outcome& outcome, Side side) {
  const auto& open = side == Side::Part ? outcome.openPart : outcome.openBase;
  return open ? *open->anchored
              : *(side == Side::Part ? outcome.results->part : outcome.results->base).anchored;
}

Side other(Side side) {
  return side == Side::Part ? Side::Base : Side::Part;
}

}  // namespace

LoopEditor::LoopEditor(DocumentModel& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&model, &DocumentModel::changed, this, [this](Change change) {
    if (change == Change::Drag) {
      return;
    }
    if (change == Change::Shown || change == Change::Reset) {
      setHalfPair({});
      select({});
    }
    // An upstream result may be computed during a drag; where it is on that very mesh, the pane ends it.
    if (change != Change::Upstream) {
      drag_.reset();
    }
    forgetWhatIsGone();
  });
}

void LoopEditor::select(const QSet<int>& pairs) {
  if (std::exchange(selection_, pairs) != pairs) {
    Q_EMIT selectionChanged(selection_);
  }
}

void LoopEditor::pick(Side side, const SurfacePoint& at) {
  beforePick_ = {half_, model_.history()->index()};
  const Fusion& fusion = model_.committed();
  if (fusion.closed) {
    Q_EMIT refused(
        error(ErrorCode::LoopRepeatsPoint,
              tr("The loop is closed. Click on a path to insert a pair, or open the loop to go on."), side));
    return;
  }
  // A CV that could not stand there is refused at once, not when its partner comes.
  for (std::size_t i = 0; i < fusion.inputs.loop.size(); ++i) {
    const CVP& pair = fusion.inputs.loop[i];
    if ((side == Side::Part ? pair.part : pair.base) == at) {
      clickCV(static_cast<int>(i));
      return;
    }
  }
  if (!half_ || half_->side == side) {
    setHalfPair(HalfPair{side, at});
    return;
  }
  const CVP pair = side == Side::Part ? CVP{at, half_->at} : CVP{half_->at, at};
  const std::size_t number = fusion.inputs.loop.size();
  Result<Fusion> after = edits::insertPair(fusion, number, pair);
  if (!after) {
    Q_EMIT refused(after.error());
    return;
  }
  setHalfPair({});
  model_.push(std::make_unique<AddCVP>(model_, std::move(*after), static_cast<int>(number)));
}

void LoopEditor::clickCV(int number) {
  if (number == 0 && !model_.committed().closed && !half_ && model_.committed().inputs.loop.size() >= 3) {
    close();
    return;
  }
  select({number});
}

void LoopEditor::insertOnPath(Side side, int number, const SurfacePoint& at, const Outcome* seen) {
  beforePick_ = {half_, model_.history()->index()};
  const auto* own = seen ? pathsOf(*seen, side) : nullptr;
  const auto* opposite = seen ? pathsOf(*seen, other(side)) : nullptr;
  const auto index = static_cast<std::size_t>(number);
  if (!own || !opposite || index >= own->size() || index >= opposite->size() || !(*own)[index] ||
      !(*opposite)[index]) {
    Q_EMIT refused(
        error(ErrorCode::PathImpossible,
              tr("The %1 has no such path yet. Mend the loop there first.").arg(label(other(side))), side));
    return;
  }
  const Fusion& fusion = model_.committed();
  const auto& ownMesh = side == Side::Part ? fusion.inputs.part : fusion.inputs.base;
  const double fraction =
      fractionNearest(*(*own)[index], *anchoredOf(*seen, side).mesh, positionOf(*ownMesh, at));
  const auto& oppositeMesh = side == Side::Part ? fusion.inputs.base : fusion.inputs.part;
  const std::optional<SurfacePoint> partner =
      pointAlong(*(*opposite)[index], anchoredOf(*seen, other(side)), oppositeMesh->vertexCount(), fraction);
  if (!partner) {
    Q_EMIT refused(
        error(ErrorCode::PathImpossible,
              tr("There is no room for a pair on the %1's path. Take a finer mesh, or move its ends apart.")
                  .arg(label(other(side))),
              other(side)));
    return;
  }
  const CVP pair = side == Side::Part ? CVP{at, *partner} : CVP{*partner, at};
  Result<Fusion> after = edits::insertPair(fusion, index + 1, pair);
  if (!after) {
    Q_EMIT refused(after.error());
    return;
  }
  model_.push(std::make_unique<InsertCVP>(model_, std::move(*after), number + 1));
  select({number + 1});
}

void LoopEditor::takeBackPick() {
  const std::optional<BeforePick> before = std::exchange(beforePick_, {});
  if (!before) {
    return;
  }
  if (model_.history()->index() == before->historyIndex + 1) {
    model_.history()->undo();
  }
  setHalfPair(before->half);
}

void LoopEditor::startDrag(Side side, int number) {
  drag_ = Drag{side, number, {}};
  select({number});
}

void LoopEditor::dragTo(Side side, int number, const SurfacePoint& to) {
  if (!drag_ || drag_->side != side || drag_->number != number ||
      number >= static_cast<int>(model_.committed().inputs.loop.size())) {
    return;
  }
  Result<Fusion> moved = edits::moveCV(model_.committed(), static_cast<std::size_t>(number), side, to);
  if (moved) {
    drag_->fusion = *moved;
    model_.drag(std::move(*moved));
  }
}

void LoopEditor::finishDrag() {
  const std::optional<Drag> drag = std::exchange(drag_, {});
  if (drag && drag->fusion) {
    model_.push(std::make_unique<MoveCVP>(model_, *drag->fusion, drag->number, drag->side));
  }
}

void LoopEditor::cancelDrag() {
  drag_.reset();
  model_.cancelDrag();
}

void LoopEditor::keepPlaces(Side side) {
  Result<Fusion> after = model_.committed();
  int first = -1;
  for (const Error& moved : movedCVs(*after)) {
    for (const int number : moved.side == side ? moved.cvs : std::vector<int>()) {
      const auto at = static_cast<std::size_t>(number);
      const CVP pair = after->inputs.loop[at];
      after = edits::moveCV(std::move(*after), at, side, side == Side::Part ? pair.part : pair.base);
      if (!after) {
        Q_EMIT refused(after.error());
        return;
      }
      first = first < 0 ? number : first;
    }
  }
  if (first >= 0) {
    model_.push(std::make_unique<KeepPlaces>(model_, std::move(*after), first, side));
  }
}

void LoopEditor::remove(const QSet<int>& pairs) {
  std::set<int> numbers;
  for (const int number : pairs) {
    if (number >= 0 && number < static_cast<int>(model_.committed().inputs.loop.size())) {
      numbers.insert(number);
    }
  }
  if (!numbers.empty()) {
    model_.push(std::make_unique<RemoveCVP>(model_, edits::removePairs(model_.committed(), numbers),
                                            *numbers.begin(), static_cast<int>(numbers.size())));
  }
}

void LoopEditor::close() {
  Result<Fusion> after = edits::closeLoop(model_.committed());
  if (!after) {
    Q_EMIT refused(after.error());
    return;
  }
  setHalfPair({});
  model_.push(std::make_unique<CloseLoop>(model_, std::move(*after)));
}

void LoopEditor::open() {
  model_.push(std::make_unique<OpenLoop>(model_, edits::openLoop(model_.committed())));
}

void LoopEditor::reverse() {
  model_.push(std::make_unique<ReverseLoop>(model_, edits::reverseLoop(model_.committed())));
}

void LoopEditor::shift() {
  model_.push(std::make_unique<ShiftCorrespondence>(model_, edits::shiftCorrespondence(model_.committed())));
}

void LoopEditor::mirror() {
  model_.push(
      std::make_unique<MirrorCorrespondence>(model_, edits::mirrorCorrespondence(model_.committed())));
}

void LoopEditor::clear() {
  setHalfPair({});
  model_.push(std::make_unique<ClearLoop>(model_, edits::clearLoop(model_.committed())));
}

void LoopEditor::allowLargeTile() {
  Fusion after = model_.committed();
  after.inputs.tile.allowLargeTile = true;
  model_.push(std::make_unique<AllowLargeTile>(model_, std::move(after)));
}

bool LoopEditor::backOut() {
  if (half_) {
    setHalfPair({});
    return true;
  }
  if (!selection_.isEmpty()) {
    select({});
    return true;
  }
  return false;
}

void LoopEditor::setHalfPair(std::optional<HalfPair> half) {
  if (half_ || half) {
    half_ = std::move(half);
    const FusionInputs& inputs = model_.committed().inputs;
    halfMesh_ = !half_ ? nullptr : half_->side == Side::Part ? inputs.part : inputs.base;
    Q_EMIT halfPairChanged();
  }
}

// After an edit, an undo or another document.
void LoopEditor::forgetWhatIsGone() {
  const Fusion& fusion = model_.committed();
  const auto count = static_cast<int>(fusion.inputs.loop.size());
  if (half_) {
    const auto& mesh = half_->side == Side::Part ? fusion.inputs.part : fusion.inputs.base;
    const bool there = mesh == halfMesh_ || (mesh && fusion.upstream(half_->side) != 0);
    if (!there || fusion.closed) {
      setHalfPair({});
    } else if (mesh != halfMesh_) {
      // As a CV of a whole pair: found again on the result that was computed anew.
      HalfPair again = *half_;
      again.at.place = positionOf(*halfMesh_, again.at);
      again.at = attach(*mesh, again.at);
      again.at.place.reset();
      setHalfPair(std::move(again));
    }
  }
  QSet<int> kept;
  for (const int number : std::as_const(selection_)) {
    if (number < count) {
      kept.insert(number);
    }
  }
  select(kept);
}

}  // namespace graftsman
