#include "core/project/project_file.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cstring>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "core/project/project_parse.h"
#include "core/project/zip_reader.h"
#include "core/project/zip_writer.h"
#include "tests/support/projects.h"
#include "tests/support/samples.h"

using namespace graftsman;
using namespace graftsman::projects;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

using Entries = std::map<std::string, std::string>;

bool sameMesh(const std::shared_ptr<const TriangleMesh>& a, const std::shared_ptr<const TriangleMesh>& b) {
  return a->faces() == b->faces() && a->points().size() == b->points().size() &&
         std::memcmp(a->points().data(), b->points().data(), a->points().size() * sizeof(Point)) == 0;
}

void verifySameAsset(const std::shared_ptr<const MeshAsset>& a, const std::shared_ptr<const MeshAsset>& b) {
  QVERIFY(a && b);
  QCOMPARE(a->name, b->name);
  QCOMPARE(a->source, b->source);
  QVERIFY(std::memcmp(&a->report, &b->report, sizeof(ReadReport)) == 0);
  QVERIFY(sameMesh(a->mesh, b->mesh));
}

// The same edit state, but for the meshes, which are others when a file is read again.
bool sameEdits(const Document& a, Document b) {
  b.part = a.part;
  b.base = a.base;
  b.inputs.part = a.inputs.part;
  b.inputs.base = a.inputs.base;
  return a == b;
}

}  // namespace

class ProjectFileTest : public QObject {
  Q_OBJECT

 private:
  [[nodiscard]] fs::path path(const std::string& name = "a.graft") const {
    return fs::path(folder_.path().toStdString()) / name;
  }

  // The bytes of the project's file.
  std::string bytesOf(const Project& project) const {
    mustSucceed(writeProject(path(), project, {}));
    return readAll(path());
  }

  static Result<LoadedProject> parse(const std::string& bytes) { return parseProject(bytes, "a.graft", {}); }

  static Entries entriesOf(const std::string& bytes) {
    Entries entries;
    ZipReader zip = ZipReader::open(bytes).value();
    for (const ZipEntry& entry : zip.entries()) {
      entries[entry.name] = zip.content(entry, {}).value();
    }
    return entries;
  }

  std::string zipOf(const Entries& entries) const {
    ZipWriter zip;
    for (const auto& [name, bytes] : entries) {
      mustSucceed(zip.add(name, {bytes}, ZipWriter::Packing::Deflated));
    }
    mustSucceed(zip.write(path("edited.graft"), {}));
    return readAll(path("edited.graft"));
  }

  // The full project with other entries, or another document.json.
  std::string withEntries(const std::function<void(Entries&)>& edit) const {
    Entries entries = entriesOf(bytesOf(fullProject()));
    edit(entries);
    return zipOf(entries);
  }
  std::string withDocument(const std::function<void(json&)>& edit) const {
    return withEntries([&](Entries& entries) {
      json document = json::parse(entries.at("document.json"));
      edit(document);
      entries["document.json"] = document.dump();
    });
  }

  // Opens the bytes; exactly one thing is damaged, and its message says what.
  static LoadedProject openDamaged(const std::string& bytes, const std::string& says) {
    Result<LoadedProject> loaded = parse(bytes);
    if (!loaded) {
      qFatal("%s", loaded.error().message.c_str());
    }
    [&] {
      QCOMPARE(loaded->damage.size(), std::size_t{1});
      const std::string& message = loaded->damage[0].message;
      QVERIFY2(message.find(says) != std::string::npos, message.c_str());
      QVERIFY2(message.ends_with("."), message.c_str());
    }();
    return std::move(*loaded);
  }

  static void verifyRefused(const std::string& bytes, ErrorCode code, const std::string& says) {
    const Result<LoadedProject> loaded = parse(bytes);
    QVERIFY(!loaded);
    QVERIFY2(loaded.error().code == code, loaded.error().message.c_str());
    QVERIFY2(loaded.error().message.starts_with("a.graft: "), loaded.error().message.c_str());
    QVERIFY2(loaded.error().message.find(says) != std::string::npos, loaded.error().message.c_str());
  }

  QTemporaryDir folder_;

