#include "core/project/project_file.h"

#include <QTemporaryDir>
#include <QtTest>

#include "core/project/document_edits.h"
#include "tests/support/project_bytes.h"
#include "tests/support/samples.h"
#include "tests/support/stacked.h"

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
    const Fusion& document = fusionOf(loaded->project);
    QVERIFY(sameEdits(project, loaded->project));
    verifySameAsset(document.part, fusionOf(project).part);
    verifySameAsset(document.base, fusionOf(project).base);
    QVERIFY(document.inputs.part == document.part->mesh && document.inputs.base == document.base->mesh);
    QCOMPARE(loaded->project.thumbnail, project.thumbnail);
    QCOMPARE(loaded->project.viewState, project.viewState);
  }

  void everySampleIsReadAsItWasWrittenAndFusesAlike() {
    for (const std::string name : {"fig4a_cone_sphere", "fig9a_cars"}) {
      Project project;
      fusionOf(project).inputs = samples::load(name);
      fusionOf(project).part = asset("part", fusionOf(project).inputs.part);
      fusionOf(project).base = asset("base", fusionOf(project).inputs.base);
      fusionOf(project).closed = true;
      const LoadedProject loaded = parse(bytesOf(project)).value();
      QVERIFY(sameEdits(project, loaded.project));
      const FusionResults before = update(fusionOf(project).inputs, {}, {});
      const FusionResults after = update(fusionOf(loaded.project).inputs, {}, {});
      QVERIFY(before.fused && after.fused);
      QCOMPARE(after.fused->points, before.fused->points);
      QCOMPARE(after.fused->faces(), before.fused->faces());
    }
  }

  void anEmptyDocumentAndAnOpenLoopAreReadAsTheyWereWritten() {
    QVERIFY(parse(bytesOf({}))->project.document == Document());
    QVERIFY(parse(bytesOf({}))->project.thumbnail.empty());
    Project project = fullProject();
    fusionOf(project).closed = false;
    fusionOf(project).base = nullptr;
    fusionOf(project).inputs.base = nullptr;
    const LoadedProject loaded = parse(bytesOf(project)).value();
    QVERIFY(loaded.damage.empty());
    QVERIFY(!fusionOf(loaded.project).base && !fusionOf(loaded.project).closed);
    QVERIFY(sameEdits(project, loaded.project));
  }

  void coordinatesKeepTheirBits() {
    Project project;
    const std::vector<Point> points = {{-0.0, 5e-324, 1.7976931348623157e308}, {0.1, 1, 0}, {0, 1e-300, 1}};
    fusionOf(project).part =
        asset("tiny", std::make_shared<TriangleMesh>(points, std::vector<Face>{{0, 1, 2}}));
    fusionOf(project).inputs.part = fusionOf(project).part->mesh;
    const LoadedProject loaded = parse(bytesOf(project)).value();
    QVERIFY(sameMesh(fusionOf(loaded.project).part->mesh, fusionOf(project).part->mesh));
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
    fusionOf(project).base = fusionOf(project).part;
    fusionOf(project).inputs.base = fusionOf(project).inputs.part;
    fusionOf(project).inputs.loop.clear();
    QCOMPARE(entriesOf(bytesOf(project)).size(), std::size_t{5});
    LoadedProject loaded = parse(bytesOf(project)).value();
    QVERIFY(fusionOf(loaded.project).part && fusionOf(loaded.project).part == fusionOf(loaded.project).base);
    // Under two names it still is one mesh.
    fusionOf(project).base = asset("other.ply", fusionOf(project).inputs.part);
    QCOMPARE(entriesOf(bytesOf(project)).size(), std::size_t{5});
    loaded = parse(bytesOf(project)).value();
    QCOMPARE(fusionOf(loaded.project).base->name, std::string("other.ply"));
    QVERIFY(fusionOf(loaded.project).inputs.part == fusionOf(loaded.project).inputs.base);
  }

  void fusionsOfFusionsAndVariantsComeBackAsTheyWere() {
    Project project;
    project.document = edits::addVariant(samples::twoConesOnASphere(), 2, "Both");
    Fusion changed = *find(project.document.fusions, 1);
    changed.inputs.fcf = FCF::preset(FCF::Preset::Half);
    project.document = edits::addVariant(edits::withFusion(project.document, changed), 1);
    Variant second = *project.document.variants[1];
    second.note = "with a “note”";
    second.starred = true;
    project.document = edits::withVariant(project.document, second);
    project.shown = 2;
    project.variantPictures = {{1, "one"}, {2, "two"}, {7, "of a variant that is gone"}};
    const std::string bytes = bytesOf(project);
    const Result<LoadedProject> loaded = parse(bytes);
    QVERIFY(loaded && loaded->damage.empty() && loaded->fusionIntact);
    const Project& read = loaded->project;
    QCOMPARE(read.shown, 2);
    QCOMPARE(read.variantPictures, (std::map<VariantId, std::string>{{1, "one"}, {2, "two"}}));
    const Entries again = entriesOf(bytesOf(read));
    const json difference =
        json::diff(json::parse(entriesOf(bytes).at("document.json")), json::parse(again.at("document.json")));
    QVERIFY2(difference.empty(), difference.dump(1).c_str());
    QVERIFY(again == entriesOf(bytes));
    QCOMPARE(read.document.variants[1]->note, second.note);
    QVERIFY(read.document.variants[1]->starred && !read.document.variants[0]->starred);
    // One copy of each mesh, whoever has it.
    QCOMPARE(std::ranges::count_if(entriesOf(bytes),
                                   [](const auto& entry) { return entry.first.starts_with("meshes/"); }),
             2);
    QCOMPARE(find(read.document.fusions, 1)->part, find(read.document.variants[0]->fusions, 2)->part);
    for (const FusionList* fusions : {&read.document.fusions, &read.document.variants[0]->fusions}) {
      const FusionList& written = fusions == &read.document.fusions ? project.document.fusions
                                                                    : project.document.variants[0]->fusions;
      Evaluated ours;
      Evaluated theirs;
      QVERIFY(evaluate(*fusions, 2, ours, {}).results.fused->points ==
              evaluate(written, 2, theirs, {}).results.fused->points);
    }
  }

  void whatThisVersionDoesNotKnowSurvives() {
    const std::string bytes = withEntries([](Entries& entries) {
      json document = json::parse(entries.at("document.json"));
      document["format_version"] = 3;
      document["gallery"] = {{"new", {1.5, nullptr}}};
      document["meshes"][0]["colour"] = "red";
      document["meshes"][0]["report"]["seconds"] = 2;
      document["meshes"].push_back({{"id", 9}, {"entry", "meshes/9.mesh"}});
      document["fusions"][0]["title"] = "nose";
      document["fusions"][0]["adjustment"]["lattice"] = {1, 2};
      document["fusions"][0]["cvp"][1][0]["normal"] = {0, 0, 1};
      entries["document.json"] = document.dump();
      entries["meshes/9.mesh"] = "another program's";
      entries["undo/history"] = std::string(5000, 'u');
    });
    Project project = parse(bytes)->project;
    // Also when the document is edited meanwhile.
    fusionOf(project).inputs.fcf = FCF::preset(FCF::Preset::Half);
    fusionOf(project).base = asset("new.ply", shapes::icosphere(1));
    fusionOf(project).inputs.base = fusionOf(project).base->mesh;
    fusionOf(project).inputs.loop.pop_back();
    const Entries again = entriesOf(bytesOf(project));
    QCOMPARE(again.at("meshes/9.mesh"), std::string("another program's"));
    QCOMPARE(again.at("undo/history"), std::string(5000, 'u'));
    const json document = json::parse(again.at("document.json"));
    QCOMPARE(document["format_version"].get<int>(), 3);
    QVERIFY(document["gallery"] == json({{"new", {1.5, nullptr}}}));
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
  }

  void aPointThatMovedLosesWhatWasSaidAboutIt() {
    Project project = parse(withDocument([](json& document) {
                        document["fusions"][0]["cvp"][1][0]["normal"] = 1;
                      }))->project;
    fusionOf(project).inputs.loop[1].part.face = 7;
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
    fusionOf(large).base = asset("large", shapes::icosphere(6));
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
