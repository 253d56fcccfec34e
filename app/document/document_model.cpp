#include "app/document/document_model.h"

#include <utility>

#include "app/document/commands.h"
#include "core/project/document_edits.h"

namespace graftsman {

Document DocumentModel::shownDocument() const {
  return dragged_ ? edits::withFusion(document_, *dragged_) : document_;
}

void DocumentModel::push(std::unique_ptr<EditCommand> command) {
  if (command->changesNothing()) {
    cancelDrag();
    return;
  }
  history_.push(command.release());
}

void DocumentModel::drag(Fusion fusion) {
  dragged_ = std::move(fusion);
  Q_EMIT changed(Change::Drag, {});
}

void DocumentModel::cancelDrag() {
  if (dragged_) {
    dragged_.reset();
    Q_EMIT changed(Change::Drag, {});
  }
}

void DocumentModel::show(FusionId id) {
  if (id != fusion_.id && find(document_.fusions, id) != nullptr) {
    dragged_.reset();
    take(document_, id);
    Q_EMIT changed(Change::Shown, {});
  }
}

void DocumentModel::reset(const Document& document, FusionId shown, const History& past) {
  dragged_.reset();
  assets_.clear();
  take(document, shown);
  refill(past);
  Q_EMIT changed(Change::Reset, {});
  Q_EMIT documentChanged();
}

History DocumentModel::historyValue() const {
  History value;
  value.index = history_.index();
  for (int i = 0; i < history_.count(); ++i) {
    // push() and refill() let nothing else in.
    const auto& edit = static_cast<const EditCommand&>(*history_.command(i));
    value.steps.push_back(edit.step());
    value.states.push_back(edit.before());
    if (i + 1 == history_.count()) {
      value.states.push_back(edit.after());
    }
  }
  return value;
}

void DocumentModel::forgetHistory() {
  refill({});
}

// What listens is told once, not of each step.
void DocumentModel::refill(const History& past) {
  refilling_ = true;
  history_.blockSignals(true);
  history_.clear();
  for (std::size_t i = 0; i < past.steps.size(); ++i) {
    history_.push(new RestoredEdit(*this, past.states[i], past.states[i + 1], past.steps[i]));
  }
  history_.setIndex(past.index);
  history_.setClean();
  history_.blockSignals(false);
  refilling_ = false;
  Q_EMIT history_.indexChanged(history_.index());
  Q_EMIT history_.cleanChanged(history_.isClean());
  Q_EMIT history_.canUndoChanged(history_.canUndo());
  Q_EMIT history_.canRedoChanged(history_.canRedo());
  Q_EMIT history_.undoTextChanged(history_.undoText());
  Q_EMIT history_.redoTextChanged(history_.redoText());
}

void DocumentModel::reset(const Fusion& fusion) {
  reset({{std::make_shared<const Fusion>(fusion)}, {}}, fusion.id);
}

void DocumentModel::setResultAssets(const ResultAssets& assets, const Fusion& computed) {
  bool concerned = false;
  for (const auto& [id, asset] : assets) {
    auto& known = assets_[id];
    if (known != asset) {
      known = asset;
      concerned = concerned || fusion_.upstream(Side::Part) == id || fusion_.upstream(Side::Base) == id;
    }
  }
  if (concerned) {
    // Its CVs were found again already: not twice, and not in the GUI thread.
    fusion_ = resolve(computed == fusion_ ? computed : fusion_, assets_);
    if (dragged_) {
      dragged_ = resolve(std::move(*dragged_), assets_);
    }
    Q_EMIT changed(Change::Upstream, {});
  }
}

void DocumentModel::apply(const Document& document, FusionId shown, Change change, const Touched& touched) {
  if (refilling_) {
    return;
  }
  dragged_.reset();
  const bool another = shown != fusion_.id;
  take(document, shown);
  if (another) {
    Q_EMIT changed(Change::Shown, {});
  }
  Q_EMIT changed(change, touched);
  Q_EMIT documentChanged();
}

void DocumentModel::take(const Document& document, FusionId shown) {
  document_ = document;
  const Fusion* fusion = find(document_.fusions, shown);
  fusion_ = resolve(fusion != nullptr ? *fusion : *document_.fusions.back(), assets_);
}

}  // namespace graftsman
