#pragma once

#include <QString>
#include <QUndoCommand>

#include "app/document/document_model.h"
#include "core/project/document.h"

namespace graftsman {

/// An edit: a name over the document before and the document after (DESIGN.md §3). Whether it is legal was
/// decided by core, which made the document after (core/project/edits.h, FCF::through()).
class EditCommand : public QUndoCommand {
 public:
  void undo() override;
  void redo() override;
  [[nodiscard]] bool changesNothing() const { return before_ == after_; }

 protected:
  EditCommand(DocumentModel& model, Document after, const QString& text, Touched touched = {});

 private:
  DocumentModel& model_;
  Document before_;
  Document after_;
  Touched touched_;
  bool done_ = false;  // once: from now on, redo() is a redo
};

// Loop. Numbers are those that the window shows, from 0.

class AddCVP : public EditCommand {
 public:
  AddCVP(DocumentModel& model, Document after, int number);
};

class InsertCVP : public EditCommand {
 public:
  InsertCVP(DocumentModel& model, Document after, int number);
};

class MoveCVP : public EditCommand {
 public:
  MoveCVP(DocumentModel& model, Document after, int number, Side side);
};

class RemoveCVP : public EditCommand {
 public:
  /// `count` pairs, of which `first` is the first.
  RemoveCVP(DocumentModel& model, Document after, int first, int count);
};

class CloseLoop : public EditCommand {
 public:
  CloseLoop(DocumentModel& model, Document after);
};

class OpenLoop : public EditCommand {
 public:
  OpenLoop(DocumentModel& model, Document after);
};

class ClearLoop : public EditCommand {
 public:
  ClearLoop(DocumentModel& model, Document after);
};

class ReverseLoop : public EditCommand {
 public:
  ReverseLoop(DocumentModel& model, Document after);
};

class ShiftCorrespondence : public EditCommand {
 public:
  ShiftCorrespondence(DocumentModel& model, Document after);
};

class MirrorCorrespondence : public EditCommand {
 public:
  MirrorCorrespondence(DocumentModel& model, Document after);
};

class AllowLargeTile : public EditCommand {
 public:
  AllowLargeTile(DocumentModel& model, Document after);
};

class SetPathMode : public EditCommand {
 public:
  SetPathMode(DocumentModel& model, const Document& after);
};

class SetEmbedding : public EditCommand {
 public:
  SetEmbedding(DocumentModel& model, Document after);
};

// Meshes.

class LoadMesh : public EditCommand {
 public:
  LoadMesh(DocumentModel& model, const Document& after, Side side);
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

/// "Linear", "Paste", …: a preset's name in the window.
[[nodiscard]] QString label(FCF::Preset preset);

/// "part" or "base", as in "Move CV 3 on the base".
[[nodiscard]] QString label(Side side);

}  // namespace graftsman
