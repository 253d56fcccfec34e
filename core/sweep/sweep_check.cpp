#include <algorithm>
#include <cmath>
#include <map>

#include "core/io/printable.h"
#include "core/io/scenario_keys.h"
#include "core/sweep/sweep.h"
#include "core/sweep/sweep_words.h"

namespace graftsman {
namespace {

// "2 parts × 4 curves"
std::string product(const Sweep& sweep) {
  std::string text;
  const auto add = [&](std::size_t length, const char* what) {
    if (length > 0) {
      text += (text.empty() ? "" : " × ") + std::to_string(length) + " " + what;
    }
  };
  add(sweep.parts.size(), "parts");
  add(sweep.embeddings.size(), "embeddings");
  add(sweep.shifts.size(), "shifts");
  add(sweep.adjustments.size(), "adjustments");
  add(sweep.falloffs.size(), "falloffs");
  add(sweep.curves.size(), "curves");
  add(sweep.monotone.size(), "values of monotone");
  return text;
}

// An error if two words of a list are alike, apart from capitals.
Result<void> checkDifferent(const char* list, const std::vector<std::string>& words) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto [first, isNew] = seen.try_emplace(sweep_words::lowered(words[i]), i);
    if (!isNew) {
      return fail(ErrorCode::SettingOutOfRange,
                  std::string("\"") + list + "\" has \"" + printable(words[i]) + "\" twice, as entries " +
                      std::to_string(first->second) + " and " + std::to_string(i) +
                      " counted from 0; results are named by them, so give each a name of its own.");
    }
  }
  return {};
}

template <class List, class Word>
std::vector<std::string> words(const List& list, Word word) {
  std::vector<std::string> result;
  result.reserve(list.size());
  for (const auto& entry : list) {
    result.push_back(word(entry));
  }
  return result;
}

}  // namespace

Result<void> check(const Sweep& sweep) {
  if (sweep.count() > Sweep::kMostCombinations) {
    return fail(ErrorCode::SettingOutOfRange,
                "The sweep has more than " + std::to_string(Sweep::kMostCombinations) + " combinations (" +
                    product(sweep) + "). Shorten a list, or divide it into several sweeps.");
  }
  for (const double falloff : sweep.falloffs) {
    if (!(falloff > 0) || !std::isfinite(falloff)) {
      return fail(ErrorCode::SettingOutOfRange, "\"deform_exponent\" has " + sweep_words::number(falloff) +
                                                    "; give a number greater than 0.");
    }
  }
  const auto named = [](const auto& entry) { return sweep_words::fileWord(entry.name); };
  const auto embeddingWord = [](EmbeddingSettings::Method method) {
    return scenario_keys::wordFor(scenario_keys::kEmbeddingMethods, method);
  };
  for (const auto& [list, entries] : {
           std::pair("parts", words(sweep.parts, named)),
           std::pair("embedding", words(sweep.embeddings, embeddingWord)),
           std::pair("shift", words(sweep.shifts, [](int shift) { return std::to_string(shift); })),
           std::pair("adjustment", words(sweep.adjustments, named)),
           std::pair("deform_exponent", words(sweep.falloffs, sweep_words::number)),
           std::pair("fcf", words(sweep.curves, named)),
           std::pair("monotone",
                     words(sweep.monotone, [](bool on) { return std::string(on ? "true" : "false"); })),
       }) {
    if (Result<void> different = checkDifferent(list, entries); !different) {
      return different;
    }
  }
  return {};
}

}  // namespace graftsman
