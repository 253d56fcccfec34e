#pragma once

#include <QTemporaryDir>
#include <cstring>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/project/project_parse.h"
#include "core/project/zip_reader.h"
#include "core/project/zip_writer.h"
#include "tests/support/projects.h"

/// Projects' files in memory, taken apart and put together again.
namespace graftsman::projects {

/// Contents by name.
using Entries = std::map<std::string, std::string>;

inline bool sameMesh(const std::shared_ptr<const TriangleMesh>& a,
                     const std::shared_ptr<const TriangleMesh>& b) {
  return a->faces() == b->faces() && a->points().size() == b->points().size() &&
         std::memcmp(a->points().data(), b->points().data(), a->points().size() * sizeof(Point)) == 0;
}

inline void verifySameAsset(const std::shared_ptr<const MeshAsset>& a,
                            const std::shared_ptr<const MeshAsset>& b) {
  QVERIFY(a && b);
  QCOMPARE(a->name, b->name);
  QCOMPARE(a->source, b->source);
  const auto counted = [](const ReadReport& r) {
    return std::tuple(r.format, r.binary, r.fileVertices, r.fileFaces, r.triangulated, r.welded,
                      r.droppedDegenerate, r.droppedDuplicate, r.isolated);
  };
  QVERIFY(counted(a->report) == counted(b->report));
  QVERIFY(sameMesh(a->mesh, b->mesh));
}

/// The same edit state, but for the meshes, which are others when a file is read again.
inline bool sameEdits(const Fusion& a, Fusion b) {
  setAsset(b, Side::Part, a.part);
  setAsset(b, Side::Base, a.base);
  return a == b;
}
inline bool sameEdits(const Project& a, const Project& b) {
  return a.document.fusions.size() == 1 && b.document.fusions.size() == 1 &&
         sameEdits(fusionOf(a), fusionOf(b));
}

/// What `write` puts into the file that it is given.
inline std::string written(const std::function<Result<void>(const std::filesystem::path&)>& write) {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.graft").toStdString();
  mustSucceed(write(path));
  return readAll(path);
}

/// The bytes of the project's file.
inline std::string bytesOf(const Project& project) {
  return written([&](const std::filesystem::path& path) { return writeProject(path, project, {}); });
}

inline Result<LoadedProject> parse(const std::string& bytes) {
  return parseProject(bytes, "a.graft", {});
}

inline Entries entriesOf(const std::string& bytes) {
  Entries entries;
  ZipReader zip = ZipReader::open(bytes).value();
  for (const ZipEntry& entry : zip.entries()) {
    entries[entry.name] = zip.content(entry, {}).value();
  }
  return entries;
}

inline std::string zipOf(const Entries& entries, ZipWriter::Packing packing = ZipWriter::Packing::Deflated) {
  ZipWriter zip;
  for (const auto& [name, bytes] : entries) {
    mustSucceed(zip.add(name, {bytes}, packing));
  }
  return written([&](const std::filesystem::path& path) { return zip.write(path, {}); });
}

/// The full project with other entries.
inline std::string withEntries(const std::function<void(Entries&)>& edit,
                               ZipWriter::Packing packing = ZipWriter::Packing::Deflated) {
  Entries entries = entriesOf(bytesOf(fullProject()));
  edit(entries);
  return zipOf(entries, packing);
}

/// The full project with another document.json.
inline std::string withDocument(const std::function<void(nlohmann::json&)>& edit) {
  return withEntries([&](Entries& entries) {
    nlohmann::json document = nlohmann::json::parse(entries.at("document.json"));
    edit(document);
    entries["document.json"] = document.dump();
  });
}

}  // namespace graftsman::projects
