#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/raw_mesh.h"

namespace graftsman {

/// The scalar types of PLY.
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes of a scalar in a binary file.
[[nodiscard]] std::size_t sizeOf(PlyType type);

enum class PlyEncoding { Ascii, BinaryLittleEndian, BinaryBigEndian };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;  // of the scalar, or of a list's items
  bool isList = false;
  PlyType countType = PlyType::UInt8;  // of a list's length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::string declared;        // the count as the file says it, for messages
  const char* line = nullptr;  // that declares it
  std::vector<PlyProperty> properties;
};

/// What the header of a PLY file declares.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  const char* body = nullptr;  // the first byte after the header
};

/// Parses the header, and makes sure that the file is long enough for the elements it declares. Error:
/// FileMalformed.
[[nodiscard]] Result<PlyHeader> parsePlyHeader(const ReadInput& input);

}  // namespace graftsman
