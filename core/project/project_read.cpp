#include <algorithm>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <utility>

#include "core/io/fusion_json.h"
#include "core/io/printable.h"
#include "core/io/read_file.h"
#include "core/project/history_file.h"
#include "core/project/project_mesh.h"
#include "core/project/project_parse.h"
#include "core/project/project_remains.h"

namespace graftsman {

using namespace fusion_json;

namespace {

constexpr double kFileShare = 0.3;          // of the progress: the file into memory
constexpr double kMeshesShare = 0.9;        // up to here, its meshes
constexpr std::size_t kLongestName = 4096;  // of an entry that is kept; longer ones are no one's work

std::string inQuotes(const std::string& text) {
  return "\"" + printable(text, kLongestPathShown) + "\"";
}

unsigned version(const json& document, const char* key) {
  return static_cast<unsigned>(index(demand(document, key, "a whole number"), key, "a whole number"));
}

const json& list(const json& document, const char* key) {
  const json& value = demand(document, key, "a list");
  if (!value.is_array()) {
    malformed(key, "a list");
  }
  return value;
}

// Why this program must not open the document; empty if it may. Throws Malformed.
std::string needed(const json& document) {
  const unsigned reader = version(document, "minimum_reader_version");
  std::string why;
  if (reader > project_keys::kReader) {
    why = "its format is " + std::to_string(reader) + ", and this program reads " +
          std::to_string(project_keys::kReader);
  }
  for (const json& feature : list(document, "required_features")) {
    const std::string wanted = string(feature, "required_features", "a list of names");
    if (wanted != project_keys::kResultsFeature) {
      why += (why.empty() ? "" : "; ") + std::string("it uses ") + inQuotes(wanted);
    }
  }
  return why;
}

class ProjectReader {
 public:
  ProjectReader(ZipReader zip, std::string name, Wanted wanted, const Progress& progress)
      : zip_(std::move(zip)), name_(std::move(name)), wanted_(wanted), progress_(progress) {}

  Result<LoadedProject> read() {
    const ZipEntry* entry = zip_.find(project_keys::kDocumentEntry);
    if (entry == nullptr) {
      return malformedFile("is no Graftsman project: it has no document.json.");
    }
    const Result<std::string> text = zip_.content(*entry, {});
    if (!text) {
      return malformedFile("cannot be opened: its document.json is damaged (" + text.error().message + ").");
    }
    try {
      json document = parse(*text);
      if (!document.is_object()) {
        return malformedFile("cannot be understood: its document.json is no JSON object.");
      }
      if (const std::string why = needed(document); !why.empty()) {
        return fail(ErrorCode::ProjectTooNew,
                    name_ + ": needs a newer version of this program: " + why + ". It was saved by " +
                        printable(DocumentReader::textOr(document, "written_by", "a newer Graftsman"),
                                  kLongestPathShown) +
                        "; open it with that. The file was left as it is.");
      }
      version(document, "format_version");
      readDocument(document);
      if (wanted_ == Wanted::Everything) {
        readHistory(list(document, "meshes"));
        readRest();
        keepRemains(std::move(document));
      }
    } catch (const Malformed& wrong) {
      return malformedFile("cannot be understood: in its document.json " + wrong.what);
    }
    if (progress_.cancelled()) {
      return fail(ErrorCode::Cancelled, "Opening the project was cancelled.");
    }
    return std::move(loaded_);
  }

 private:
  tl::unexpected<Error> malformedFile(const std::string& what) const {
    return fail(ErrorCode::FileMalformed, name_ + ": " + what);
  }

  // Many variants may need the same mesh: it is told once.
  void lose(Error error) {
    if (told_.insert(error.message).second) {
      loaded_.damage.push_back(std::move(error));
    }
  }

  void readDocument(const json& document) {
    const json& fusions = list(document, "fusions");
    const json& meshes = list(document, "meshes");
    if (fusions.empty()) {
      return;
    }
    bool inVariants = false;
    const DocumentReader::Lose loseOf = [this, &inVariants](Error error, bool ofResult) {
      loaded_.fusionIntact = loaded_.fusionIntact && (!ofResult || inVariants);
      lose(std::move(error));
    };
    const DocumentReader reader(
        [&](Side side, const json& fusion, const Progress& progress) {
          return asset(side, fusion, meshes, loseOf, progress);
        },
        loseOf);
    Document& read = loaded_.project.document;
    read.fusions = reader.fusions(fusions, progress_.span(0, kMeshesShare));
    loaded_.project.shown = DocumentReader::shown(document, read.fusions);
    inVariants = true;
    if (const json* variants = find(document, "variants")) {
      read.variants = reader.variants(*variants);
    }
  }

