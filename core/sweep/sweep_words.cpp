#include "core/sweep/sweep_words.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace graftsman::sweep_words {

std::string fileWord(std::string_view name) {
  constexpr std::size_t kLongest = 40;
  std::string word;
  for (const char c : name.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool kept = byte >= 0x80 || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                      (c >= 'a' && c <= 'z') || c == '.' || c == '-';
    word += kept ? c : '-';
  }
  // Not in the middle of a character of many bytes.
  const auto continues = [&](std::size_t i) {
    return i < name.size() && (static_cast<unsigned char>(name[i]) & 0xC0U) == 0x80;
  };
  if (continues(word.size())) {
    while (!word.empty() && continues(word.size() - 1)) {
      word.pop_back();
    }
    if (!word.empty()) {
      word.pop_back();
    }
  }
  // A point at the start hides a file, and ".." is a folder.
  if (!word.empty() && word.front() == '.') {
    word.front() = '-';
  }
  return word.empty() ? "-" : word;
}

std::string number(double value) {
  std::array<char, 32> digits;
  const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {static_cast<const char*>(digits.data()), end};
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace graftsman::sweep_words
