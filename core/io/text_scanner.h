#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/raw_mesh.h"

namespace graftsman {

// The pieces that the readers of text formats are made of. A position is a pointer into the file's bytes; no
// function reads at or beyond `end`. Lines are not counted on the way: the number of a line is found from its
// position when an error needs it.

[[nodiscard]] inline bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}
[[nodiscard]] inline bool isSpace(char c) {
  return c <= ' ' && (c == ' ' || (c >= '\t' && c <= '\r'));
}
[[nodiscard]] inline bool isBlank(char c) {
  return isSpace(c) && !isLineEnd(c);
}
[[nodiscard]] inline unsigned digitOf(char c) {
  return static_cast<unsigned>(static_cast<unsigned char>(c)) - '0';
}

[[nodiscard]] inline const char* skipBlanks(const char* at, const char* end) {
  while (at != end && isBlank(*at)) {
    ++at;
  }
  return at;
}

/// The end of the line that `at` is in: its '\n' or '\r', or `end`.
[[nodiscard]] inline const char* lineEnd(const char* at, const char* end) {
  if (at == end || isLineEnd(*at)) {
    return at;
  }
  const auto find = [at](char c, const char* before) {
    const void* const found = std::memchr(at, c, static_cast<std::size_t>(before - at));
    return found != nullptr ? static_cast<const char*>(found) : before;
  };
  return find('\r', find('\n', end));
}

/// Skips white space, line ends, and comments from '#' to the end of their line.
[[nodiscard]] const char* skipSpaceAndComments(const char* at, const char* end);

/// The run of characters from `at` on that are no white space.
[[nodiscard]] std::string_view tokenAt(const char* at, const char* end);

/// The number at `at` as fast_float reads it, with '+' allowed: the position after it, or null if none is
/// there. A number too large for a double comes back as infinity.
[[nodiscard]] const char* parseNumberSlowly(const char* at, const char* end, double& value);

namespace detail {
inline constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                        1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                        1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
inline constexpr std::array<std::uint64_t, 9> kIntegerPowersOfTen = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

/// The number that the digits at the beginning of eight characters make; how many digits these are. All at
/// once in the bytes of one word (Lemire 2018, with a mask for fewer than eight).
[[nodiscard]] inline int leadingDigits(const char* eight, std::uint64_t& value) {
  std::uint64_t word = 0;
  std::memcpy(&word, eight, sizeof(word));
  word ^= 0x3030303030303030U;  // digits become 0 to 9
  // The highest bit of each byte up to the first that is no digit: clear for digits.
  const std::uint64_t others = ((word + 0x7676767676767676U) | word) & 0x8080808080808080U;
  const int count = std::countr_zero(others) / 8;
  if (count == 0) {
    return 0;
  }
  word <<= 64 - 8 * count;
  word = word * 10 + (word >> 8);
  word = ((word & 0x000000FF000000FFU) * 0x000F424000000064U +
          ((word >> 16) & 0x000000FF000000FFU) * 0x0000271000000001U) >>
         32;
  value = word;
  return count;
}
}  // namespace detail

/// Digits of a number that surely fits an Index.
inline constexpr int kSurelyIndexDigits = 9;

/// Appends the decimal digits from `at` on to `value`, which wraps round if there are too many: the position
/// after them.
[[nodiscard]] inline const char* parseDigits(const char* at, const char* end, std::uint64_t& value) {
  if constexpr (std::endian::native == std::endian::little) {
    while (end - at >= 8) {
      std::uint64_t part = 0;
      const int count = detail::leadingDigits(at, part);
      value = value * detail::kIntegerPowersOfTen[static_cast<std::size_t>(count)] + part;
      at += count;
      if (count < 8) {
        return at;
      }
    }
  }
  for (; at != end && digitOf(*at) < 10; ++at) {
    value = 10 * value + digitOf(*at);
  }
  return at;
}

