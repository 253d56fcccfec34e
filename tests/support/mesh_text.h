#pragma once

#include <array>
#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/mesh_file.h"

/// Mesh files as text for tests.
namespace graftsman::mesh_text {

inline Result<MeshFile> parse(std::string_view text, MeshFormat format) {
  static constexpr std::array<const char*, 4> kNames = {"folder/nose.obj", "folder/nose.ply",
                                                        "folder/nose.stl", "folder/nose.off"};
  return parseMesh(text, format, kNames[static_cast<std::size_t>(format)], {});
}

inline Result<MeshFile> obj(std::string_view text) {
  return parse(text, MeshFormat::Obj);
}
inline Result<MeshFile> ply(std::string_view text) {
  return parse(text, MeshFormat::Ply);
}
inline Result<MeshFile> stl(std::string_view text) {
  return parse(text, MeshFormat::Stl);
}
inline Result<MeshFile> off(std::string_view text) {
  return parse(text, MeshFormat::Off);
}

/// The message of a file that is refused as malformed; empty if it is not.
inline std::string refusal(const Result<MeshFile>& file) {
  return !file && file.error().code == ErrorCode::FileMalformed ? file.error().message : "";
}

/// The value's bytes, in this machine's order or the other one.
template <class T>
std::string raw(T value, bool swapped = false) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  return swapped ? std::string(bytes.rbegin(), bytes.rend()) : std::string(bytes.begin(), bytes.end());
}

/// A binary STL file of facets of nine floats.
inline std::string binaryStl(const std::vector<std::array<float, 9>>& facets,
                             const std::string& header = "binary") {
  std::string text =
      header + std::string(80 - header.size(), '\0') + raw(static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    text += std::string(12, '\0');
    for (const float c : facet) {
      text += raw(c);
    }
    text += std::string(2, '\0');
  }
  return text;
}

}  // namespace graftsman::mesh_text
