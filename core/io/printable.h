#pragma once

#include <string>
#include <string_view>

namespace graftsman {

/// Bytes of a path in a message.
inline constexpr std::size_t kLongestPathShown = 400;

/// `text` as it may stand in a message: control characters and bytes that are not UTF-8 written as \xNN, cut
/// after `limit` bytes with "…".
[[nodiscard]] std::string printable(std::string_view text, std::size_t limit = 80);

}  // namespace graftsman
