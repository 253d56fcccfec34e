#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fusion/update.h"

namespace graftsman {

/// Another part, with the pairs that go with it.
struct SweepPart {
  std::string name;
  std::filesystem::path source;              // the file that it comes from, if any
  std::shared_ptr<const TriangleMesh> mesh;  // null: the base fusion's own part and pairs
  Loop loop;
};

struct SweepCurve {
  std::string name;
  FCF curve;
};

/// Settings of the adjustment, but for their falloff: that is of the list of falloffs, or the base fusion's.
struct SweepAdjustment {
  std::string name;
  AdjustmentSettings settings;
};

/// Which entry of each list a combination takes; 0 where the list is empty.
struct SweepChoice {
  std::size_t part = 0;
  std::size_t embedding = 0;
  std::size_t shift = 0;
  std::size_t adjustment = 0;
  std::size_t falloff = 0;
  std::size_t curve = 0;
  std::size_t monotone = 0;
};

/// A fusion and lists of values for some of its parameters: every combination of one value of each list is a
/// fusion. An empty list leaves its parameter as `base` has it. A value; meshes are shared.
///
/// Combinations are numbered from 0, parts slowest, then embeddings, shifts, adjustments, falloffs, curves,
/// and monotone fastest.
struct Sweep {
  FusionInputs base;
  std::vector<SweepPart> parts;
  std::vector<EmbeddingSettings::Method> embeddings;
  /// By how many CVs the correspondence is turned: the part's CV i becomes the partner of the base's CV
  /// i + shift (mod n).
  std::vector<int> shifts;
  std::vector<SweepAdjustment> adjustments;
  std::vector<double> falloffs;
  std::vector<SweepCurve> curves;
  std::vector<bool> monotone;  // applied to the curve of each combination

  /// More results than anybody looks at: a slip, refused by check().
  static constexpr std::size_t kMostCombinations = 100'000;

  /// The product of the lists' lengths; kMostCombinations + 1 stands for any greater number.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] SweepChoice choice(std::size_t combination) const;
  /// What to update() for a combination. Precondition for this and the next: combination < count().
  [[nodiscard]] FusionInputs inputs(std::size_t combination) const;
  /// The values of the lists in words, "paste_falloff-5_shift-1": made of letters, digits, points, hyphens
  /// and underscores (other letters than A to z stay), other for every combination also where case does not
  /// count; below 240 bytes, so that it can name a file. "base" where there is no list.
  [[nodiscard]] std::string name(std::size_t combination) const;
};

/// Whether a sweep can be run. Errors: SettingOutOfRange: more than kMostCombinations (says how the number
/// comes about); two entries of a list that are the same or have the same name once it is made a file's; a
/// falloff that is not greater than 0.
[[nodiscard]] Result<void> check(const Sweep& sweep);

/// One of the shares into which a sweep is divided, from 1 on.
struct SweepShare {
  std::size_t number = 1;
  std::size_t of = 1;
  static constexpr std::size_t kMost = 1'000'000;
  friend bool operator==(const SweepShare&, const SweepShare&) = default;
};

/// The combinations of a share in the order in which running them recomputes least: from one to the next a
/// single list's entry changes, mostly one of the last lists. With `count` combinations in that order, share
/// K of N holds those from ⌊(K − 1) count / N⌋ to before ⌊K count / N⌋; shares may be empty. Precondition: 1
/// ≤ number ≤ of ≤ kMost.
[[nodiscard]] std::vector<std::size_t> runOrder(const Sweep& sweep, const SweepShare& share = {});

}  // namespace graftsman
