#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "core/project/document.h"
#include "core/sweep/sweep_file.h"

namespace graftsman {

/// A value that can be chosen for a parameter.
template <class T>
struct Offered {
  QString name;  // unlike all others of its list, also in the name of a file
  T value;
  bool present = false;  // what the fusion has now
};

/// The values that a sweep over a fusion can be made of.
struct SweepOffer {
  QString problem;  // why there can be no sweep, and what to do; empty: there can
  FusionList fusions;
  FusionId shown = 1;
  /// The fusion with the part and pairs of the present state, then of the document's variants: those on the
  /// same base whose part or pairs are others.
  std::vector<Offered<Fusion>> parts;
  std::vector<Offered<EmbeddingSettings::Method>> embeddings;
  std::vector<Offered<int>> shifts;
  std::vector<Offered<AdjustmentSettings>> adjustments;
  std::vector<Offered<FCF>> curves;  // presets, the present one, those of the variants
  double falloff = 0;                // the present one
};

/// What can be varied of fusion `shown`. Precondition: the document has it.
[[nodiscard]] SweepOffer sweepOffer(const Document& document, FusionId shown);

/// A sweep as it was chosen: the document's fusions at that moment, and values for one of them.
struct SweepPlan {
  FusionList fusions;
  FusionId shown = 1;
  std::vector<Offered<Fusion>> parts;  // empty: the fusion's own
  Sweep values;                        // the other lists; without base and parts

  SweepOutput output;  // of the folder
  std::optional<std::filesystem::path> folder;
  std::vector<std::filesystem::path> sources;  // that may not be overwritten

  [[nodiscard]] std::size_t count() const;
  /// The fusion that combination `number` varies, as the document has it. Combinations are numbered as
  /// Sweep's. Precondition for this and the next two: number < count().
  [[nodiscard]] const Fusion& origin(std::size_t number) const;
  /// "Paste, falloff 3".
  [[nodiscard]] QString name(std::size_t number) const;
  /// The document's fusions with that combination in place of the one that is varied.
  [[nodiscard]] FusionList state(std::size_t number) const;
  /// What to give to core's check(): with parts that have a name alone.
  [[nodiscard]] Sweep checked() const;
};

/// "4 curves × 3 falloffs = 12 results".
[[nodiscard]] QString countText(const SweepPlan& plan);

/// The names, those that `taken` has (or that come twice) with a number: "Paste 2".
[[nodiscard]] std::vector<QString> uniqueNames(const std::vector<QString>& names, const VariantList& taken);

}  // namespace graftsman