/// The same as parseNumberSlowly(), faster for the numbers that files are full of: up to 19 digits and no
/// exponent. If the digits make an integer of at most 2^53, it and the power of ten are exact doubles, so one
/// division rounds correctly (Clinger 1990).
[[nodiscard]] inline const char* parseNumber(const char* at, const char* end, double& value) {
  const bool negative = at != end && *at == '-';
  const char* const first = at + (negative ? 1 : 0);
  std::uint64_t digits = 0;
  const char* p = parseDigits(first, end, digits);
  auto count = p - first;
  std::ptrdiff_t decimals = 0;
  if (p != end && *p == '.') {
    const char* const afterPoint = p + 1;
    p = parseDigits(afterPoint, end, digits);
    decimals = p - afterPoint;
    count += decimals;
  }
  constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;
  if (count == 0 || count > 19 || digits > kExactIntegers || (p != end && (*p | 0x20) == 'e')) {
    return parseNumberSlowly(at, end, value);
  }
  const double magnitude =
      static_cast<double>(digits) / detail::kPowersOfTen[static_cast<std::size_t>(decimals)];
  value = negative ? -magnitude : magnitude;
  return p;
}

/// The integer at `at`, limited to ±2^62 if it is larger: the position after it, or null if none is there.
[[nodiscard]] inline const char* parseInteger(const char* at, const char* end, std::int64_t& value) {
  constexpr std::int64_t kLimit = std::int64_t{1} << 62;
  const bool negative = at != end && *at == '-';
  const char* const first = at + (at != end && (*at == '-' || *at == '+') ? 1 : 0);
  std::uint64_t digits = 0;
  const char* const after = parseDigits(first, end, digits);
  if (after == first) {
    return nullptr;
  }
  const bool isLarge =
      after - first > 18 && (after - first > 19 || digits > static_cast<std::uint64_t>(kLimit));
  const std::int64_t magnitude = isLarge ? kLimit : static_cast<std::int64_t>(digits);
  value = negative ? -magnitude : magnitude;
  return after;
}

/// A piece of a file for a message: in quotes, cut off if long, with every unprintable byte escaped.
[[nodiscard]] std::string shown(std::string_view text);

/// The digits of a number of a file for a message, which may be more than any integer holds: cut off if many.
[[nodiscard]] std::string numberShown(const char* first, const char* last);

/// The error "name:line: message", for the line that `at` is in.
[[nodiscard]] tl::unexpected<Error> malformedLine(const ReadInput& input, const char* at,
                                                  const std::string& message);

/// The error "name: byte N: message", for a binary file.
[[nodiscard]] tl::unexpected<Error> malformedByte(const ReadInput& input, const char* at,
                                                  const std::string& message);

/// The error for the coordinate at `at` that is none: "expected the y coordinate of vertex 12, found …".
[[nodiscard]] tl::unexpected<Error> malformedCoordinate(const ReadInput& input, const char* at, int axis,
                                                        std::size_t vertex);

/// True if a number may end at `at`.
[[nodiscard]] inline bool endsToken(const char* at, const char* end) {
  return at == end || isSpace(*at) || *at == '#' || *at == '\\';
}

/// Reads three finite coordinates, `skip` leading over what may stand before each: the position after them,
/// or null if they are not there.
template <class Skip>
[[nodiscard]] inline const char* parsePoint(const char* at, const char* end, Skip skip, Point& point) {
  for (int axis = 0; axis < 3; ++axis) {
    at = parseNumber(skip(at, end), end, point[axis]);
    if (at == nullptr || !std::isfinite(point[axis]) || !endsToken(at, end)) {
      return nullptr;
    }
  }
  return at;
}

/// Why parsePoint() returned null: "expected the y coordinate of vertex 12, found …".
template <class Skip>
[[nodiscard]] tl::unexpected<Error> malformedPoint(const ReadInput& input, const char* at, const char* end,
                                                   Skip skip, std::size_t vertex) {
  double value = 0;
  for (int axis = 0; axis < 3; ++axis) {
    at = skip(at, end);
    const char* const after = parseNumber(at, end, value);
    if (after == nullptr || !std::isfinite(value) || !endsToken(after, end)) {
      return malformedCoordinate(input, at, axis, vertex);
    }
    at = after;
  }
  return malformedCoordinate(input, at, 2, vertex);
}

/// The error Cancelled.
[[nodiscard]] tl::unexpected<Error> readingCancelled();

}  // namespace graftsman
