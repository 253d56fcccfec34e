#pragma once

#include <QString>
#include <QUndoCommand>

#include "app/document/document_model.h"

namespace graftsman {

/// An edit: a name over the document before and the document after (DESIGN.md §3). Whether it is legal was
/// decided by core, which made what is after (core/project/edits.h and document_edits.h, FCF::through()).
class EditCommand : public QUndoCommand {
 public:
  void undo() override;
  void redo() override;
  [[nodiscard]] bool changesNothing() const { return before_ == after_; }
  /// The document before and after it, and the fusion that is shown with each.
  [[nodiscard]] const Document& before() const { return before_; }
  [[nodiscard]] const Document& after() const { return after_; }
  [[nodiscard]] FusionId showsBefore() const { return shownBefore_; }
  [[nodiscard]] FusionId showsAfter() const { return shownAfter_; }
  [[nodiscard]] HistoryStep step() const;

 protected:
  /// Of the fusion that is shown.
  EditCommand(DocumentModel& model, Fusion after, const QString& text, Touched touched = {});
  /// Of the whole document; fusion `shown` is shown after it, and after its undo the one that is shown now.
  EditCommand(DocumentModel& model, Document after, FusionId shown, const QString& text);
  /// Of a history that was kept.
  EditCommand(DocumentModel& model, Document before, Document after, const HistoryStep& step);

 private:
  DocumentModel& model_;
  Document before_;
  Document after_;
  FusionId shownBefore_;
  FusionId shownAfter_;
  Touched touched_;
  bool done_ = false;  // once: from now on, redo() is a redo
};

/// An edit of a project that was closed since.
class RestoredEdit : public EditCommand {
 public:
  RestoredEdit(DocumentModel& model, Document before, Document after, const HistoryStep& step);
};

// Loop. Numbers are those that the window shows, from 0.

class AddCVP : public EditCommand {
 public:
  AddCVP(DocumentModel& model, Fusion after, int number);
};

class InsertCVP : public EditCommand {
 public:
  InsertCVP(DocumentModel& model, Fusion after, int number);
};

class MoveCVP : public EditCommand {
 public:
  MoveCVP(DocumentModel& model, Fusion after, int number, Side side);
};

/// The CVs on a result that changed stay where they were found again: those are their places now.
class KeepPlaces : public EditCommand {
 public:
  KeepPlaces(DocumentModel& model, Fusion after, int first, Side side);
};

class RemoveCVP : public EditCommand {
 public:
  /// `count` pairs, of which `first` is the first.
  RemoveCVP(DocumentModel& model, Fusion after, int first, int count);
};

class CloseLoop : public EditCommand {
 public:
  CloseLoop(DocumentModel& model, Fusion after);
};

class OpenLoop : public EditCommand {
 public:
  OpenLoop(DocumentModel& model, Fusion after);
};

class ClearLoop : public EditCommand {
 public:
  ClearLoop(DocumentModel& model, Fusion after);
};

class ReverseLoop : public EditCommand {
 public:
  ReverseLoop(DocumentModel& model, Fusion after);
};

class ShiftCorrespondence : public EditCommand {
 public:
  ShiftCorrespondence(DocumentModel& model, Fusion after);
};

class MirrorCorrespondence : public EditCommand {
 public:
  MirrorCorrespondence(DocumentModel& model, Fusion after);
};

class AllowLargeTile : public EditCommand {
 public:
  AllowLargeTile(DocumentModel& model, Fusion after);
};

class SetPathMode : public EditCommand {
 public:
  SetPathMode(DocumentModel& model, const Fusion& after);
};

class SetEmbedding : public EditCommand {
 public:
  SetEmbedding(DocumentModel& model, Fusion after);
};

// Meshes.

class LoadMesh : public EditCommand {
 public:
  LoadMesh(DocumentModel& model, const Fusion& after, Side side);
};

// Fusion curve.

class MoveFCFPoint : public EditCommand {
 public:
  MoveFCFPoint(DocumentModel& model, const FCF& curve, int point);
};

class AddFCFPoint : public EditCommand {
 public:
  AddFCFPoint(DocumentModel& model, const FCF& curve, int point);
};

class RemoveFCFPoint : public EditCommand {
 public:
  RemoveFCFPoint(DocumentModel& model, const FCF& curve, int point);
};

class SetFCFPreset : public EditCommand {
 public:
  SetFCFPreset(DocumentModel& model, FCF::Preset preset);
};

class SetFCFMonotone : public EditCommand {
 public:
  SetFCFMonotone(DocumentModel& model, const FCF& curve);
};

// Adjustment.

class SetAdjustment : public EditCommand {
 public:
  SetAdjustment(DocumentModel& model, const AdjustmentSettings& settings);
};

/// Every step on; ε and falloff as they are.
class RunAdjustment : public EditCommand {
 public:
  explicit RunAdjustment(DocumentModel& model);
};

/// The curve, adjustment and correspondence of `inputs` together; `difference` says what is new of them.
class TakeSuggestion : public EditCommand {
 public:
  TakeSuggestion(DocumentModel& model, const FusionInputs& inputs, const QString& difference);
};

/// "Linear", "Paste", …: a preset's name in the window.
[[nodiscard]] QString label(FCF::Preset preset);

/// "part" or "base", as in "Move CV 3 on the base".
[[nodiscard]] QString label(Side side);

}  // namespace graftsman