 private Q_SLOTS:
  void aProjectIsReadAsItWasWritten() {
    const Project project = fullProject();
    QVERIFY(writeProject(path(), project, {}));
    const Result<LoadedProject> loaded = readProject(path(), {});
    QVERIFY(loaded && loaded->damage.empty() && loaded->fusionIntact);
    const Document& document = loaded->project.document;
    QVERIFY(sameEdits(project.document, document));
    verifySameAsset(document.part, project.document.part);
    verifySameAsset(document.base, project.document.base);
    QVERIFY(document.inputs.part == document.part->mesh && document.inputs.base == document.base->mesh);
    QCOMPARE(loaded->project.thumbnail, project.thumbnail);
    QCOMPARE(loaded->project.viewState, project.viewState);
  }

  void everySampleIsReadAsItWasWrittenAndFusesAlike() {
    for (const std::string name : {"fig4a_cone_sphere", "fig9a_cars"}) {
      Project project;
      project.document.inputs = samples::load(name);
      project.document.part = asset("part", project.document.inputs.part);
      project.document.base = asset("base", project.document.inputs.base);
      project.document.closed = true;
      const LoadedProject loaded = parse(bytesOf(project)).value();
      QVERIFY(sameEdits(project.document, loaded.project.document));
      const FusionResults before = update(project.document.inputs, {}, {});
      const FusionResults after = update(loaded.project.document.inputs, {}, {});
      QVERIFY(before.fused && after.fused);
      QCOMPARE(after.fused->points, before.fused->points);
      QCOMPARE(after.fused->faces(), before.fused->faces());
    }
  }

  void anEmptyDocumentAndAnOpenLoopAreReadAsTheyWereWritten() {
    QVERIFY(parse(bytesOf({}))->project.document == Document());
    QVERIFY(parse(bytesOf({}))->project.thumbnail.empty());
    Project project = fullProject();
    project.document.closed = false;
    project.document.base = nullptr;
    project.document.inputs.base = nullptr;
    const LoadedProject loaded = parse(bytesOf(project)).value();
    QVERIFY(loaded.damage.empty());
    QVERIFY(!loaded.project.document.base && !loaded.project.document.closed);
    QVERIFY(sameEdits(project.document, loaded.project.document));
  }

  void coordinatesKeepTheirBits() {
    Project project;
    const std::vector<Point> points = {{-0.0, 5e-324, 1.7976931348623157e308}, {0.1, 1, 0}, {0, 1e-300, 1}};
    project.document.part =
        asset("tiny", std::make_shared<TriangleMesh>(points, std::vector<Face>{{0, 1, 2}}));
    project.document.inputs.part = project.document.part->mesh;
    const LoadedProject loaded = parse(bytesOf(project)).value();
    QVERIFY(sameMesh(loaded.project.document.part->mesh, project.document.part->mesh));
  }

  void theSameProjectGivesTheSameBytes() {
    const Project project = fullProject();
    const std::string bytes = bytesOf(project);
    QVERIFY(bytesOf(project) == bytes);
    QVERIFY(bytesOf(fullProject()) == bytes);
    QVERIFY2(bytesOf(parse(bytes)->project) == bytes, "nor does reading and writing change them");
  }

  void theFirstEntrySaysWhatTheFileIs() {
    const std::string start = bytesOf(fullProject()).substr(0, 61);
    QCOMPARE(start.substr(0, 4), std::string("PK\3\4"));
    QCOMPARE(start.substr(30), std::string("mimetypeapplication/x-graftsman"));
    const Entries entries = entriesOf(bytesOf(fullProject()));
    QCOMPARE(entries.size(), std::size_t{6});
    for (const char* name :
         {"document.json", "meshes/1.mesh", "meshes/2.mesh", "thumbnail.png", "view.json"}) {
      QVERIFY2(entries.contains(name), name);
    }
  }

  void aMeshOnBothSidesIsStoredOnce() {
    Project project = fullProject();
    project.document.base = project.document.part;
    project.document.inputs.base = project.document.inputs.part;
    project.document.inputs.loop.clear();
    QCOMPARE(entriesOf(bytesOf(project)).size(), std::size_t{5});
    LoadedProject loaded = parse(bytesOf(project)).value();
    QVERIFY(loaded.project.document.part && loaded.project.document.part == loaded.project.document.base);
    // Under two names it still is one mesh.
    project.document.base = asset("other.ply", project.document.inputs.part);
    QCOMPARE(entriesOf(bytesOf(project)).size(), std::size_t{5});
    loaded = parse(bytesOf(project)).value();
    QCOMPARE(loaded.project.document.base->name, std::string("other.ply"));
    QVERIFY(loaded.project.document.inputs.part == loaded.project.document.inputs.base);
  }

