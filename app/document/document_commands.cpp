#include "app/document/document_commands.h"

#include <QCoreApplication>
#include <utility>

#include "core/project/document_edits.h"

namespace graftsman {
namespace {

QString words(const char* text) {
  return QCoreApplication::translate("graftsman::EditCommand", text);
}

QString fusionName(const DocumentModel& model, FusionId id) {
  return QString::fromStdString(label(*find(model.document().fusions, id)));
}

QString variantName(const DocumentModel& model, VariantId id) {
  return QString::fromStdString(find(model.document().variants, id)->name);
}

// "Rib", "3 variants".
QString variantNames(const DocumentModel& model, const std::set<VariantId>& ids) {
  return ids.size() == 1 ? variantName(model, *ids.begin()) : words("%1 variants").arg(ids.size());
}

// The fusion that is shown once this one is gone.
FusionId besides(const DocumentModel& model, FusionId gone, const Document& after) {
  return model.shown() == gone ? after.fusions.back()->id : model.shown();
}

Document withVariant(const DocumentModel& model, VariantId id, const std::function<void(Variant&)>& change) {
  Variant variant = *find(model.document().variants, id);
  change(variant);
  return edits::withVariant(model.document(), std::move(variant));
}

Document withStars(Document document, const std::set<VariantId>& ids, bool starred) {
  for (const VariantId id : ids) {
    Variant variant = *find(document.variants, id);
    variant.starred = starred;
    document = edits::withVariant(std::move(document), std::move(variant));
  }
  return document;
}

Document withVariants(Document document, const std::vector<std::pair<FusionList, QString>>& states,
                      FusionId shown) {
  for (const auto& [fusions, name] : states) {
    document = edits::addVariant(std::move(document), fusions, shown, name.toStdString());
  }
  return document;
}

FusionId shownAfter(const DocumentModel& model, VariantId id) {
  const Variant& variant = *find(model.document().variants, id);
  return find(variant.fusions, model.shown()) != nullptr ? model.shown() : variant.shown;
}

}  // namespace

AddFusion::AddFusion(DocumentModel& model, std::shared_ptr<const MeshAsset> part,
                     std::shared_ptr<const MeshAsset> base)
    : EditCommand(model, edits::addFusion(model.document(), std::move(part), std::move(base)),
                  edits::nextFusion(model.document()), words("Add a fusion")) {}

RemoveFusion::RemoveFusion(DocumentModel& model, FusionId id)
    : EditCommand(model, edits::removeFusion(model.document(), id),
                  besides(model, id, edits::removeFusion(model.document(), id)),
                  words("Remove “%1”").arg(fusionName(model, id))) {}

RenameFusion::RenameFusion(DocumentModel& model, FusionId id, const QString& name)
    : EditCommand(model, edits::renameFusion(model.document(), id, name.toStdString()), model.shown(),
                  words("Rename “%1” to “%2”").arg(fusionName(model, id), name)) {}

TakeResult::TakeResult(DocumentModel& model, Document after, FusionId id, Side side, FusionId upstream)
    : EditCommand(model, std::move(after), id,
                  words("Take “%1” as the %2").arg(fusionName(model, upstream), label(side))) {}

AddVariant::AddVariant(DocumentModel& model)
    : EditCommand(model, edits::addVariant(model.document(), model.shown()), model.shown(),
                  words("Keep as a variant")) {}

AddVariant::AddVariant(DocumentModel& model, const FusionList& fusions, FusionId shown, const QString& name)
    : EditCommand(model, edits::addVariant(model.document(), fusions, shown, name.toStdString()),
                  model.shown(), words("Keep as a variant")) {}

RemoveVariants::RemoveVariants(DocumentModel& model, const std::set<VariantId>& ids)
    : EditCommand(model, edits::removeVariants(model.document(), ids), model.shown(),
                  words("Remove “%1”").arg(variantNames(model, ids))) {}

RenameVariant::RenameVariant(DocumentModel& model, VariantId id, const QString& name)
    : EditCommand(model, withVariant(model, id, [&](Variant& variant) { variant.name = name.toStdString(); }),
                  model.shown(), words("Rename “%1” to “%2”").arg(variantName(model, id), name)) {}

NoteVariant::NoteVariant(DocumentModel& model, VariantId id, const QString& note)
    : EditCommand(model, withVariant(model, id, [&](Variant& variant) { variant.note = note.toStdString(); }),
                  model.shown(), words("Note on “%1”").arg(variantName(model, id))) {}

StarVariants::StarVariants(DocumentModel& model, const std::set<VariantId>& ids, bool starred)
    : EditCommand(model, withStars(model.document(), ids, starred), model.shown(),
                  (starred ? words("Star “%1”") : words("Unstar “%1”")).arg(variantNames(model, ids))) {}

ApplyVariant::ApplyVariant(DocumentModel& model, VariantId id)
    : EditCommand(model, edits::applyVariant(model.document(), id), shownAfter(model, id),
                  words("Apply “%1”").arg(variantName(model, id))) {}

ChangeVariants::ChangeVariants(DocumentModel& model, const std::set<VariantId>& ids,
                               const std::function<void(Fusion&)>& change, const QString& what)
    : EditCommand(model, edits::changeVariants(model.document(), ids, change), model.shown(),
                  words("%1 of “%2”").arg(what, variantNames(model, ids))) {}

CrossVariants::CrossVariants(DocumentModel& model, VariantId loop, VariantId curve)
    : EditCommand(model, edits::crossVariants(model.document(), loop, curve), model.shown(),
                  words("Cross “%1” with “%2”").arg(variantName(model, loop), variantName(model, curve))) {}

AddVariants::AddVariants(DocumentModel& model, const std::vector<std::pair<FusionList, QString>>& states,
                         FusionId shown, const QString& what)
    : EditCommand(model, withVariants(model.document(), states, shown), model.shown(), what) {}

}  // namespace graftsman
