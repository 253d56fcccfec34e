#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/fusion/measures.h"

namespace graftsman {

/// Another setting of a fusion, tried.
struct Suggestion {
  FusionInputs inputs;
  std::optional<FCF::Preset> preset;  // of which the curve is made; none: of the present curve
  double height = 1;                  // by which its values were multiplied
  int shift = 0;                      // the part's CV i is the partner that its CV i − shift (mod n) was
  int changes = 0;                    // how many of the settings are not the present ones
  Measures measures;
};

/// What was tried and fuses.
struct Suggestions {
  std::vector<Suggestion> candidates;  // C
  /// C×C, symmetric: how much two results differ, as the root mean square of the distances between places of
  /// the tile that lie on the same point of the base; 1: as much as the part and the base, or a tenth of the
  /// diameter of the base's loop, if that is more.
  Eigen::MatrixXd differences;
  std::size_t tried = 0;  // without the present settings
};

/// At most so many settings are tried, with so many placements of the part: cost is bounded.
inline constexpr std::size_t kMostPlacementsTried = 9;
inline constexpr std::size_t kMostSettingsTried = 108;

/// Two results that differ by less than this (see Suggestions::differences) look alike.
inline constexpr double kLookAlike = 0.06;

/// Tries other settings of a closed fusion: every combination of
/// - curves: that of `present` and the presets; each of them (but Half) at six tenths of its height, and the
///   version of each that is, or is not, monotone, where these are others by more than 0.05;
/// - adjustments: that of `present` with up to two other falloffs, from 2, 5 and 10; where a step is off,
///   every step on instead;
/// - shifts of the correspondence: none, and up to two others that carry the part's CVs about as near to the
///   base's by the adjustment's first two steps as the best shift does.
/// Leaves out what does not fuse, and what looks like the present result (kLookAlike).
///
/// `present`: results of the present settings, also unfinished ones, from which stages are taken over.
/// `base`: a tree over the base. Pure, and the same bits on any number of threads. Cost: at most
/// kMostPlacementsTried runs of the stages from the part's paths on, and kMostSettingsTried times the blend
/// and the measures. Errors: Cancelled; of the present settings where no other can mend it (the loop, the
/// tiles, the base's embedding), OutOfMemory. Precondition: both meshes are there, n ≥ 3.
[[nodiscard]] Result<Suggestions> suggest(const FusionResults& present, const NearestSurface& base,
                                          const Progress& progress);

/// What suggestions are chosen and sorted by.
enum class SuggestionOrder {
  MeanSeamAngle,      // the smoothest seam first
  GreatestSeamAngle,  // likewise, where it is worst
  LeastDistance,      // greatest distance to the base: the least change first
  GreatestDistance,   // the greatest change first
  Quality,            // of all but the worst twentieth of the triangles: the best first
};

/// The number that is sorted by, as Measures has it.
[[nodiscard]] double measureOf(const Measures& measures, SuggestionOrder order);

/// At most kMostSuggestions numbers of candidates that are good and look different, the best first. A
/// quarter, the worst by the order, is left out where enough remain. Of the others, from the best on, each is
/// taken that differs from all that are taken by at least d, where d is the greatest of a falling sequence
/// from 0.6 to kLookAlike at which kMostSuggestions are found. Of those that are equally good, within a
/// hundredth of the whole range, the one with fewer changes comes first. Where there are fewer than
/// kFewestSuggestions even at kLookAlike, the worst quarter is asked as well; fewer come back only where no
/// more look different. Deterministic. Cost: C² for each d.
[[nodiscard]] std::vector<std::size_t> choose(const Suggestions& suggestions, SuggestionOrder order);

inline constexpr std::size_t kFewestSuggestions = 6;
inline constexpr std::size_t kMostSuggestions = 9;

}  // namespace graftsman
