#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "core/io/ply_header.h"
#include "core/io/text_scanner.h"

namespace graftsman {

/// A value that no integer property can have, for numbers that are none.
inline constexpr std::int64_t kNoInteger = std::numeric_limits<std::int64_t>::min();

[[nodiscard]] inline std::int64_t integerOf(double value) {
  const bool isInteger = value >= -9e15 && value <= 9e15 && std::floor(value) == value;
  return isInteger ? static_cast<std::int64_t>(value) : kNoInteger;
}

/// The values of an ASCII body, one after the other. number(), integer() and skip() return false where the
/// file does not have what is asked for, and leave `at` there.
struct AsciiValues {
  const char* at;
  const char* end;

  const char* start() {
    while (at != end && isSpace(*at)) {
      ++at;
    }
    return at;
  }
  // Reads a list of three vertices if the next one is that, plainly; else reads nothing.
  bool plainTriangle(const PlyProperty&, std::size_t vertexCount, Face& face) {
    const char* p = start();
    if (end - p < 2 || p[0] != '3' || !isSpace(p[1])) {
      return false;
    }
    ++p;
    for (Index& corner : face) {
      while (p != end && isSpace(*p)) {
        ++p;
      }
      std::uint64_t digits = 0;
      const char* const after = parseDigits(p, end, digits);
      if (after == p || after - p > kSurelyIndexDigits || digits >= vertexCount ||
          (after != end && !isSpace(*after))) {
        return false;
      }
      corner = static_cast<Index>(digits);
      p = after;
    }
    at = p;
    return true;
  }
  bool number(PlyType, double& value) {
    const char* const after = parseNumber(start(), end, value);
    if (after == nullptr || !(after == end || isSpace(*after))) {
      return false;
    }
    at = after;
    return true;
  }
  bool integer(PlyType type, std::int64_t& value) {
    const char* const after = parseInteger(start(), end, value);
    if (after != nullptr && (after == end || isSpace(*after))) {
      at = after;
      return true;
    }
    double real = 0;
    if (!number(type, real)) {
      return false;
    }
    value = integerOf(real);
    return true;
  }
  bool skip(PlyType, std::size_t count) {
    for (; count > 0; --count) {
      const std::string_view token = tokenAt(start(), end);
      if (token.empty()) {
        return false;
      }
      at += token.size();
    }
    return true;
  }
  [[nodiscard]] bool hasRoomFor(PlyType, std::size_t count) const {
    return count <= static_cast<std::size_t>(end - at);
  }
  tl::unexpected<Error> malformed(const ReadInput& input, const std::string& message) {
    return malformedLine(input, start(), message);
  }
  [[nodiscard]] std::string found() {
    const std::string_view token = tokenAt(start(), end);
    return token.empty() ? "the file ends there" : "found " + shown(token);
  }
};

/// The same of a binary body. Swap: its byte order is not this machine's.
template <bool Swap>
struct BinaryValues {
  const char* at;
  const char* end;

  template <class T>
  T load() {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), at, sizeof(T));
    if constexpr (Swap) {
      std::reverse(raw.begin(), raw.end());
    }
    at += sizeof(T);
    return std::bit_cast<T>(raw);
  }
  template <class Value, class Convert>
  bool read(PlyType type, Value& value, Convert convert) {
    if (!hasRoomFor(type, 1)) {
      return false;
    }
    switch (type) {
      case PlyType::Int8:
        value = load<std::int8_t>();
        break;
      case PlyType::UInt8:
        value = load<std::uint8_t>();
        break;
      case PlyType::Int16:
        value = load<std::int16_t>();
        break;
      case PlyType::UInt16:
        value = load<std::uint16_t>();
        break;
      case PlyType::Int32:
        value = load<std::int32_t>();
        break;
      case PlyType::UInt32:
        value = load<std::uint32_t>();
        break;
      case PlyType::Float32:
        value = convert(load<float>());
        break;
      case PlyType::Float64:
        value = convert(load<double>());
        break;
    }
    return true;
  }

  const char* start() { return at; }
  bool plainTriangle(const PlyProperty& list, std::size_t vertexCount, Face& face) {
    constexpr std::size_t kSize = 1 + 3 * sizeof(Index);
    if (list.countType != PlyType::UInt8 || sizeOf(list.type) != sizeof(Index) ||
        list.type == PlyType::Float32 || static_cast<std::size_t>(end - at) < kSize || *at != 3) {
      return false;
    }
    BinaryValues items{at + 1, end};
    for (Index& corner : face) {
      corner = items.template load<Index>();
    }
    const auto inRange = [vertexCount](Index v) { return static_cast<std::uint32_t>(v) < vertexCount; };
    if (!inRange(face[0]) || !inRange(face[1]) || !inRange(face[2])) {
      return false;
    }
    at = items.at;
    return true;
  }
  bool number(PlyType type, double& value) {
    return read(type, value, [](double v) { return v; });
  }
  bool integer(PlyType type, std::int64_t& value) { return read(type, value, integerOf); }
  bool skip(PlyType type, std::size_t count) {
    if (!hasRoomFor(type, count)) {
      return false;
    }
    at += count * sizeOf(type);
    return true;
  }
  [[nodiscard]] bool hasRoomFor(PlyType type, std::size_t count) const {
    return count <= static_cast<std::size_t>(end - at) / sizeOf(type);
  }
  tl::unexpected<Error> malformed(const ReadInput& input, const std::string& message) {
    return malformedByte(input, at, message);
  }
  [[nodiscard]] std::string found() { return "the file ends there"; }
};

}  // namespace graftsman
