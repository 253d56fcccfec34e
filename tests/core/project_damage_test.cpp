#include <QtTest>
#include <cmath>

#include "tests/support/project_bytes.h"

using namespace graftsman;
using namespace graftsman::projects;
using nlohmann::json;

namespace {

// Opens the bytes; exactly one thing is damaged, and its message says what.
LoadedProject openDamaged(const std::string& bytes, const std::string& says) {
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

void verifyRefused(const std::string& bytes, ErrorCode code, const std::string& says) {
  const Result<LoadedProject> loaded = parse(bytes);
  QVERIFY(!loaded);
  QVERIFY2(loaded.error().code == code, loaded.error().message.c_str());
  QVERIFY2(loaded.error().message.starts_with("a.graft: "), loaded.error().message.c_str());
  QVERIFY2(loaded.error().message.find(says) != std::string::npos, loaded.error().message.c_str());
}

}  // namespace

class ProjectDamageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
    const Fusion& document = fusionOf(loaded.project);
    QVERIFY(!document.part && !document.inputs.part);
    verifySameAsset(document.base, fusionOf(fullProject()).base);
    QVERIFY(sameEdits(fullProject(), loaded.project));
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
    std::string bytes =
        withEntries([](Entries& entries) { entries["notes.txt"] = "secret"; }, ZipWriter::Packing::Stored);
    bytes[bytes.find(content.toStdString())] ^= 1;
    const LoadedProject loaded = openDamaged(bytes, says.toStdString());
    QVERIFY(loaded.fusionIntact);
    QVERIFY(sameEdits(fullProject(), loaded.project));
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
    Project project = fullProject();
    Fusion& expected = fusionOf(project);
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
    QVERIFY(sameEdits(project, loaded.project));
  }

  void aFusionOfItsOwnResultLosesThatSide() {
    const LoadedProject loaded = openDamaged(withDocument([](json& document) {
                                               document["fusions"][0]["base"] = {{"result", 1}};
                                               document["fusions"][0]["cvp"] = json::array();
                                             }),
                                             "missing or made of it");
    QVERIFY(!loaded.fusionIntact);
    QVERIFY(!fusionOf(loaded.project).base && fusionOf(loaded.project).part);
  }

  void aMeshThatVariantsAloneNeedStopsNoFusionAndIsToldOnce() {
    const Result<LoadedProject> loaded = parse(withDocument([](json& document) {
      json fusions = document["fusions"];
      for (json& fusion : fusions) {
        fusion["base"] = 77;
      }
      document["variants"] = {{{"id", 4}, {"fusions", fusions}}, {{"id", 5}, {"fusions", fusions}}};
    }));
    QVERIFY(loaded && loaded->fusionIntact);
    QCOMPARE(loaded->damage.size(), std::size_t{1});
    QVERIFY(loaded->damage[0].message.find("no mesh number 77") != std::string::npos);
    QCOMPARE(loaded->project.document.variants.size(), std::size_t{2});
  }

  void aDamagedVariantCostsItAlone() {
    const Result<LoadedProject> loaded = parse(withDocument([](json& document) {
      const json variant = {{"id", 4}, {"fusions", document["fusions"]}};
      document["variants"] = {7, variant, variant};
    }));
    QVERIFY(loaded && loaded->fusionIntact);
    QCOMPARE(loaded->damage.size(), std::size_t{2});
    QVERIFY(loaded->damage[0].message.find("Variant 1") != std::string::npos);
    QVERIFY(loaded->damage[1].message.find("number 4") != std::string::npos);
    QCOMPARE(loaded->project.document.variants.size(), std::size_t{1});
    QCOMPARE(loaded->project.document.variants[0]->name, std::string("Variant 4"));
  }

  void aNumberThatTwoFusionsHaveCostsTheSecond() {
    const LoadedProject loaded = openDamaged(
        withDocument([](json& document) { document["fusions"].push_back(document["fusions"][0]); }),
        "number 1");
    QCOMPARE(loaded.project.document.fusions.size(), std::size_t{1});
  }

  void pairsThatTheMeshesDoNotHaveAreLeftOut() {
    const LoadedProject loaded = openDamaged(withDocument([](json& document) {
                                               document["fusions"][0]["cvp"][0][0] = 162;
                                               document["fusions"][0]["cvp"][2][1]["face"] = 216;
                                             }),
                                             "left out: 0, 2.");
    QVERIFY(loaded.damage[0].code == ErrorCode::LoopIndexOutOfRange);
    QCOMPARE(loaded.damage[0].cvs, (std::vector<int>{0, 2}));
    const Loop whole = fusionOf(fullProject()).inputs.loop;
    QVERIFY((fusionOf(loaded.project).inputs.loop == Loop{whole[1], whole[3]}));
    QVERIFY(!fusionOf(loaded.project).closed);
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
};

QTEST_GUILESS_MAIN(ProjectDamageTest)
#include "project_damage_test.moc"
