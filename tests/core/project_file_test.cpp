#include "core/project/project_file.h"

#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/project_bytes.h"
#include "tests/support/samples.h"

using namespace graftsman;
using namespace graftsman::projects;
using nlohmann::json;
namespace fs = std::filesystem;

class ProjectFileTest : public QObject {
  Q_OBJECT

 private:
  [[nodiscard]] fs::path path(const std::string& name = "a.graft") const {
    return fs::path(folder_.path().toStdString()) / name;
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

  void aMissingFileAndAFolderAreUnreadable() {
    QVERIFY(readProject(path("nowhere.graft"), {}).error().code == ErrorCode::FileUnreadable);
    QVERIFY(readProject(path(""), {}).error().code == ErrorCode::FileUnreadable);
    QVERIFY(writeProject("/nowhere/a.graft", fullProject(), {}).error().code == ErrorCode::FileUnwritable);
  }

  void cancellingLeavesTheOldFile() {
    const Project old = fullProject();
    QVERIFY(writeProject(path(), old, {}));
    const std::string before = readAll(path());
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
