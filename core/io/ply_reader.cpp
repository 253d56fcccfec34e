#include "core/io/ply_reader.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "core/io/ply_header.h"
#include "core/io/text_scanner.h"

namespace graftsman {
namespace {

constexpr std::size_t kRowsPerLook = 4096;  // at the progress

// A value that no integer property can have, for numbers that are none.
constexpr std::int64_t kNoInteger = std::numeric_limits<std::int64_t>::min();

std::int64_t integerOf(double value) {
  const bool isInteger = value >= -9e15 && value <= 9e15 && std::floor(value) == value;
  return isInteger ? static_cast<std::int64_t>(value) : kNoInteger;
}

// The values of an ASCII body, one after the other. All functions return false where the file does not have
// what is asked for, and leave `at` there.
struct AsciiValues {
  const char* at;
  const char* end;

  const char* start() {
    while (at != end && isSpace(*at)) {
      ++at;
    }
    return at;
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
  tl::unexpected<Error> malformed(const ReadInput& input, const char* where, const std::string& message) {
    return malformedLine(input, where, message);
  }
  [[nodiscard]] std::string found() {
    const std::string_view token = tokenAt(start(), end);
    return token.empty() ? "the file ends there" : "found " + shown(token);
  }
};

// The same of a binary body. Swap: its byte order is not this machine's.
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
  tl::unexpected<Error> malformed(const ReadInput& input, const char* where, const std::string& message) {
    return malformedByte(input, where, message);
  }
  [[nodiscard]] std::string found() { return "the file ends there"; }
};

template <class Values>
class BodyParser {
 public:
  BodyParser(const ReadInput& input, const PlyHeader& header)
      : input_(input), header_(header), values_{header.body, input.bytes.data() + input.bytes.size()} {}

  Result<RawMesh> parse(std::size_t vertexCount) {
    vertexCount_ = vertexCount;
    for (const PlyElement& element : header_.elements) {
      Result<void> parsed = parseElement(element);
      if (!parsed) {
        return tl::unexpected<Error>(std::move(parsed.error()));
      }
    }
    return std::move(mesh_);
  }

 private:
  Result<void> parseElement(const PlyElement& element) {
    if (element.properties.empty()) {
      return {};
    }
    const bool isVertex = element.name == "vertex";
    const bool isFace = element.name == "face";
    if (isVertex) {
      mesh_.points.reserve(element.count);
    } else if (isFace) {
      mesh_.triangles.reserve(element.count);
    }
    for (std::size_t row = 0; row < element.count; ++row) {
      if (row % kRowsPerLook == 0 && !keepGoing()) {
        return readingCancelled();
      }
      Result<void> parsed = isVertex ? parseVertex(element, row) : parseOther(element, row, isFace);
      if (!parsed) {
        return parsed;
      }
    }
    return {};
  }

  Result<void> parseVertex(const PlyElement& element, std::size_t row) {
    Point point;
    for (const PlyProperty& property : element.properties) {
      const int axis = axisOf(property);
      if (axis < 0) {
        Result<void> skipped = skipProperty(element, property, row);
        if (!skipped) {
          return skipped;
        }
        continue;
      }
      const char* const where = values_.start();
      if (!values_.number(property.type, point[axis])) {
        return missing(element, property, row);
      }
      if (!std::isfinite(point[axis])) {
        return values_.malformed(input_, where,
                                 "the coordinate " + property.name + " of vertex " + std::to_string(row) +
                                     " is not a finite number");
      }
    }
    mesh_.points.push_back(point);
    return {};
  }

  Result<void> parseOther(const PlyElement& element, std::size_t row, bool isFace) {
    for (const PlyProperty& property : element.properties) {
      Result<void> parsed = isFace && isCornerList(property) ? parseCorners(element, property, row)
                                                             : skipProperty(element, property, row);
      if (!parsed) {
        return parsed;
      }
    }
    return {};
  }

  Result<void> parseCorners(const PlyElement& element, const PlyProperty& property, std::size_t row) {
    std::size_t count = 0;
    Result<void> counted = parseCount(element, property, row, count);
    if (!counted) {
      return counted;
    }
    Face face;
    if (count != 3) {
      if (mesh_.polygonCorners.size() + count > kGreatestCount) {
        return values_.malformed(input_, values_.at, "the polygons have too many corners");
      }
      mesh_.beginPolygon();
    }
    for (std::size_t k = 0; k < count; ++k) {
      const char* const where = values_.start();
      std::int64_t vertex = 0;
      if (!values_.integer(property.type, vertex)) {
        return missing(element, property, row);
      }
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertexCount_)) {
        return values_.malformed(
            input_, where,
            "face " + std::to_string(row) + " refers to vertex " +
                (vertex == kNoInteger ? "number that is no integer" : std::to_string(vertex)) +
                ", but the file has vertices 0 to " +
                std::to_string(static_cast<std::int64_t>(vertexCount_) - 1));
      }
      if (count == 3) {
        face[k] = static_cast<Index>(vertex);
      } else {
        mesh_.polygonCorners.push_back(static_cast<Index>(vertex));
      }
    }
    if (count == 3) {
      mesh_.triangles.push_back(face);
    }
    return {};
  }

