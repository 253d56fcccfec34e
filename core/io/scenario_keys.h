#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/fusion/embedding.h"
#include "core/fusion/paths.h"
#include "core/io/mesh_file.h"

/// The words that files use for settings: one table for parsing and formatting.
namespace graftsman::scenario_keys {

inline constexpr std::array<std::pair<std::string_view, PathMode>, 2> kPathModes = {
    {{"straightened", PathMode::Straightened}, {"paper", PathMode::Paper}}};

inline constexpr std::array<std::pair<std::string_view, EmbeddingSettings::Method>, 4> kEmbeddingMethods = {
    {{"automatic", EmbeddingSettings::Method::Automatic},
     {"cotangent", EmbeddingSettings::Method::Cotangent},
     {"mean-value", EmbeddingSettings::Method::MeanValue},
     {"low-stretch", EmbeddingSettings::Method::LowStretch}}};

inline constexpr std::array<std::pair<std::string_view, MeshFormat>, 4> kMeshFormats = {
    {{"OBJ", MeshFormat::Obj}, {"PLY", MeshFormat::Ply}, {"STL", MeshFormat::Stl}, {"OFF", MeshFormat::Off}}};

inline constexpr std::array<std::pair<const char*, std::size_t ReadReport::*>, 7> kReportCounts = {
    {{"file_vertices", &ReadReport::fileVertices},
     {"file_faces", &ReadReport::fileFaces},
     {"triangulated", &ReadReport::triangulated},
     {"welded", &ReadReport::welded},
     {"dropped_degenerate", &ReadReport::droppedDegenerate},
     {"dropped_duplicate", &ReadReport::droppedDuplicate},
     {"isolated", &ReadReport::isolated}}};

/// The word of a value in one of the tables above.
template <class Table, class Value>
std::string wordFor(const Table& table, Value value) {
  for (const auto& [word, meaning] : table) {
    if (meaning == value) {
      return std::string(word);
    }
  }
  return {};
}

}  // namespace graftsman::scenario_keys