  void whatThisVersionDoesNotKnowSurvives() {
    const std::string bytes = withEntries([](Entries& entries) {
      json document = json::parse(entries.at("document.json"));
      document["format_version"] = 3;
      document["variants"] = {{"new", {1.5, nullptr}}};
      document["meshes"][0]["colour"] = "red";
      document["meshes"][0]["report"]["seconds"] = 2;
      document["meshes"].push_back({{"id", 9}, {"entry", "meshes/9.mesh"}});
      document["fusions"][0]["title"] = "nose";
      document["fusions"][0]["adjustment"]["lattice"] = {1, 2};
      document["fusions"][0]["cvp"][1][0]["normal"] = {0, 0, 1};
      document["fusions"].push_back({{"part", 9}});
      entries["document.json"] = document.dump();
      entries["meshes/9.mesh"] = "another program's";
      entries["undo/history"] = std::string(5000, 'u');
    });
    Project project = parse(bytes)->project;
    // Also when the document is edited meanwhile.
    project.document.inputs.fcf = FCF::preset(FCF::Preset::Half);
    project.document.base = asset("new.ply", shapes::icosphere(1));
    project.document.inputs.base = project.document.base->mesh;
    project.document.inputs.loop.pop_back();
    const Entries again = entriesOf(bytesOf(project));
    QCOMPARE(again.at("meshes/9.mesh"), std::string("another program's"));
    QCOMPARE(again.at("undo/history"), std::string(5000, 'u'));
    const json document = json::parse(again.at("document.json"));
    QCOMPARE(document["format_version"].get<int>(), 3);
    QVERIFY(document["variants"] == json({{"new", {1.5, nullptr}}}));
    QCOMPARE(document["meshes"].size(), std::size_t{3});
    QVERIFY(document["meshes"][0]["colour"] == "red");
    QVERIFY(document["meshes"][0]["report"]["seconds"] == 2);
    QVERIFY2(!document["meshes"][1].contains("colour") && document["meshes"][1]["id"] == 3,
             "a new mesh never takes an old one's number");
    QVERIFY(document["meshes"][2] == json({{"id", 9}, {"entry", "meshes/9.mesh"}}));
    QVERIFY(document["fusions"][0]["title"] == "nose");
    QVERIFY(document["fusions"][0]["adjustment"]["lattice"] == json({1, 2}));
    QVERIFY(document["fusions"][0]["cvp"][1][0]["normal"] == json({0, 0, 1}));
    QVERIFY(document["fusions"][0]["fcf"].size() == FCF::preset(FCF::Preset::Half).points().size());
    QVERIFY(document["fusions"][1] == json({{"part", 9}}));
  }

  void aPointThatMovedLosesWhatWasSaidAboutIt() {
    Project project = parse(withDocument([](json& document) {
                        document["fusions"][0]["cvp"][1][0]["normal"] = 1;
                      }))->project;
    project.document.inputs.loop[1].part.face = 7;
    const json document = json::parse(entriesOf(bytesOf(project)).at("document.json"));
    QVERIFY(!document["fusions"][0]["cvp"][1][0].contains("normal"));
  }