  Result<void> skipProperty(const PlyElement& element, const PlyProperty& property, std::size_t row) {
    std::size_t count = 1;
    if (property.isList) {
      Result<void> counted = parseCount(element, property, row, count);
      if (!counted) {
        return counted;
      }
    }
    return values_.skip(property.type, count) ? Result<void>() : missing(element, property, row);
  }

  // The length of a list, which the rest of the file has room for.
  Result<void> parseCount(const PlyElement& element, const PlyProperty& property, std::size_t row,
                          std::size_t& count) {
    const char* const where = values_.start();
    std::int64_t value = 0;
    if (!values_.integer(property.countType, value)) {
      return missing(element, property, row);
    }
    if (value < 0 || !values_.hasRoomFor(property.type, static_cast<std::size_t>(value))) {
      return values_.malformed(input_, where,
                               nameOf(element, property, row) + " declares " +
                                   (value == kNoInteger ? "no integer" : std::to_string(value)) +
                                   " items, which the rest of the file has no room for");
    }
    count = static_cast<std::size_t>(value);
    return {};
  }

  Result<void> missing(const PlyElement& element, const PlyProperty& property, std::size_t row) {
    const char* const where = values_.start();
    return values_.malformed(
        input_, where, "expected a value of " + nameOf(element, property, row) + ", " + values_.found());
  }

  static std::string nameOf(const PlyElement& element, const PlyProperty& property, std::size_t row) {
    return shown(property.name) + " of " + shown(element.name) + " " + std::to_string(row);
  }

  static int axisOf(const PlyProperty& property) {
    const bool isAxis = !property.isList && property.name.size() == 1;
    return isAxis && property.name[0] >= 'x' && property.name[0] <= 'z' ? property.name[0] - 'x' : -1;
  }

  static bool isCornerList(const PlyProperty& property) {
    return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  bool keepGoing() const {
    return input_.progress.keepGoing(static_cast<double>(values_.at - input_.bytes.data()) /
                                     static_cast<double>(input_.bytes.size()));
  }

  const ReadInput& input_;
  const PlyHeader& header_;
  Values values_;
  std::size_t vertexCount_ = 0;
  RawMesh mesh_;
};

// The number of declared vertices, if the header declares all that a mesh needs.
Result<std::size_t> checkElements(const ReadInput& input, const PlyHeader& header) {
  const PlyElement* vertex = nullptr;
  bool hasStrips = false;
  int cornerLists = 0;
  for (const PlyElement& element : header.elements) {
    vertex = element.name == "vertex" ? &element : vertex;
    hasStrips = hasStrips || element.name == "tristrips";
    for (const PlyProperty& p : element.properties) {
      const bool corners = p.isList && (p.name == "vertex_indices" || p.name == "vertex_index");
      cornerLists += element.name == "face" && corners ? 1 : 0;
    }
  }
  for (const char* const axis : {"x", "y", "z"}) {
    int found = 0;
    for (const PlyProperty& p : vertex != nullptr ? vertex->properties : std::vector<PlyProperty>()) {
      found += p.name == axis && !p.isList ? 1 : 0;
    }
    if (found != 1) {
      return malformedLine(input, header.body,
                           vertex == nullptr ? std::string("the header declares no element 'vertex'")
                                             : std::string("the element 'vertex' must have one property '") +
                                                   axis + "', it has " + std::to_string(found));
    }
  }
  if (cornerLists == 0 && hasStrips) {
    return malformedLine(input, header.body,
                         "the file holds triangle strips, which are not read; save it with faces");
  }
  if (cornerLists > 1) {
    return malformedLine(input, header.body, "the element 'face' has two lists of vertices");
  }
  return vertex->count;
}

}  // namespace

Result<RawMesh> readPly(const ReadInput& input) {
  const Result<PlyHeader> header = parsePlyHeader(input);
  if (!header) {
    return tl::unexpected<Error>(header.error());
  }
  const Result<std::size_t> vertexCount = checkElements(input, *header);
  if (!vertexCount) {
    return tl::unexpected<Error>(vertexCount.error());
  }
  constexpr bool kLittleMachine = std::endian::native == std::endian::little;
  Result<RawMesh> mesh;
  switch (header->encoding) {
    case PlyEncoding::Ascii:
      mesh = BodyParser<AsciiValues>(input, *header).parse(*vertexCount);
      break;
    case PlyEncoding::BinaryLittleEndian:
      mesh = BodyParser<BinaryValues<!kLittleMachine>>(input, *header).parse(*vertexCount);
      break;
    case PlyEncoding::BinaryBigEndian:
      mesh = BodyParser<BinaryValues<kLittleMachine>>(input, *header).parse(*vertexCount);
      break;
  }
  if (mesh) {
    mesh->binary = header->encoding != PlyEncoding::Ascii;
  }
  return mesh;
}

}  // namespace graftsman