  // The mesh that the fusion names for this side; null if it names none, or none that can be read.
  std::shared_ptr<const MeshAsset> asset(Side side, const json& fusion, const json& meshes,
                                         const DocumentReader::Lose& loseOf, const Progress& progress) {
    const json* reference = find(fusion, name(side));
    if (reference == nullptr || reference->is_null()) {
      return nullptr;
    }
    if (reference->is_object()) {
      MeshAsset result;  // its name comes when all fusions are known
      result.result = DocumentReader::id(*reference, "result", std::numeric_limits<int>::max());
      return std::make_shared<const MeshAsset>(std::move(result));
    }
    Index id = -1;
    std::string lost = "mesh";
    std::string remedy = "Load it again";
    try {
      id = index(*reference, name(side), "the number of a mesh");
      if (const auto known = assets_.find(id); known != assets_.end()) {
        return known->second;
      }
      if (const auto known = lostAssets_.find(id); known != lostAssets_.end()) {
        loseOf(known->second, true);
        return nullptr;
      }
      const json& record = recordOf(id, meshes);
      auto read = std::make_shared<MeshAsset>();
      const std::string entry = string(demand(record, "entry", "a name"), "entry", "a name");
      consumed_.insert(entry);
      read->name = DocumentReader::textOr(record, "name", entry);
      const std::string source = DocumentReader::textOr(record, "source", "");
      read->source = source;
      lost += " " + inQuotes(read->name) + " (" + printable(entry) + ")";
      remedy += source.empty() ? "" : ": it was read from " + printable(source, kLongestPathShown);
      read->report = reportOf(record);
      read->mesh = mesh(entry, record, progress);
      remains_->known.push_back({read, id, record});
      assets_[id] = read;
      return read;
    } catch (const Malformed& wrong) {
      const Error error = {ErrorCode::FileMalformed,
                           std::string("The ") + name(side) + "'s " + lost +
                               " is damaged and was left out: " + wrong.what +
                               (wrong.what.ends_with(".") ? " " : ". ") + remedy + ".",
                           side};
      if (id >= 0) {
        lostAssets_.try_emplace(id, error);
      }
      loseOf(error, true);
    }
    return nullptr;
  }

  const json& recordOf(Index id, const json& meshes) {
    usedIds_.insert(id);
    for (const json& record : meshes) {
      if (hasId(record, id)) {
        return record;
      }
    }
    throw Malformed{ErrorCode::FileMalformed, "the project has no mesh number " + std::to_string(id)};
  }

  static bool hasId(const json& record, Index id) {
    const json* given = record.is_object() ? find(record, "id") : nullptr;
    return given != nullptr && given->is_number_unsigned() && *given == id;
  }

  ReadReport reportOf(const json& record) {
    try {
      const json* report = find(record, "report");
      return report == nullptr ? ReadReport() : readReport(*report);
    } catch (const Malformed& wrong) {
      lose({ErrorCode::FileMalformed, "In the project's document.json " + wrong.what +
                                          " What was done on reading this mesh is forgotten; the mesh is "
                                          "whole, nothing needs to be done."});
    }
    return {};
  }

  // Throws Malformed. A mesh that two records name is read once.
  std::shared_ptr<const TriangleMesh> mesh(const std::string& name, const json& record,
                                           const Progress& progress) {
    const auto wrong = [](const std::string& what) { return Malformed{ErrorCode::FileMalformed, what}; };
    const ZipEntry* entry = zip_.find(name);
    if (entry == nullptr) {
      throw wrong("the file has no such entry");
    }
    std::shared_ptr<const TriangleMesh>& mesh = meshes_[name];
    if (!mesh) {
      Result<std::shared_ptr<const TriangleMesh>> read = readMeshEntry(zip_, *entry, progress);
      if (!read) {
        throw wrong(read.error().message);
      }
      mesh = std::move(*read);
    }
    const auto differs = [&](const char* key, std::uint64_t value) {
      const json* given = find(record, key);
      return given != nullptr && *given != value;
    };
    if (differs("vertices", static_cast<std::uint64_t>(mesh->vertexCount())) ||
        differs("faces", static_cast<std::uint64_t>(mesh->faceCount())) || differs("crc32", entry->crc32)) {
      throw wrong("it is not the mesh that the project was saved with");
    }
    return mesh;
  }

  // The history that undo and redo go through. Damage costs all of it and nothing else.
  void readHistory(const json& meshes) {
    const ZipEntry* entry = zip_.find(project_keys::kHistoryEntry);
    try {
      if (entry == nullptr) {
        dropHistoryMeshes(meshes);
        return;
      }
      if (entry->size > history_bounds::kMostBytes) {
        throw Malformed{ErrorCode::FileMalformed, "it is larger than this program keeps"};
      }
      const Result<std::string> content = zip_.content(*entry, {});
      if (!content) {
        throw Malformed{ErrorCode::FileMalformed, content.error().message};
      }
      json text = parse(*content);
      if (HistoryFile::isNewer(text)) {
        return;  // goes along as it is
      }
      consumed_.insert(project_keys::kHistoryEntry);
      const DocumentReader reader(
          [&](Side side, const json& fusion, const Progress& progress) {
            return asset(
                side, fusion, meshes,
                [](const Error&, bool) {
                  throw Malformed{ErrorCode::FileMalformed, "a mesh that it needs is damaged or missing"};
                },
                progress);
          },
          [](const Error&, bool) {
            throw Malformed{ErrorCode::FileMalformed, "a fusion in it cannot be understood"};
          });
      loaded_.project.history = HistoryFile::read(text, loaded_.project.document, reader);
      remains_->history = HistoryFile::others(std::move(text));
    } catch (const Malformed& wrong) {
      lose({ErrorCode::FileMalformed, "The undo history (history.json) was left out: " + wrong.what +
                                          (wrong.what.ends_with(".") ? "" : ".") +
                                          " The document is not concerned; nothing needs to be done."});
    }
    consumed_.insert(project_keys::kHistoryEntry);
    dropHistoryMeshes(meshes);
  }

