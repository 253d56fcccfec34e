#include "core/io/ply_reader.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "core/io/ply_header.h"
#include "core/io/text_scanner.h"

namespace graftsman {
namespace {

constexpr std::size_t kRowsPerLook = 4096;  // at the progress
constexpr int kPlainDigits = 9;             // of a vertex number that surely fits an Index

// A value that no integer property can have, for numbers that are none.
constexpr std::int64_t kNoInteger = std::numeric_limits<std::int64_t>::min();

std::int64_t integerOf(double value) {
  const bool isInteger = value >= -9e15 && value <= 9e15 && std::floor(value) == value;
  return isInteger ? static_cast<std::int64_t>(value) : kNoInteger;
}

// The values of an ASCII body, one after the other. number(), integer() and skip() return false where the
// file does not have what is asked for, and leave `at` there.
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
      if (after == p || after - p > kPlainDigits || digits >= vertexCount ||
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

bool isCornerList(const PlyProperty& property) {
  return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// 0, 1, 2 for x, y, z; −1 for any other property.
int axisOf(const PlyProperty& property) {
  const bool isAxis = !property.isList && property.name.size() == 1;
  return isAxis && property.name[0] >= 'x' && property.name[0] <= 'z' ? property.name[0] - 'x' : -1;
}

template <class Values>
class BodyParser {
 public:
  BodyParser(const ReadInput& input, const PlyHeader& header)
      : input_(input), header_(header), values_{header.body, input.bytes.data() + input.bytes.size()} {}

  Result<RawMesh> parse(std::size_t vertexCount) {
    vertexCount_ = vertexCount;
    for (const PlyElement& element : header_.elements) {
      if (!parseElement(element)) {
        return fail(std::move(*error_));
      }
    }
    return std::move(mesh_);
  }

 private:
  // All functions below return false where error_ says why.
  bool parseElement(const PlyElement& element) {
    element_ = &element;
    const bool isVertex = element.name == "vertex";
    const bool isFace = element.name == "face";
    axes_.clear();
    cornerList_ = nullptr;
    for (const PlyProperty& property : element.properties) {
      axes_.push_back(isVertex ? axisOf(property) : -1);
      cornerList_ = isFace && isCornerList(property) ? &property : cornerList_;
    }
    if (isVertex) {
      mesh_.points.reserve(element.count);
    } else if (isFace) {
      mesh_.triangles.reserve(element.count);
    }
    // An element without properties takes no bytes, whatever its count.
    const std::size_t rows = element.properties.empty() ? 0 : element.count;
    for (std::size_t row = 0; row < rows; ++row) {
      if (row % kRowsPerLook == 0 && !keepGoing()) {
        return failWith(readingCancelled());
      }
      row_ = row;
      if (!(isVertex ? parseVertex() : parseFace())) {
        return false;
      }
    }
    return true;
  }

  bool parseVertex() {
    Point point;
    const std::vector<PlyProperty>& properties = element_->properties;
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (axes_[i] < 0) {
        if (!skip(properties[i])) {
          return false;
        }
        continue;
      }
      const char* const where = values_.start();
      double& coordinate = point[axes_[i]];
      if (!values_.number(properties[i].type, coordinate)) {
        return missing(properties[i]);
      }
      if (!std::isfinite(coordinate)) {
        values_.at = where;
        return failAt("the coordinate " + properties[i].name + " of vertex " + std::to_string(row_) +
                      " is not a finite number");
      }
    }
    mesh_.points.push_back(point);
    return true;
  }

  // Or any element but the vertices: without a list of corners there is nothing to keep.
  bool parseFace() {
    for (const PlyProperty& property : element_->properties) {
      if (!(&property == cornerList_ ? parseCorners(property) : skip(property))) {
        return false;
      }
    }
    return true;
  }

  bool parseCorners(const PlyProperty& property) {
    Face face = {};
    if (values_.plainTriangle(property, vertexCount_, face)) {
      mesh_.triangles.push_back(face);
      return true;
    }
    std::size_t count = 0;
    if (!parseCount(property, count)) {
      return false;
    }
    if (count != 3) {
      if (mesh_.polygonCorners.size() + count > kGreatestCount) {
        return failAt("the polygons have too many corners");
      }
      mesh_.beginPolygon();
    }
    for (std::size_t k = 0; k < count; ++k) {
      const char* const where = values_.start();
      std::int64_t vertex = 0;
      if (!values_.integer(property.type, vertex)) {
        return missing(property);
      }
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertexCount_)) {
        values_.at = where;
        return failAt("face " + std::to_string(row_) + " refers to " +
                      (vertex == kNoInteger ? "a vertex number that is no integer"
                                            : "vertex " + std::to_string(vertex)) +
                      ", but the file has " + std::to_string(vertexCount_) + " vertices, counted from 0");
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
    return true;
  }

  bool skip(const PlyProperty& property) {
    std::size_t count = 1;
    if (property.isList && !parseCount(property, count)) {
      return false;
    }
    return values_.skip(property.type, count) || missing(property);
  }

  // The length of a list, which the rest of the file has room for.
  bool parseCount(const PlyProperty& property, std::size_t& count) {
    const char* const where = values_.start();
    std::int64_t value = 0;
    if (!values_.integer(property.countType, value)) {
      return missing(property);
    }
    if (value < 0 || !values_.hasRoomFor(property.type, static_cast<std::size_t>(value))) {
      values_.at = where;
      return failAt(nameOf(property) + " declares " +
                    (value == kNoInteger ? "a length that is no integer" : std::to_string(value) + " items") +
                    "; the rest of the file has no room for them");
    }
    count = static_cast<std::size_t>(value);
    return true;
  }

  bool missing(const PlyProperty& property) {
    return failAt("expected a value of " + nameOf(property) + ", " + values_.found());
  }

  [[nodiscard]] std::string nameOf(const PlyProperty& property) const {
    return shown(property.name) + " of " + shown(element_->name) + " " + std::to_string(row_);
  }

  bool failAt(const std::string& message) { return failWith(values_.malformed(input_, message)); }

  bool failWith(tl::unexpected<Error> error) {
    error_ = std::move(error.value());
    return false;
  }

  [[nodiscard]] bool keepGoing() const {
    return input_.progress.keepGoing(static_cast<double>(values_.at - input_.bytes.data()) /
                                     static_cast<double>(input_.bytes.size()));
  }

  const ReadInput& input_;
  const PlyHeader& header_;
  Values values_;
  std::size_t vertexCount_ = 0;
  const PlyElement* element_ = nullptr;
  std::vector<int> axes_;                    // of the element's properties
  const PlyProperty* cornerList_ = nullptr;  // of the element
  std::size_t row_ = 0;                      // of the element
  RawMesh mesh_;
  std::optional<Error> error_;
};

// The number of declared vertices, if the header declares all that a mesh needs.
Result<std::size_t> checkElements(const ReadInput& input, const PlyHeader& header) {
  const PlyElement* vertex = nullptr;
  const PlyElement* strips = nullptr;
  const PlyElement* face = nullptr;
  for (const PlyElement& element : header.elements) {
    vertex = element.name == "vertex" ? &element : vertex;
    strips = element.name == "tristrips" ? &element : strips;
    face = element.name == "face" ? &element : face;
  }
  if (vertex == nullptr) {
    return malformedLine(input, header.body, "the header declares no element 'vertex'");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto found = std::count_if(vertex->properties.begin(), vertex->properties.end(),
                                     [axis](const PlyProperty& p) { return axisOf(p) == axis; });
    if (found != 1) {
      return malformedLine(input, vertex->line,
                           std::string("the element 'vertex' must have one property '") + "xyz"[axis] +
                               "', it has " + std::to_string(found));
    }
  }
  const auto lists =
      face != nullptr ? std::count_if(face->properties.begin(), face->properties.end(), isCornerList) : 0;
  if (lists == 0 && strips != nullptr) {
    return malformedLine(input, strips->line,
                         "the file holds triangle strips, which are not read; save it with faces");
  }
  if (lists > 1) {
    return malformedLine(input, face->line, "the element 'face' has two lists of vertices");
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
