#include "app/document/commands.h"

#include <QCoreApplication>
#include <utility>

#include "core/project/document_edits.h"

namespace graftsman {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("graftsman::EditCommand", text);
}

Touched cv(int number, std::optional<Side> side = {}) {
  Touched touched;
  touched.cv = number;
  touched.side = side;
  return touched;
}

Touched curvePoint(int point) {
  Touched touched;
  touched.curvePoint = point;
  return touched;
}

Touched adjustment() {
  Touched touched;
  touched.adjustment = true;
  return touched;
}

// Without what went away on the way from `before` to `after`: another one has its number now.
Touched stillThere(Touched touched, const Document& before, const Document& after, FusionId shown) {
  const Fusion* from = find(before.fusions, shown);
  const Fusion* to = find(after.fusions, shown);
  if (from == nullptr || to == nullptr) {
    return {};
  }
  if (to->inputs.loop.size() < from->inputs.loop.size()) {
    touched.cv.reset();
  }
  if (to->inputs.fcf.points().size() < from->inputs.fcf.points().size()) {
    touched.curvePoint.reset();
  }
  return touched;
}

Fusion withCurve(const DocumentModel& model, const FCF& curve) {
  Fusion fusion = model.committed();
  fusion.inputs.fcf = curve;
  return fusion;
}

Fusion withAdjustment(const DocumentModel& model, const AdjustmentSettings& settings) {
  Fusion fusion = model.committed();
  fusion.inputs.adjustment = settings;
  return fusion;
}

Fusion withSuggestion(const DocumentModel& model, const FusionInputs& inputs) {
  Fusion fusion = model.committed();
  fusion.inputs.fcf = inputs.fcf;
  fusion.inputs.adjustment = inputs.adjustment;
  fusion.inputs.loop = inputs.loop;
  return fusion;
}

AdjustmentSettings everyStepOn(AdjustmentSettings settings) {
  settings.rigid = settings.scale = settings.lineField = true;
  return settings;
}

// What differs, as a person would say it.
QString adjustmentText(const AdjustmentSettings& before, const AdjustmentSettings& after) {
  const auto switched = [](const QString& step, bool on) {
    return (on ? tr("Turn on %1") : tr("Turn off %1")).arg(step);
  };
  if (before.rigid != after.rigid) {
    return switched(tr("rigid step"), after.rigid);
  }
  if (before.scale != after.scale) {
    return switched(tr("scale step"), after.scale);
  }
  if (before.lineField != after.lineField) {
    return switched(tr("line field"), after.lineField);
  }
  if (before.exactFit != after.exactFit) {
    return switched(tr("exact fit"), after.exactFit);
  }
  if (before.falloff != after.falloff) {
    return tr("Set falloff to %1").arg(after.falloff);
  }
  if (before.epsilon != after.epsilon) {
    return tr("Set ε to %1 %").arg(after.epsilon * 100);
  }
  return tr("Set iterations to %1").arg(after.maxIterations);
}

}  // namespace

EditCommand::EditCommand(DocumentModel& model, Fusion after, const QString& text, Touched touched)
    : QUndoCommand(text),
      model_(model),
      before_(model.document()),
      after_(edits::withFusion(model.document(), std::move(after))),
      shownBefore_(model.shown()),
      shownAfter_(model.shown()),
      touched_(touched) {}

EditCommand::EditCommand(DocumentModel& model, Document after, FusionId shown, const QString& text)
    : QUndoCommand(text),
      model_(model),
      before_(model.document()),
      after_(std::move(after)),
      shownBefore_(model.shown()),
      shownAfter_(shown) {}

EditCommand::EditCommand(DocumentModel& model, Document before, Document after, const HistoryStep& step)
    : QUndoCommand(QString::fromStdString(step.text)),
      model_(model),
      before_(std::move(before)),
      after_(std::move(after)),
      shownBefore_(step.shownBefore),
      shownAfter_(step.shownAfter),
      touched_{.cv = step.cv, .side = {}, .curvePoint = step.curvePoint, .adjustment = false} {}

HistoryStep EditCommand::step() const {
  return {text().toStdString(), shownBefore_, shownAfter_, touched_.cv, touched_.curvePoint};
}

void EditCommand::undo() {
  model_.apply(before_, shownBefore_, Change::History, stillThere(touched_, after_, before_, shownBefore_));
}

void EditCommand::redo() {
  model_.apply(after_, shownAfter_, done_ ? Change::History : Change::Edit,
               stillThere(touched_, before_, after_, shownAfter_));
  done_ = true;
}

RestoredEdit::RestoredEdit(DocumentModel& model, Document before, Document after, const HistoryStep& step)
    : EditCommand(model, std::move(before), std::move(after), step) {}

