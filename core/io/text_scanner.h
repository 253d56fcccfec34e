#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/raw_mesh.h"

namespace graftsman {

// The pieces that the readers of text formats are made of. A position is a pointer into the file's bytes; no
// function reads at or beyond `end`. Lines are not counted on the way: the number of a line is found from its
// position when an error needs it.

[[nodiscard]] inline bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
[[nodiscard]] inline bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}
[[nodiscard]] inline bool isSpace(char c) {
  return isBlank(c) || isLineEnd(c);
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
[[nodiscard]] const char* lineEnd(const char* at, const char* end);

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
}

/// The same, faster for the numbers that files are full of: up to 19 digits and no exponent. If the digits
/// make an integer below 2^53, it and the power of ten are exact doubles, so one division rounds correctly
/// (Clinger 1990).
[[nodiscard]] inline const char* parseNumber(const char* at, const char* end, double& value) {
  const char* p = at;
  const bool negative = p != end && *p == '-';
  p += negative ? 1 : 0;
  std::uint64_t digits = 0;
  const char* const first = p;
  for (; p != end && digitOf(*p) < 10; ++p) {
    digits = 10 * digits + digitOf(*p);
  }
  auto count = p - first;
  std::ptrdiff_t decimals = 0;
  if (p != end && *p == '.') {
    const char* const point = ++p;
    for (; p != end && digitOf(*p) < 10; ++p) {
      digits = 10 * digits + digitOf(*p);
    }
    decimals = p - point;
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
  const char* p = at;
  const bool negative = p != end && *p == '-';
  p += p != end && (*p == '-' || *p == '+') ? 1 : 0;
  constexpr std::int64_t kLimit = std::int64_t{1} << 62;
  std::int64_t magnitude = 0;
  const char* const first = p;
  for (; p != end && digitOf(*p) < 10; ++p) {
    magnitude = magnitude < kLimit / 10 ? 10 * magnitude + digitOf(*p) : kLimit;
  }
  value = negative ? -magnitude : magnitude;
  return p == first ? nullptr : p;
}

/// A piece of a file for a message: in quotes, cut off if long, with every unprintable byte escaped.
[[nodiscard]] std::string shown(std::string_view text);

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
