#pragma once

#include "app/document/document_commands.h"
#include "tests/support/stacked.h"
#include "tests/support/stacked_edits.h"

/// Random edits of a document's variants, for tests.
namespace graftsman {

namespace samples {

/// Five stacked fusions and ten variants of them, each of another curve, falloff or correspondence.
inline Document tenVariantsOfStackedFusions() {
  Document document = fiveStackedFusions();
  const FusionList fusions = document.fusions;
  for (int i = 0; i < 10; ++i) {
    const FusionId id = 1 + i % 5;
    Fusion fusion = *find(fusions, id);
    fusion.inputs.fcf = *FCF::through({{0, 0}, {0.2, 0.05 * i}, {0.6, 1 - 0.04 * i}, {1, 1 - 0.08 * i}});
    fusion.inputs.adjustment.falloff = 1 + i;
    if (i % 3 == 0) {
      fusion = edits::shiftCorrespondence(std::move(fusion));
    }
    const FusionList state = edits::withFusion({fusions, {}}, std::move(fusion)).fusions;
    document = edits::addVariant(std::move(document), state, id);
  }
  return document;
}

}  // namespace samples

/// Some of the document's variants, at least one. Precondition: it has one.
inline std::set<VariantId> someVariants(const DocumentModel& model, std::mt19937& random) {
  std::set<VariantId> some;
  const VariantList& variants = model.document().variants;
  for (auto left = 1 + random() % 4; left > 0; --left) {
    some.insert(variants[random() % variants.size()]->id);
  }
  return some;
}

/// Makes a random edit of the variants: keeps, applies, removes, renames, stars or crosses some, or gives
/// several the present curve or adjustment.
inline void randomVariantEdit(DocumentModel& model, std::mt19937& random) {
  const VariantList& variants = model.document().variants;
  const auto number = [&] { return static_cast<int>(random() % 1000); };
  if (variants.size() < 6) {
    model.push(std::make_unique<AddVariant>(model));
    return;
  }
  const auto any = [&] { return variants[random() % variants.size()]->id; };
  const std::set<VariantId> some = someVariants(model, random);
  switch (random() % 10) {
    case 0:
      model.push(std::make_unique<AddVariant>(model));
      break;
    case 1: {  // a state of the history
      const History history = model.historyValue();
      if (!history.states.empty()) {
        const Document& state = history.states[random() % history.states.size()];
        model.push(std::make_unique<AddVariant>(model, state.fusions, state.fusions.back()->id));
      }
      break;
    }
    case 2:
    case 3:
      model.push(std::make_unique<ApplyVariant>(model, any()));
      break;
    case 4:
      if (variants.size() > 9) {
        model.push(std::make_unique<RemoveVariants>(model, some));
      }
      break;
    case 5:
      model.push(std::make_unique<RenameVariant>(model, any(), QString("Name %1").arg(number())));
      break;
    case 6:
      model.push(std::make_unique<StarVariants>(model, some, number() % 2 == 0));
      break;
    case 7:
      model.push(std::make_unique<ChangeVariants>(
          model, some, [curve = model.committed().inputs.fcf](Fusion& fusion) { fusion.inputs.fcf = curve; },
          "Curve"));
      break;
    case 8:
      model.push(std::make_unique<ChangeVariants>(
          model, some,
          [settings = model.committed().inputs.adjustment](Fusion& fusion) {
            fusion.inputs.adjustment = settings;
          },
          "Adjustment"));
      break;
    default:
      model.push(std::make_unique<CrossVariants>(model, any(), any()));
      break;
  }
}

}  // namespace graftsman