  void aDamagedMeshCostsTheMesh_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("says");
    QTest::newRow("checksum") << "checksum"
                              << "CRC";
    QTest::newRow("missing") << "missing"
                             << "no such entry";
    QTest::newRow("another") << "another"
                             << "not the mesh that the project was saved with";
    QTest::newRow("no mesh") << "no mesh"
                             << "it is no mesh";
    QTest::newRow("empty") << "empty"
                           << "ends too early";
    QTest::newRow("short") << "short"
                           << "does not fit its 162 vertices";
    QTest::newRow("long") << "long"
                          << "does not fit its 162 vertices";
    QTest::newRow("greedy counts") << "greedy counts"
                                   << "does not fit its";
    QTest::newRow("vertex out of range") << "vertex out of range"
                                         << "does not name three different vertices";
    QTest::newRow("vertex negative") << "vertex negative"
                                     << "does not name three different vertices";
    QTest::newRow("face degenerate") << "face degenerate"
                                     << "does not name three different vertices";
    QTest::newRow("not a number") << "not a number"
                                  << "vertex 0 has a coordinate";
    QTest::newRow("record lost") << "record lost"
                                 << "no mesh number 1";
    QTest::newRow("record broken") << "record broken"
                                   << "\"entry\" must be";
  }
  void aDamagedMeshCostsTheMesh() {
    QFETCH(QString, kind);
    QFETCH(QString, says);
    constexpr std::size_t kPoints = 16;
    constexpr std::size_t kFaces = kPoints + 162 * 24;
    const auto put = [](std::string& mesh, std::size_t at, auto value) {
      std::memcpy(mesh.data() + at, &value, sizeof(value));
    };
    std::string bytes = withEntries([&](Entries& entries) {
      json document = json::parse(entries.at("document.json"));
      std::string& mesh = entries.at("meshes/1.mesh");
      const std::map<QString, std::function<void()>> damages = {
          {"checksum", [] {}},
          {"missing", [&] { entries.erase("meshes/1.mesh"); }},
          {"another", [&] { put(mesh, kPoints, 0.125); }},
          {"no mesh", [&] { mesh[0] = 'x'; }},
          {"empty", [&] { mesh.clear(); }},
          {"short", [&] { mesh.pop_back(); }},
          {"long", [&] { mesh += "more"; }},
          {"greedy counts", [&] { put(mesh, 8, std::int32_t{0x7fffffff}); }},
          {"vertex out of range", [&] { put(mesh, kFaces + 4, std::int32_t{162}); }},
          {"vertex negative", [&] { put(mesh, kFaces, std::int32_t{-1}); }},
          {"face degenerate", [&] { std::memcpy(mesh.data() + kFaces, mesh.data() + kFaces + 4, 4); }},
          {"not a number", [&] { put(mesh, kPoints, std::nan("")); }},
          {"record lost", [&] { document["meshes"].erase(0); }},
          {"record broken", [&] { document["meshes"][0]["entry"] = 5; }}};
      damages.at(kind)();
      entries["document.json"] = document.dump();
    });
    if (kind == "checksum") {
      bytes = bytesOf(fullProject());
      bytes[bytes.find("grafmesh") + 1000] ^= 1;
    }
    const LoadedProject loaded = openDamaged(bytes, says.toStdString());
    QVERIFY(!loaded.fusionIntact);
    QVERIFY(loaded.damage[0].side == Side::Part);
    const Document& document = loaded.project.document;
    QVERIFY(!document.part && !document.inputs.part);
    verifySameAsset(document.base, fullProject().document.base);
    QVERIFY(sameEdits(fullProject().document, document));
    QCOMPARE(loaded.project.thumbnail, fullProject().thumbnail);
    // What was lost is no hindrance to saving.
    QVERIFY(parse(bytesOf(loaded.project))->damage.empty());
  }

  void theMessageOfALostMeshSaysWhereToFindItAgain() {
    openDamaged(withEntries([](Entries& entries) { entries.erase("meshes/2.mesh"); }),
                "The base's mesh \"ring.ply\" (meshes/2.mesh) is damaged and was left out: the file has no "
                "such entry. Load it again: it was read from /models/ring.ply.");
  }

  void otherDamagedEntriesCostNoMoreThanThemselves_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("says");
    QTest::newRow("picture") << QByteArray("picture") << "small picture";
    QTest::newRow("unknown") << QByteArray("secret") << "\"notes.txt\"";
  }
  void otherDamagedEntriesCostNoMoreThanThemselves() {
    QFETCH(QByteArray, content);
    QFETCH(QString, says);
    Project project = fullProject();
    auto entries = entriesOf(bytesOf(project));
    ZipWriter zip;
    entries["notes.txt"] = "secret";
    for (const auto& [name, bytes] : entries) {
      QVERIFY(zip.add(name, {bytes}, ZipWriter::Packing::Stored));
    }
    QVERIFY(zip.write(path(), {}));
    std::string bytes = readAll(path());
    bytes[bytes.find(content.toStdString())] ^= 1;
    const LoadedProject loaded = openDamaged(bytes, says.toStdString());
    QVERIFY(loaded.fusionIntact);
    QVERIFY(sameEdits(project.document, loaded.project.document));
  }

  void anEntryThatClaimsToBeHugeIsDamage() {
    std::string bytes = bytesOf(fullProject());
    // The unpacked size in the directory's record of the entry, 46 bytes before the end of its name.
    const std::size_t record = bytes.rfind("thumbnail.png") - 46;
    QCOMPARE(bytes.substr(record, 4), std::string("PK\1\2"));
    bytes[record + 27] = 0x7f;
    openDamaged(bytes, "more than a file of this size can");
  }

  void anEntryThatIsLongerThanItsSizeIsDamage() {
    std::string bytes = withEntries([](Entries& entries) { entries["notes.txt"] = std::string(300, 'n'); });
    const std::size_t record = bytes.rfind("notes.txt") - 46;
    bytes[record + 24] = 10;
    bytes[record + 25] = 0;
    const LoadedProject loaded = openDamaged(bytes, "\"notes.txt\"");
    QVERIFY(loaded.fusionIntact);
  }

  void aSettingThatCannotBeUnderstoodBecomesItsDefault_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QByteArray>("value");
    QTest::newRow("curve too short") << "fcf" << QByteArray("[[0, 0], [1, 1]]");
    QTest::newRow("curve illegal") << "fcf" << QByteArray("[[0, 0], [0.5, 2], [0.6, 0], [1, 1]]");
    QTest::newRow("monotone") << "monotone" << QByteArray("5");
    QTest::newRow("falloff") << "deform_exponent" << QByteArray("-1");
    QTest::newRow("paths") << "paths" << QByteArray("\"magic\"");
    QTest::newRow("large tile") << "allow_large_tile" << QByteArray("null");
    QTest::newRow("adjustment") << "adjustment" << QByteArray(R"({"rigid": false, "epsilon": -1})");
    QTest::newRow("embedding") << "embedding" << QByteArray("[]");
    QTest::newRow("closed") << "closed" << QByteArray("\"yes\"");
    QTest::newRow("loop") << "cvp" << QByteArray("[[1, 2], [3]]");
  }
  void aSettingThatCannotBeUnderstoodBecomesItsDefault() {
    QFETCH(QString, key);
    QFETCH(QByteArray, value);
    const std::string bytes = withDocument([&](json& document) {
      document["fusions"][0][key.toStdString()] = json::parse(value.toStdString());
    });
    const LoadedProject loaded = openDamaged(bytes, "\"" + key.toStdString());
    QVERIFY(!loaded.fusionIntact);
    Document expected = fullProject().document;
    const FusionInputs defaults;
    FusionInputs& inputs = expected.inputs;
    const double falloff = inputs.adjustment.falloff;
    if (key == "fcf") {
      inputs.fcf = defaults.fcf;
    } else if (key == "monotone") {
      inputs.fcf = FCF::through(inputs.fcf.points(), true).value();
    } else if (key == "deform_exponent") {
      inputs.adjustment.falloff = defaults.adjustment.falloff;
    } else if (key == "paths") {
      inputs.paths = defaults.paths;
    } else if (key == "allow_large_tile") {
      inputs.tile = defaults.tile;
    } else if (key == "adjustment") {
      inputs.adjustment = defaults.adjustment;
      inputs.adjustment.falloff = falloff;
    } else if (key == "embedding") {
      inputs.embedding = defaults.embedding;
    } else if (key == "cvp") {
      inputs.loop.clear();
    }
    expected.closed = key != "closed" && key != "cvp";
    QVERIFY(sameEdits(expected, loaded.project.document));
  }

  void pairsThatTheMeshesDoNotHaveAreLeftOut() {
    const LoadedProject loaded = openDamaged(withDocument([](json& document) {
                                               document["fusions"][0]["cvp"][0][0] = 162;
                                               document["fusions"][0]["cvp"][2][1]["face"] = 216;
                                             }),
                                             "left out: 0, 2.");
    QVERIFY(loaded.damage[0].code == ErrorCode::LoopIndexOutOfRange);
    QCOMPARE(loaded.damage[0].cvs, (std::vector<int>{0, 2}));
    const Loop whole = fullProject().document.inputs.loop;
    QVERIFY((loaded.project.document.inputs.loop == Loop{whole[1], whole[3]}));
    QVERIFY(!loaded.project.document.closed);
  }

  void aNewerFormatIsRefusedPolitely() {
    const std::string version = withDocument([](json& document) {
      document["minimum_reader_version"] = 2;
      document["written_by"] = "Graftsman 7.1";
    });
    verifyRefused(version, ErrorCode::ProjectTooNew, "its format is 2, and this program reads 1");
    verifyRefused(version, ErrorCode::ProjectTooNew, "It was saved by Graftsman 7.1");
    verifyRefused(withDocument([](json& document) { document["required_features"] = {"lattice"}; }),
                  ErrorCode::ProjectTooNew, "it uses \"lattice\"");
  }

  void whatIsNoProjectIsRefused() {
    verifyRefused("", ErrorCode::FileMalformed, "no Graftsman project");
    verifyRefused("{\"m1\": \"a.obj\"}", ErrorCode::FileMalformed, "no Graftsman project");
    verifyRefused(zipOf({{"a.txt", "text"}}), ErrorCode::FileMalformed, "it has no document.json");
    verifyRefused(zipOf({{"document.json", "{\"a\": "}}), ErrorCode::FileMalformed, "line 1");
    verifyRefused(zipOf({{"document.json", "[]"}}), ErrorCode::FileMalformed, "no JSON object");
    verifyRefused(zipOf({{"document.json", "{}"}}), ErrorCode::FileMalformed, "\"minimum_reader_version\"");
    for (const char* key : {"format_version", "required_features", "meshes", "fusions"}) {
      verifyRefused(withDocument([&](json& document) { document.erase(key); }), ErrorCode::FileMalformed,
                    key);
      verifyRefused(withDocument([&](json& document) { document[key] = "x"; }), ErrorCode::FileMalformed,
                    key);
    }
    std::string bytes = bytesOf(fullProject());
    bytes[bytes.find("document.json") + 20] ^= 1;
    verifyRefused(bytes, ErrorCode::FileMalformed, "document.json is damaged");
  }

  void aFileThatIsCutOffAnywhereIsRefusedOrToldAsDamaged() {
    const std::string bytes = bytesOf(fullProject());
    for (std::size_t size = 0; size < bytes.size(); size += 97) {
      const Result<LoadedProject> loaded = parse(bytes.substr(0, size));
      QVERIFY(loaded ? !loaded->damage.empty() : loaded.error().code == ErrorCode::FileMalformed);
    }
  }

  void aMissingFileAndAFolderAreUnreadable() {
    QVERIFY(readProject(path("nowhere.graft"), {}).error().code == ErrorCode::FileUnreadable);
    QVERIFY(readProject(path(""), {}).error().code == ErrorCode::FileUnreadable);
    QVERIFY(writeProject("/nowhere/a.graft", fullProject(), {}).error().code == ErrorCode::FileUnwritable);
  }

  void cancellingLeavesTheOldFile() {
    const std::string before = bytesOf(fullProject());
    Project large = fullProject();
    large.document.base = asset("large", shapes::icosphere(6));
    for (const double from : {0.0, 0.5, 0.8}) {
      const Progress progress([&](double done) { return done < from; }, std::chrono::seconds(0));
      const Result<void> written = writeProject(path(), large, progress);
      QVERIFY(!written && written.error().code == ErrorCode::Cancelled);
      QVERIFY(readAll(path()) == before);
    }
    QCOMPARE(QDir(folder_.path()).entryList({"*.part"}).size(), 0);
    QVERIFY(writeProject(path(), large, {}));
    for (const double from : {0.0, 0.4, 0.8}) {
      const Progress progress([&](double done) { return done < from; }, std::chrono::seconds(0));
      const Result<LoadedProject> loaded = readProject(path(), progress);
      QVERIFY(!loaded && loaded.error().code == ErrorCode::Cancelled);
    }
  }

  void progressRisesToItsEnd() {
    std::vector<double> told;
    const Progress progress([&](double done) { return told.push_back(done), true; }, std::chrono::seconds(0));
    QVERIFY(writeProject(path(), fullProject(), progress));
    QVERIFY(told.size() > 2 && told.back() > 0.9 && std::is_sorted(told.begin(), told.end()));
    told.clear();
    QVERIFY(readProject(path(), progress.span(0, 1)));
    QVERIFY(told.size() > 2);
  }
};

QTEST_GUILESS_MAIN(ProjectFileTest)
#include "project_file_test.moc"
