#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/project/project_file.h"

namespace graftsman {

/// The names and numbers that a project file is made of.
namespace project_keys {
inline constexpr const char* kMimetypeEntry = "mimetype";
inline constexpr const char* kMimetype = "application/x-graftsman";
inline constexpr const char* kDocumentEntry = "document.json";
inline constexpr const char* kThumbnailEntry = "thumbnail.png";
inline constexpr const char* kViewEntry = "view.json";
inline constexpr const char* kHistoryEntry = "history.json";
/// Of a mesh's record, whether the history alone needs it.
inline constexpr const char* kHistoryOnly = "history_only";
/// A fusion's part or base is another one's result. Required of a reader where it occurs.
inline constexpr const char* kResultsFeature = "results-as-meshes";

/// The entry of a variant's picture.
[[nodiscard]] inline std::string variantPictureEntry(int id) {
  return "variants/" + std::to_string(id) + ".png";
}

/// What this program writes, and the newest that it understands. A change that an older program may ignore
/// without harm raises the first alone.
inline constexpr unsigned kFormat = 2;
inline constexpr unsigned kReader = 1;
}  // namespace project_keys

struct ProjectRemains {
  struct Entry {
    std::string name;
    std::string bytes;
    bool stored = false;
  };
  /// A mesh that was read, with its record: it keeps its number and what else is said about it.
  struct Known {
    std::weak_ptr<const MeshAsset> asset;
    int id = 0;
    nlohmann::json record;
  };

  nlohmann::json document;                            // the whole of it, without its meshes
  std::vector<Known> known;                           // the meshes that were read
  std::vector<nlohmann::json> otherMeshes;            // records of meshes that the fusion does not use
  std::vector<Entry> entries;                         // what no record that was read names
  nlohmann::json history = nlohmann::json::object();  // what history.json has besides the history
};

}  // namespace graftsman
