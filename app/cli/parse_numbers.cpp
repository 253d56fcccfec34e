#include <charconv>
#include <string_view>

#include "app/cli/commands.h"
#include "core/picture/picture.h"
#include "core/sweep/sweep.h"

namespace {

// Two whole numbers with a character between them, both at least 1.
template <class Number>
bool parsePair(std::string_view text, char between, Number& first, Number& second) {
  const std::size_t middle = text.find(between);
  if (middle == std::string_view::npos) {
    return false;
  }
  const auto read = [](std::string_view digits, Number& number) {
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return failure == std::errc() && end == digits.data() + digits.size() && number >= 1;
  };
  return read(text.substr(0, middle), first) && read(text.substr(middle + 1), second);
}

}  // namespace

std::optional<ShareNumbers> parseShare(const std::string& text) {
  ShareNumbers share;
  const bool valid = parsePair(text, '/', share.number, share.of) && share.number <= share.of &&
                     share.of <= graftsman::SweepShare::kMost;
  return valid ? std::optional(share) : std::nullopt;
}

std::optional<SizeNumbers> parseSize(const std::string& text) {
  SizeNumbers size;
  const bool valid = parsePair(text, 'x', size.width, size.height) &&
                     size.width <= graftsman::kGreatestPictureSide &&
                     size.height <= graftsman::kGreatestPictureSide;
  return valid ? std::optional(size) : std::nullopt;
}
