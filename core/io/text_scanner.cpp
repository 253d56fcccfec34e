#include "core/io/text_scanner.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cstring>

namespace graftsman {
namespace {

constexpr std::size_t kQuotedLength = 40;  // characters of a file shown in a message
constexpr std::size_t kNumberLength = 20;  // digits shown

std::size_t lineNumber(std::span<const char> bytes, const char* at) {
  std::size_t line = 1;
  for (const char* p = bytes.data(); p != at; ++p) {
    const bool partOfPair = *p == '\r' && p + 1 != bytes.data() + bytes.size() && p[1] == '\n';
    line += isLineEnd(*p) && !partOfPair ? 1 : 0;
  }
  return line;
}

}  // namespace

const char* skipSpaceAndComments(const char* at, const char* end) {
  while (at != end) {
    if (*at == '#') {
      at = lineEnd(at, end);
    } else if (isSpace(*at)) {
      ++at;
    } else {
      break;
    }
  }
  return at;
}

std::string_view tokenAt(const char* at, const char* end) {
  const char* last = at;
  while (last != end && !isSpace(*last)) {
    ++last;
  }
  return {at, static_cast<std::size_t>(last - at)};
}

const char* parseNumberSlowly(const char* at, const char* end, double& value) {
  if (end - at > 1 && *at == '+' && at[1] != '-') {
    ++at;
  }
  const auto [after, problem] = fast_float::from_chars(at, end, value);
  // Newer versions call a number too large or too small for a double an error, and round it all the same.
  return problem == std::errc() || problem == std::errc::result_out_of_range ? after : nullptr;
}

std::string shown(std::string_view text) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string result = "'";
  for (const char c : text.substr(0, kQuotedLength)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte > 0x7e) {
      result += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    } else {
      result += c;
    }
  }
  return result + (text.size() > kQuotedLength ? "...'" : "'");
}

std::string numberShown(const char* first, const char* last) {
  const std::string digits(first, last);
  return digits.size() <= kNumberLength ? digits : digits.substr(0, kNumberLength) + "...";
}

tl::unexpected<Error> malformedLine(const ReadInput& input, const char* at, const std::string& message) {
  return fail(ErrorCode::FileMalformed,
              input.name + ":" + std::to_string(lineNumber(input.bytes, at)) + ": " + message);
}

tl::unexpected<Error> malformedByte(const ReadInput& input, const char* at, const std::string& message) {
  return fail(ErrorCode::FileMalformed,
              input.name + ": byte " + std::to_string(at - input.bytes.data()) + ": " + message);
}

tl::unexpected<Error> malformedCoordinate(const ReadInput& input, const char* at, int axis,
                                          std::size_t vertex) {
  const char* const end = input.bytes.data() + input.bytes.size();
  const std::string which =
      std::string("the ") + "xyz"[axis] + " coordinate of vertex " + std::to_string(vertex);
  const std::string_view token = tokenAt(at, end);
  double value = 0;
  const char* const after = parseNumber(at, end, value);
  if (after != nullptr && endsToken(after, end) && !std::isfinite(value)) {
    return malformedLine(input, at, which + " is " + shown(token) + ", which is not a finite number");
  }
  const std::string found = !token.empty() ? shown(token)
                            : at == end    ? "the end of the file"
                                           : "the end of the line";
  return malformedLine(input, at, "expected " + which + ", found " + found);
}

tl::unexpected<Error> readingCancelled() {
  return fail(ErrorCode::Cancelled, "Reading was cancelled.");
}

}  // namespace graftsman