  // Meshes that only the history needed are not kept beyond it.
  void dropHistoryMeshes(const json& meshes) {
    for (const json& record : meshes) {
      const json* only = record.is_object() ? find(record, project_keys::kHistoryOnly) : nullptr;
      const json* id = only != nullptr && *only == true ? find(record, "id") : nullptr;
      if (id != nullptr && id->is_number_unsigned() &&
          *id <= static_cast<std::uint64_t>(std::numeric_limits<Index>::max())) {
        usedIds_.insert(id->get<Index>());
        if (const std::string entry = DocumentReader::textOr(record, "entry", ""); !entry.empty()) {
          consumed_.insert(entry);
        }
      }
    }
  }

  // The picture and the state of the interface.
  void readRest() {
    const auto read = [&](const char* name, const char* what, std::string& target) {
      consumed_.insert(name);
      const ZipEntry* entry = zip_.find(name);
      Result<std::string> content = entry == nullptr ? std::string() : zip_.content(*entry, progress_);
      if (content) {
        target = std::move(*content);
      } else {
        lose({content.error().code, std::string(what) + " (" + name + ") is damaged and was left out: " +
                                        content.error().message + ". Saving the project makes it anew."});
      }
    };
    read(project_keys::kThumbnailEntry, "The project's small picture", loaded_.project.thumbnail);
    for (const auto& variant : loaded_.project.document.variants) {
      std::string picture;
      read(project_keys::variantPictureEntry(variant->id).c_str(), "A variant's picture", picture);
      if (!picture.empty()) {
        loaded_.project.variantPictures[variant->id] = std::move(picture);
      }
    }
    read(project_keys::kViewEntry, "The state of the views", loaded_.project.viewState);
  }

  // What this version does not know goes along, to be written again.
  void keepRemains(json document) {
    consumed_.insert({project_keys::kMimetypeEntry, project_keys::kDocumentEntry});
    for (const ZipEntry& entry : zip_.entries()) {
      const bool isFolder = entry.name.ends_with('/');
      if (isFolder || !consumed_.insert(entry.name).second) {
        continue;
      }
      Result<std::string> content = std::string();
      if (entry.name.empty() || entry.name.size() > kLongestName) {
        content = fail(ErrorCode::FileMalformed, "its name is empty or very long");
      } else {
        content = zip_.content(entry, progress_);
      }
      if (content) {
        remains_->entries.push_back({entry.name, std::move(*content), entry.stored});
      } else {
        lose({ErrorCode::FileMalformed,
              "The entry " + inQuotes(entry.name) +
                  ", which this version does not know, is damaged and was left out: " +
                  content.error().message + ". If it matters, keep a copy of the file before you save."});
      }
    }
    for (json& record : document["meshes"]) {
      if (std::ranges::none_of(usedIds_, [&](Index id) { return hasId(record, id); })) {
        remains_->otherMeshes.push_back(std::move(record));
      }
    }
    document.erase("meshes");
    remains_->document = std::move(document);
    loaded_.project.remains = remains_;
  }

  ZipReader zip_;
  std::string name_;
  Wanted wanted_;
  Progress progress_;
  LoadedProject loaded_;
  std::shared_ptr<ProjectRemains> remains_ = std::make_shared<ProjectRemains>();
  std::map<Index, std::shared_ptr<const MeshAsset>> assets_;           // by id
  std::map<Index, Error> lostAssets_;                                  // by id
  std::map<std::string, std::shared_ptr<const TriangleMesh>> meshes_;  // by entry
  std::set<std::string> told_;                                         // the messages of the damage
  std::set<Index> usedIds_;
  std::set<std::string> consumed_;  // names of entries that the document or the remains hold by now
};

}  // namespace

Result<LoadedProject> parseProject(std::span<const char> bytes, const std::filesystem::path& path,
                                   const Progress& progress, Wanted wanted) {
  const std::string name = printable(path.string(), kLongestPathShown);
  try {
    Result<ZipReader> zip = ZipReader::open(bytes);
    if (!zip) {
      return fail(ErrorCode::FileMalformed,
                  name + ": is no Graftsman project, or its end is missing (" + zip.error().message + ").");
    }
    return ProjectReader(std::move(*zip), name, wanted, progress).read();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::OutOfMemory, name + ": not enough memory to open the project.");
  }
}

Result<LoadedProject> readProject(const std::filesystem::path& path, const Progress& progress,
                                  Wanted wanted) {
  const Result<FileBytes> file = readFile(path, progress.span(0, kFileShare));
  if (!file) {
    return fail(file.error());
  }
  return parseProject(file->bytes(), path, progress.span(kFileShare, 1), wanted);
}

}  // namespace graftsman
