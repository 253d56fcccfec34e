#include <algorithm>
#include <list>
#include <map>
#include <new>
#include <set>
#include <utility>

#include "core/io/fusion_json.h"
#include "core/io/printable.h"
#include "core/project/history_file.h"
#include "core/project/project_mesh.h"
#include "core/project/project_remains.h"
#include "core/project/zip_writer.h"

namespace graftsman {

using namespace fusion_json;

namespace {

using Packing = ZipWriter::Packing;

// Adds what `old` has and `now` lacks. Every key that this version knows is always written, so that these are
// the unknown ones.
void carry(json& now, const json& old) {
  if (!now.is_object() || !old.is_object()) {
    return;
  }
  for (const auto& [key, value] : old.items()) {
    const auto [known, added] = now.emplace(key, value);
    if (!added) {
      carry(*known, value);
    }
  }
}

// The same for the pairs' points: what is said about a point goes along while it is the same point.
void carryLoop(json& now, const json& old) {
  if (!old.is_array()) {
    return;
  }
  for (std::size_t i = 0; i < std::min(now.size(), old.size()); ++i) {
    for (std::size_t side = 0; side < 2 && old[i].is_array() && old[i].size() == 2; ++side) {
      json& point = now[i][side];
      const json& before = old[i][side];
      const auto alike = [&](const char* key) {
        return before.value(key, json()) == point.value(key, json());
      };
      if (point.is_object() && before.is_object() && alike("face") && alike("bary") && alike("at")) {
        carry(point, before);
      }
    }
  }
}

class ProjectWriter {
 public:
  explicit ProjectWriter(const Project& project)
      : project_(project),
        kept_(project.remains ? project.remains : std::make_shared<const ProjectRemains>()),
        remains_(*kept_) {
    for (const ProjectRemains::Entry& entry : remains_.entries) {
      names_.insert(entry.name);
    }
    for (const json& record : remains_.otherMeshes) {
      meetId(record);
    }
    for (const ProjectRemains::Known& known : remains_.known) {
      meetId(known.record);
    }
  }

  Result<void> write(const std::filesystem::path& path, const Progress& progress) {
    const std::string document = documentText();
    Result<void> added = add(project_keys::kMimetypeEntry, project_keys::kMimetype, Packing::Stored);
    added = added ? add(project_keys::kDocumentEntry, document, Packing::Deflated) : added;
    for (const auto& [mesh, name, entry] : entries_) {
      const auto& blocks = entry.blocks();
      added = added ? zip_.add(name, {blocks.begin(), blocks.end()}, Packing::Stored) : added;
    }
    if (!project_.thumbnail.empty()) {
      added = added ? add(project_keys::kThumbnailEntry, project_.thumbnail, Packing::Stored) : added;
    }
    for (const auto& [id, picture] : project_.variantPictures) {
      if (find(project_.document.variants, id) != nullptr) {
        added = added ? add(project_keys::variantPictureEntry(id), picture, Packing::Stored) : added;
      }
    }
    if (!project_.viewState.empty()) {
      added = added ? add(project_keys::kViewEntry, project_.viewState, Packing::Deflated) : added;
    }
    if (!history_.empty()) {
      added = added ? add(project_keys::kHistoryEntry, history_, Packing::Deflated) : added;
    }
    for (const ProjectRemains::Entry& entry : remains_.entries) {
      // A history of a newer program gives way to one of this program.
      if (!history_.empty() && entry.name == project_keys::kHistoryEntry) {
        continue;
      }
      added =
          added ? add(entry.name, entry.bytes, entry.stored ? Packing::Stored : Packing::Deflated) : added;
    }
    if (!added) {
      added.error().message = printable(path.string(), kLongestPathShown) + ": " + added.error().message;
      return added;
    }
    return zip_.write(path, progress);
  }

 private:
  struct MeshOfFile {
    MeshOfFile(const TriangleMesh& stored, std::string under)
        : mesh(&stored), name(std::move(under)), entry(stored) {}
    const TriangleMesh* mesh;
    std::string name;
    MeshEntry entry;
  };

  Result<void> add(const std::string& name, std::string_view bytes, Packing packing) {
    return zip_.add(name, {bytes}, packing);
  }

  void meetId(const json& record) {
    const json* id = record.is_object() ? find(record, "id") : nullptr;
    if (id != nullptr && id->is_number_unsigned()) {
      usedIds_.insert(id->get<std::uint64_t>());
    }
  }

  std::string documentText() {
    const Document& document = project_.document;
    json meshes = json::array();
    json fusions = listOf(document.fusions, meshes, old("fusions"));
    json variants = json::array();
    for (const auto& variant : document.variants) {
      variants.push_back(variantOf(*variant, meshes));
    }
    forHistory_ = true;
    history_ = HistoryFile::write(
        project_.history, document, remains_.history, [](const Fusion& fusion) { return fusionOf(fusion); },
        [&](const std::shared_ptr<const MeshAsset>& asset) { return sourceOf(asset, meshes); });
    for (const json& record : remains_.otherMeshes) {
      meshes.push_back(record);
    }
    json features = json::array();
    if (usesResults_) {
      features.push_back(project_keys::kResultsFeature);
    }
    json text = {{"format_version", format()},
                 {"minimum_reader_version", project_keys::kReader},
                 {"required_features", std::move(features)},
                 {"written_by", "Graftsman " GRAFTSMAN_VERSION},
                 {"meshes", std::move(meshes)},
                 {"shown", project_.shown},
                 {"fusions", std::move(fusions)},
                 {"variants", std::move(variants)}};
    carry(text, remains_.document);
    return text.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
  }

