#pragma once

#include <QStringList>

#include "core/sweep/suggest.h"

/// What the strip of suggestions says.
namespace graftsman {

/// What a suggestion changes of a fusion: "Half, falloff 2, shifted by 1".
[[nodiscard]] QString differenceText(const FusionInputs& before, const Suggestion& suggestion);

/// "seam 12.3°": the measure that is sorted by.
[[nodiscard]] QString measureText(const Measures& measures, SuggestionOrder order);

/// "Mean seam angle", … in the order of SuggestionOrder.
[[nodiscard]] QStringList orderNames();

/// What comes first.
[[nodiscard]] QString orderSentence(SuggestionOrder order);

}  // namespace graftsman
