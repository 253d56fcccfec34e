#pragma once

#include <functional>
#include <set>

#include "app/document/commands.h"

namespace graftsman {

// Fusions of a document. `id` names one that it has.

/// Another fusion, which is shown; null: nothing loaded on that side yet.
class AddFusion : public EditCommand {
 public:
  AddFusion(DocumentModel& model, std::shared_ptr<const MeshAsset> part,
            std::shared_ptr<const MeshAsset> base);
};

class RemoveFusion : public EditCommand {
 public:
  RemoveFusion(DocumentModel& model, FusionId id);
};

class RenameFusion : public EditCommand {
 public:
  RenameFusion(DocumentModel& model, FusionId id, const QString& name);
};

/// The result of one fusion as the part or base of another (edits::takeResult() made `after`).
class TakeResult : public EditCommand {
 public:
  TakeResult(DocumentModel& model, Document after, FusionId id, Side side, FusionId upstream);
};

// Variants. `ids` name some that the document has.

class AddVariant : public EditCommand {
 public:
  /// The present state.
  explicit AddVariant(DocumentModel& model);
  /// Another state of the fusions, for example one of the history.
  AddVariant(DocumentModel& model, const FusionList& fusions, FusionId shown, const QString& name = {});
};

class RemoveVariants : public EditCommand {
 public:
  RemoveVariants(DocumentModel& model, const std::set<VariantId>& ids);
};

class RenameVariant : public EditCommand {
 public:
  RenameVariant(DocumentModel& model, VariantId id, const QString& name);
};

class NoteVariant : public EditCommand {
 public:
  NoteVariant(DocumentModel& model, VariantId id, const QString& note);
};

class StarVariants : public EditCommand {
 public:
  StarVariants(DocumentModel& model, const std::set<VariantId>& ids, bool starred);
};

/// The fusions become as they are in the variant.
class ApplyVariant : public EditCommand {
 public:
  ApplyVariant(DocumentModel& model, VariantId id);
};

/// One change of the fusion that each variant shows: its curve, its adjustment.
class ChangeVariants : public EditCommand {
 public:
  ChangeVariants(DocumentModel& model, const std::set<VariantId>& ids,
                 const std::function<void(Fusion&)>& change, const QString& what);
};

/// A new variant: the loop of one, the curve of the other.
class CrossVariants : public EditCommand {
 public:
  CrossVariants(DocumentModel& model, VariantId loop, VariantId curve);
};

/// Several new variants at once, as a sweep makes them: each state of the fusions with its name.
class AddVariants : public EditCommand {
 public:
  AddVariants(DocumentModel& model, const std::vector<std::pair<FusionList, QString>>& states, FusionId shown,
              const QString& what);
};

}  // namespace graftsman
