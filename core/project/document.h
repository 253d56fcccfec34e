#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/project/fusion.h"

namespace graftsman {

/// The fusions of a document, in the order in which they are listed; each id once. Shared: a state of the
/// document in which one fusion was edited copies that one alone.
using FusionList = std::vector<std::shared_ptr<const Fusion>>;

/// Number of a variant of a document, from 1 on, never given twice.
using VariantId = int;

/// A design alternative: a named state of all fusions. Costs no meshes.
struct Variant {
  VariantId id = 1;
  std::string name;
  std::string note;
  bool starred = false;
  FusionId shown = 1;  // of `fusions`, the one whose result the variant is about
  FusionList fusions;

  friend bool operator==(const Variant& a, const Variant& b);
};

using VariantList = std::vector<std::shared_ptr<const Variant>>;

/// Everything that a person edits and a project file keeps. A value, cheap to copy.
struct Document {
  FusionList fusions = {std::make_shared<const Fusion>()};  // at least one
  VariantList variants;

  friend bool operator==(const Document& a, const Document& b);
};

/// The fusion of that id; null if there is none.
[[nodiscard]] const Fusion* find(const FusionList& fusions, FusionId id);
/// The variant of that id; null if there is none.
[[nodiscard]] const Variant* find(const VariantList& variants, VariantId id);

/// The fusions that the result of `id` is made of, in an order in which they can be computed, `id` last.
/// Precondition: it is there. A fusion that is named but missing is left out.
[[nodiscard]] std::vector<FusionId> upstreamOf(const FusionList& fusions, FusionId id);

}  // namespace graftsman
