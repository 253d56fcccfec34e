#include "core/io/printable.h"

#include <algorithm>
#include <cstdint>

namespace graftsman {
namespace {

// The length of the UTF-8 character at the start of `text`, or 0 if there is none (RFC 3629: no overlong
// forms, no surrogates).
std::size_t characterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) {
    return 1;
  }
  const std::size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                             : lead >= 0xE0 && lead <= 0xEF ? 3
                             : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                            : 0;
  if (length == 0 || text.size() < length) {
    return 0;
  }
  const std::uint8_t least = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const std::uint8_t greatest = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < least || byte(1) > greatest) {
    return 0;
  }
  const bool valid = std::all_of(text.begin() + 2, text.begin() + static_cast<std::ptrdiff_t>(length),
                                 [](char c) { return (static_cast<std::uint8_t>(c) & 0xC0) == 0x80; });
  return valid ? length : 0;
}

}  // namespace

std::string printable(std::string_view text, std::size_t limit) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string result;
  while (!text.empty()) {
    if (result.size() >= limit) {
      return result + "…";
    }
    const auto lead = static_cast<std::uint8_t>(text[0]);
    // U+0080 to U+009F are control characters, too: a terminal may obey them.
    const bool control = lead < 0x20 || lead == 0x7F ||
                         (lead == 0xC2 && text.size() > 1 && static_cast<std::uint8_t>(text[1]) < 0xA0);
    const std::size_t length = control ? 0 : characterLength(text);
    if (length == 0) {
      result += {'\\', 'x', kHex[lead >> 4], kHex[lead & 15]};
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace graftsman
