#include "core/io/ply_reader.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "core/io/ply_header.h"
#include "core/io/ply_values.h"
#include "core/io/text_scanner.h"

namespace graftsman {
namespace {

constexpr std::size_t kRowsPerLook = 4096;  // at the progress

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