  // The list of that key in the document that was read; null without one.
  [[nodiscard]] const json* old(const char* key) const {
    const json* list = remains_.document.is_object() ? find(remains_.document, key) : nullptr;
    return list != nullptr && list->is_array() ? list : nullptr;
  }

  // The list's object of that id; null without one.
  static const json* withId(const json* list, int id) {
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
      const json& one = (*list)[i];
      if (one.is_object() && one.value("id", json(i + 1)) == json(id)) {
        return &one;
      }
    }
    return nullptr;
  }

  json listOf(const FusionList& fusions, json& meshes, const json* before) {
    json list = json::array();
    for (const auto& one : fusions) {
      json fusion = fusionOf(*one);
      const json part = sourceOf(one->part, meshes);
      fusion["part"] = part;
      fusion["base"] = one->base == one->part ? part : sourceOf(one->base, meshes);
      if (const json* known = withId(before, one->id)) {
        carryFusion(fusion, *known);
      }
      list.push_back(std::move(fusion));
    }
    return list;
  }

  json variantOf(const Variant& variant, json& meshes) {
    const json* before = withId(old("variants"), variant.id);
    const json* fusionsBefore = before != nullptr ? find(*before, "fusions") : nullptr;
    if (fusionsBefore != nullptr && !fusionsBefore->is_array()) {
      fusionsBefore = nullptr;
    }
    json written = {{"id", variant.id},       {"name", variant.name},
                    {"note", variant.note},   {"starred", variant.starred},
                    {"shown", variant.shown}, {"fusions", listOf(variant.fusions, meshes, fusionsBefore)}};
    if (before != nullptr) {
      carry(written, *before);
    }
    return written;
  }

  // What a newer program added is written again, so the file keeps that program's number.
  [[nodiscard]] unsigned format() const {
    return std::max(project_keys::kFormat,
                    remains_.document.is_object() ? remains_.document.value("format_version", 0U) : 0U);
  }

  static json fusionOf(const Fusion& fusion) {
    Ordered written;
    written["id"] = fusion.id;
    written["name"] = fusion.name;
    writeInputs(written, fusion.inputs);
    written["closed"] = fusion.closed;
    return written;
  }

  static void carryFusion(json& now, const json& old) {
    carry(now, old);
    if (old.is_object() && old.contains("cvp")) {
      carryLoop(now["cvp"], old["cvp"]);
    }
  }

  // A fusion's part or base: a mesh's number, {"result": a fusion's id}, or null.
  json sourceOf(const std::shared_ptr<const MeshAsset>& asset, json& meshes) {
    if (asset && asset->result != 0) {
      usesResults_ = true;
      return {{"result", asset->result}};
    }
    return asset && asset->mesh ? json(numberOf(asset, meshes)) : json();
  }

  // The number of the mesh's record, which is put into `meshes` where it is not yet.
  std::uint64_t numberOf(const std::shared_ptr<const MeshAsset>& asset, json& meshes) {
    if (const auto written = numbers_.find(asset.get()); written != numbers_.end()) {
      return written->second;
    }
    const auto known = std::find_if(remains_.known.begin(), remains_.known.end(),
                                    [&](const auto& one) { return one.asset.lock() == asset; });
    std::uint64_t id = 1;
    while (known == remains_.known.end() && !usedIds_.insert(id).second) {
      ++id;
    }
    id = known == remains_.known.end() ? id : static_cast<std::uint64_t>(known->id);
    const MeshOfFile& stored = entryOf(*asset->mesh, id);
    json record = {{"id", id},
                   {"name", asset->name},
                   {"source", asset->source.string()},
                   {"report", json(toJson(asset->report))},
                   {"entry", stored.name},
                   {"vertices", asset->mesh->vertexCount()},
                   {"faces", asset->mesh->faceCount()},
                   {project_keys::kHistoryOnly, forHistory_},
                   {"crc32", stored.entry.crc32()}};
    if (known != remains_.known.end()) {
      carry(record, known->record);
    }
    meshes.push_back(std::move(record));
    numbers_[asset.get()] = id;
    return id;
  }

  // One entry for a mesh, however many records name it.
  const MeshOfFile& entryOf(const TriangleMesh& mesh, std::uint64_t id) {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const MeshOfFile& one) { return one.mesh == &mesh; });
    if (found != entries_.end()) {
      return *found;
    }
    std::string name = "meshes/" + std::to_string(id) + ".mesh";
    while (!names_.insert(name).second) {
      name = "meshes/_" + name.substr(name.find('/') + 1);
    }
    return entries_.emplace_back(mesh, std::move(name));
  }

  const Project& project_;
  const std::shared_ptr<const ProjectRemains> kept_;
  const ProjectRemains& remains_;
  ZipWriter zip_;
  std::set<std::string> names_;                        // of entries that are taken
  std::set<std::uint64_t> usedIds_;                    // of meshes
  std::map<const MeshAsset*, std::uint64_t> numbers_;  // of meshes that are written
  bool usesResults_ = false;
  bool forHistory_ = false;  // what gets a number now only the history needs
  std::string history_;      // history.json
  std::list<MeshOfFile> entries_;
};

}  // namespace

Result<void> writeProject(const std::filesystem::path& path, const Project& project,
                          const Progress& progress) {
  try {
    return ProjectWriter(project).write(path, progress);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::OutOfMemory,
                printable(path.string(), kLongestPathShown) + ": not enough memory to save the project.");
  }
}

}  // namespace graftsman
