#include "core/sweep/sweep.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/io/scenario_keys.h"
#include "core/sweep/sweep_words.h"

namespace graftsman {
namespace {

constexpr std::size_t kLists = 7;

// Lengths of the lists, slowest first; of an empty one 1.
std::array<std::size_t, kLists> lengths(const Sweep& sweep) {
  std::array<std::size_t, kLists> result = {
      sweep.parts.size(),    sweep.embeddings.size(), sweep.shifts.size(),  sweep.adjustments.size(),
      sweep.falloffs.size(), sweep.curves.size(),     sweep.monotone.size()};
  for (std::size_t& length : result) {
    length = std::max<std::size_t>(length, 1);
  }
  return result;
}

// As SweepChoice, in the lists' order.
std::array<std::size_t, kLists> digits(const std::array<std::size_t, kLists>& lengths, std::size_t number) {
  std::array<std::size_t, kLists> result = {};
  for (std::size_t i = kLists; i-- > 0;) {
    result[i] = number % lengths[i];
    number /= lengths[i];
  }
  return result;
}

// The combination at a place of the running order: the lists are run through forwards and backwards in turn,
// so that nothing jumps (the reflected Gray code for lists of any length).
std::size_t combinationAt(const std::array<std::size_t, kLists>& lengths, std::size_t place) {
  const std::array<std::size_t, kLists> plain = digits(lengths, place);
  std::size_t before = 0;  // the number that the slower lists' places make
  std::size_t combination = 0;
  for (std::size_t i = 0; i < kLists; ++i) {
    const std::size_t digit = before % 2 == 0 ? plain[i] : lengths[i] - 1 - plain[i];
    combination = combination * lengths[i] + digit;
    before = before * lengths[i] + plain[i];
  }
  return combination;
}

Loop shifted(const Loop& loop, int shift) {
  Loop result = loop;
  const auto n = static_cast<std::ptrdiff_t>(loop.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t to = ((i + shift) % n + n) % n;
    result[static_cast<std::size_t>(to)].part = loop[static_cast<std::size_t>(i)].part;
  }
  return result;
}

}  // namespace

std::size_t Sweep::count() const {
  std::size_t product = 1;
  for (const std::size_t length : lengths(*this)) {
    product = length > kMostCombinations ? kMostCombinations + 1
                                         : std::min(product * length, kMostCombinations + 1);
  }
  return product;
}

SweepChoice Sweep::choice(std::size_t combination) const {
  const auto [part, embedding, shift, adjustment, falloff, curve, monotoneEntry] =
      digits(lengths(*this), combination);
  return {part, embedding, shift, adjustment, falloff, curve, monotoneEntry};
}

FusionInputs Sweep::inputs(std::size_t combination) const {
  assert(combination < count());
  const SweepChoice chosen = choice(combination);
  FusionInputs result = base;
  if (!parts.empty() && parts[chosen.part].mesh) {
    result.part = parts[chosen.part].mesh;
    result.loop = parts[chosen.part].loop;
  }
  if (!embeddings.empty()) {
    result.embedding.method = embeddings[chosen.embedding];
  }
  if (!shifts.empty()) {
    result.loop = shifted(result.loop, shifts[chosen.shift]);
  }
  if (!adjustments.empty()) {
    result.adjustment = adjustments[chosen.adjustment].settings;
  }
  result.adjustment.falloff = falloffs.empty() ? base.adjustment.falloff : falloffs[chosen.falloff];
  if (!curves.empty()) {
    result.fcf = curves[chosen.curve].curve;
  }
  if (!monotone.empty()) {
    result.fcf = FCF::through(result.fcf.points(), monotone[chosen.monotone]).value();
  }
  return result;
}

std::string Sweep::name(std::size_t combination) const {
  const SweepChoice chosen = choice(combination);
  std::string result;
  const auto add = [&](bool listed, const std::string& word) {
    if (listed) {
      result += (result.empty() ? "" : "_") + word;
    }
  };
  using namespace sweep_words;
  add(!parts.empty(), parts.empty() ? "" : fileWord(parts[chosen.part].name));
  add(!curves.empty(), curves.empty() ? "" : fileWord(curves[chosen.curve].name));
  add(!monotone.empty(), !monotone.empty() && monotone[chosen.monotone] ? "monotone" : "free");
  add(!falloffs.empty(), falloffs.empty() ? "" : "falloff-" + number(falloffs[chosen.falloff]));
  add(!adjustments.empty(), adjustments.empty() ? "" : fileWord(adjustments[chosen.adjustment].name));
  add(!embeddings.empty(), embeddings.empty() ? ""
                                              : scenario_keys::wordFor(scenario_keys::kEmbeddingMethods,
                                                                       embeddings[chosen.embedding]));
  add(!shifts.empty(), shifts.empty() ? "" : "shift-" + std::to_string(shifts[chosen.shift]));
  return result.empty() ? "base" : result;
}

std::vector<std::size_t> runOrder(const Sweep& sweep, const SweepShare& share) {
  assert(1 <= share.number && share.number <= share.of && share.of <= SweepShare::kMost);
  const std::size_t count = sweep.count();
  const auto boundary = [&](std::size_t k) { return k * count / share.of; };
  std::vector<std::size_t> order;
  const auto of = lengths(sweep);
  for (std::size_t place = boundary(share.number - 1); place < boundary(share.number); ++place) {
    order.push_back(combinationAt(of, place));
  }
  return order;
}

}  // namespace graftsman