AddCVP::AddCVP(DocumentModel& model, Fusion after, int number)
    : EditCommand(model, std::move(after), tr("Add pair %1").arg(number), cv(number)) {}

InsertCVP::InsertCVP(DocumentModel& model, Fusion after, int number)
    : EditCommand(model, std::move(after), tr("Insert pair %1").arg(number), cv(number)) {}

MoveCVP::MoveCVP(DocumentModel& model, Fusion after, int number, Side side)
    : EditCommand(model, std::move(after), tr("Move CV %1 on the %2").arg(number).arg(label(side)),
                  cv(number, side)) {}

KeepPlaces::KeepPlaces(DocumentModel& model, Fusion after, int first, Side side)
    : EditCommand(model, std::move(after), tr("Leave the moved CVs on the %1").arg(label(side)), cv(first)) {}

RemoveCVP::RemoveCVP(DocumentModel& model, Fusion after, int first, int count)
    : EditCommand(model, std::move(after),
                  count == 1 ? tr("Remove pair %1").arg(first) : tr("Remove %1 pairs").arg(count),
                  cv(first)) {}

CloseLoop::CloseLoop(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Close the loop")) {}

OpenLoop::OpenLoop(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Open the loop")) {}

ClearLoop::ClearLoop(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Remove all pairs")) {}

ReverseLoop::ReverseLoop(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Reverse the loop")) {}

ShiftCorrespondence::ShiftCorrespondence(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Shift the correspondence")) {}

MirrorCorrespondence::MirrorCorrespondence(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Mirror the correspondence")) {}

AllowLargeTile::AllowLargeTile(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Take the large side of the loop")) {}

SetPathMode::SetPathMode(DocumentModel& model, const Fusion& after)
    : EditCommand(model, after,
                  after.inputs.paths == PathMode::Paper ? tr("Take the paper's paths")
                                                        : tr("Straighten the paths")) {}

SetEmbedding::SetEmbedding(DocumentModel& model, Fusion after)
    : EditCommand(model, std::move(after), tr("Change the embedding")) {}

LoadMesh::LoadMesh(DocumentModel& model, const Fusion& after, Side side)
    : EditCommand(model, after,
                  tr("Load %1 as the %2").arg(QString::fromStdString(after.of(side)->name), label(side))) {}

MoveFCFPoint::MoveFCFPoint(DocumentModel& model, const FCF& curve, int point)
    : EditCommand(model, withCurve(model, curve), tr("Move curve point %1").arg(point), curvePoint(point)) {}

AddFCFPoint::AddFCFPoint(DocumentModel& model, const FCF& curve, int point)
    : EditCommand(model, withCurve(model, curve), tr("Add curve point %1").arg(point), curvePoint(point)) {}

RemoveFCFPoint::RemoveFCFPoint(DocumentModel& model, const FCF& curve, int point)
    : EditCommand(model, withCurve(model, curve), tr("Remove curve point %1").arg(point), curvePoint(point)) {
}

SetFCFPreset::SetFCFPreset(DocumentModel& model, FCF::Preset preset)
    : EditCommand(model, withCurve(model, FCF::preset(preset)), tr("Curve: %1").arg(label(preset))) {}

SetFCFMonotone::SetFCFMonotone(DocumentModel& model, const FCF& curve)
    : EditCommand(model, withCurve(model, curve),
                  curve.monotone() ? tr("Keep the curve monotone") : tr("Let the curve swing")) {}

SetAdjustment::SetAdjustment(DocumentModel& model, const AdjustmentSettings& settings)
    : EditCommand(model, withAdjustment(model, settings),
                  adjustmentText(model.committed().inputs.adjustment, settings), adjustment()) {}

RunAdjustment::RunAdjustment(DocumentModel& model)
    : EditCommand(model, withAdjustment(model, everyStepOn(model.committed().inputs.adjustment)),
                  tr("Run the adjustment"), adjustment()) {}

TakeSuggestion::TakeSuggestion(DocumentModel& model, const FusionInputs& inputs, const QString& difference)
    : EditCommand(model, withSuggestion(model, inputs), tr("Take suggestion: %1").arg(difference),
                  model.committed().inputs.adjustment == inputs.adjustment ? Touched() : adjustment()) {}

QString label(FCF::Preset preset) {
  switch (preset) {
    case FCF::Preset::Linear:
      return tr("Linear");
    case FCF::Preset::Paste:
      return tr("Paste");
    case FCF::Preset::KeepBaseSlope:
      return tr("Keep base slope");
    case FCF::Preset::Half:
      return tr("Half");
  }
  return {};
}

QString label(Side side) {
  return side == Side::Part ? tr("part") : tr("base");
}

}  // namespace graftsman
