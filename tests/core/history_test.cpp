#include "core/project/history.h"

#include <QtTest>

#include "core/project/document_edits.h"
#include "core/project/edits.h"
#include "tests/support/project_bytes.h"

using namespace graftsman;
using namespace graftsman::projects;
using nlohmann::json;

namespace {

// Edits the project's document and keeps the step.
void edit(Project& project, Document after, const std::string& text, std::optional<int> cv = {}) {
  History& history = project.history;
  const auto present = static_cast<std::size_t>(history.index);
  history.steps.resize(present);
  history.states.resize(present);
  history.states.push_back(project.document);
  history.steps.push_back({text, project.shown, project.shown, cv, {}});
  history.states.push_back(after);
  ++history.index;
  project.document = std::move(after);
}

void edit(Project& project, const std::string& text, const std::function<void(Fusion&)>& change,
          std::optional<int> cv = {}) {
  Fusion fusion = *find(project.document.fusions, 1);
  change(fusion);
  edit(project, edits::withFusion(project.document, fusion), text, cv);
}

// Undoes or redoes to the state.
void go(Project& project, int state) {
  project.history.index = state;
  project.document = project.history.states[static_cast<std::size_t>(state)];
}

void setCurve(Fusion& fusion, double f) {
  fusion.inputs.fcf = FCF::through({{0, 0}, {0.25, f}, {0.5, f}, {1, 1}}).value();
}

// A project that was edited in every way, two steps undone.
Project editedProject() {
  Project project = fullProject();
  edit(project, "Move curve point 1", [](Fusion& fusion) { setCurve(fusion, 0.1 + 0.2); });
  edit(
      project, "Move CV 2 on the base",
      [](Fusion& fusion) {
        fusion.inputs.loop[2].base.bary = {0, 0.1, 0.9};
      },
      2);
  edit(project, "Load cup.ply as the base", [](Fusion& fusion) {
    setAsset(fusion, Side::Base, asset("cup.ply", shapes::icosphere(3)));
    fusion.inputs.loop.clear();
    fusion.closed = false;
  });
  edit(project, edits::addVariant(project.document, 1, "“First”"), "Keep as a variant");
  edit(project, edits::addFusion(project.document, project.document.fusions[0]->part, nullptr), "Add");
  edit(project, edits::takeResult(project.document, 2, Side::Base, 1).value(), "Take the result");
  edit(project, edits::renameFusion(project.document, 1, "Nose"), "Rename");
  go(project, 5);
  return project;
}

bool sameFusions(const FusionList& a, const FusionList& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    for (const Side side : {Side::Part, Side::Base}) {
      const auto& p = x->of(side);
      const auto& q = y->of(side);
      if (static_cast<bool>(p) != static_cast<bool>(q) || x->upstream(side) != y->upstream(side) ||
          (p && p->mesh && !sameMesh(p->mesh, q->mesh))) {
        return false;
      }
    }
    return sameEdits(*x, *y);
  });
}

// Equal, but for the meshes' addresses.
bool sameState(const Document& a, const Document& b) {
  return sameFusions(a.fusions, b.fusions) &&
         std::equal(a.variants.begin(), a.variants.end(), b.variants.begin(), b.variants.end(),
                    [](const auto& x, const auto& y) {
                      return x->id == y->id && x->name == y->name && x->note == y->note &&
                             x->starred == y->starred && x->shown == y->shown &&
                             sameFusions(x->fusions, y->fusions);
                    });
}

std::size_t meshCount(const Entries& entries) {
  return static_cast<std::size_t>(
      std::ranges::count_if(entries, [](const auto& entry) { return entry.first.starts_with("meshes/"); }));
}

std::string withHistory(const std::function<void(json&)>& change) {
  Entries entries = entriesOf(bytesOf(editedProject()));
  json history = json::parse(entries.at("history.json"));
  change(history);
  entries["history.json"] = history.dump();
  return zipOf(entries);
}

// The document is whole, the history is gone, and it is said why.
void verifyHistoryLost(const std::string& bytes, const std::string& says) {
  const Result<LoadedProject> loaded = parse(bytes);
  QVERIFY(loaded);
  QCOMPARE(loaded->damage.size(), std::size_t{1});
  const std::string& message = loaded->damage[0].message;
  QVERIFY2(message.starts_with("The undo history (history.json) was left out: "), message.c_str());
  QVERIFY2(message.find(says) != std::string::npos, message.c_str());
  QVERIFY(loaded->fusionIntact);
  QVERIFY(loaded->project.history.steps.empty() && loaded->project.history.states.empty());
  QVERIFY(sameState(loaded->project.document, editedProject().document));
  const Entries again = entriesOf(bytesOf(loaded->project));
  QVERIFY(!again.contains("history.json"));
  QCOMPARE(meshCount(again), std::size_t{2});
}

}  // namespace

class HistoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aHistoryIsReadAsItWasWritten() {
    const Project project = editedProject();
    const std::string bytes = bytesOf(project);
    const Result<LoadedProject> loaded = parse(bytes);
    QVERIFY2(loaded && loaded->damage.empty(),
             loaded && !loaded->damage.empty() ? loaded->damage[0].message.c_str() : "");
    const History& read = loaded->project.history;
    QVERIFY(read.steps == project.history.steps);
    QCOMPARE(read.index, 5);
    QCOMPARE(read.states.size(), project.history.states.size());
    for (std::size_t i = 0; i < read.states.size(); ++i) {
      QVERIFY2(sameState(read.states[i], project.history.states[i]), std::to_string(i).c_str());
    }
    QVERIFY(read.states[5] == loaded->project.document);
    QVERIFY2(bytesOf(loaded->project) == bytes, "nor does reading and writing change it");
    QCOMPARE(read.states[6].fusions[1]->base->name, std::string("Ball on ring"));
  }

  void statesShareWhatIsEqual() {
    const Project project = parse(bytesOf(editedProject()))->project;
    const History& history = project.history;
    QCOMPARE(history.states[5].fusions[0], project.document.fusions[0]);
    QCOMPARE(history.states[4].fusions[0], project.document.fusions[0]);
    QCOMPARE(history.states[4].variants[0], project.document.variants[0]);
    QCOMPARE(history.states[3].fusions[0], history.states[4].fusions[0]);
    QCOMPARE(history.states[0].fusions[0]->part, project.document.fusions[0]->part);
  }

  void coordinatesKeepTheirBits() {
    Project project = fullProject();
    const double least = 5e-324;
    edit(project, "a", [&](Fusion& fusion) {
      fusion.inputs.loop[1].part.bary = {least, 1.0 / 3, 2.0 / 3};
      fusion.inputs.adjustment.falloff = 1.7976931348623157e308;
    });
    edit(project, "b", [](Fusion& fusion) { fusion.inputs.loop.clear(); });
    const History read = parse(bytesOf(project))->project.history;
    QCOMPARE(read.states[1].fusions[0]->inputs.loop[1].part.bary, Eigen::Vector3d(least, 1.0 / 3, 2.0 / 3));
    QCOMPARE(read.states[1].fusions[0]->inputs.adjustment.falloff, 1.7976931348623157e308);
  }

  void undoneAndNotUndoneStepsAreKept() {
    for (const int state : {0, 3, 7}) {
      Project project = editedProject();
      go(project, state);
      const Result<LoadedProject> loaded = parse(bytesOf(project));
      QVERIFY(loaded && loaded->damage.empty());
      QCOMPARE(loaded->project.history.index, state);
      QCOMPARE(loaded->project.history.steps.size(), std::size_t{7});
    }
  }

  void equalStatesAreWrittenOnce() {
    Project project = fullProject();
    setAsset(fusionOf(project), Side::Base, asset("large", shapes::torus(250, 200)));
    fusionOf(project).inputs.loop.clear();
    QCOMPARE(fusionOf(project).inputs.base->faceCount(), 100'000);
    const std::size_t before = bytesOf(project).size();
    for (int i = 0; i < 500; ++i) {
      edit(project, "Move curve point 1", [i](Fusion& fusion) { setCurve(fusion, i / 1000.0); });
    }
    QVERIFY(bytesOf(project).size() < before + 1'000'000);
    // To and fro between two states.
    for (int i = 0; i < 400; ++i) {
      edit(project, "Move curve point 1", [i](Fusion& fusion) { setCurve(fusion, i % 2 / 1000.0); });
    }
    const json history = json::parse(entriesOf(bytesOf(project)).at("history.json"));
    QCOMPARE(history["steps"].size(), std::size_t{900});
    QCOMPARE(history["fusions"].size(), std::size_t{501});
  }

  void aMeshThatOnlyTheHistoryNeedsStaysAsLongAsTheHistory() {
    Project project = editedProject();
    const Entries entries = entriesOf(bytesOf(project));
    QCOMPARE(meshCount(entries), std::size_t{3});
    const json meshes = json::parse(entries.at("document.json"))["meshes"];
    QVERIFY(meshes[0]["history_only"] == false && meshes[2]["history_only"] == true);
    QCOMPARE(meshes[2]["name"].get<std::string>(), std::string("ring.ply"));
    Project read = parse(bytesOf(project))->project;
    read.history = {};
    QCOMPARE(meshCount(entriesOf(bytesOf(read))), std::size_t{2});
    // Undone to where it is the document's again.
    read = parse(bytesOf(project))->project;
    go(read, 0);
    const Result<LoadedProject> undone = parse(bytesOf(read));
    QVERIFY(undone && undone->damage.empty());
    verifySameAsset(undone->project.document.fusions[0]->base, fusionOf(fullProject()).base);
  }

  void theOldestStepsBeyondTheBoundAreLeftOut() {
    Project project = fullProject();
    for (int i = 0; i < 1200; ++i) {
      edit(project, std::to_string(i), [i](Fusion& fusion) { setCurve(fusion, i / 2000.0); });
    }
    const std::vector<Document> states = project.history.states;
    go(project, 1100);
    History kept = parse(bytesOf(project))->project.history;
    QCOMPARE(kept.steps.size(), std::size_t{1000});
    QCOMPARE(kept.steps.front().text, std::string("200"));
    QCOMPARE(kept.index, 900);
    QVERIFY(sameState(kept.states.front(), states[200]) && sameState(kept.states.back(), states[1200]));
    // So far back that what can be redone is too much by itself.
    go(project, 100);
    kept = parse(bytesOf(project))->project.history;
    QCOMPARE(kept.index, 0);
    QCOMPARE(kept.steps.back().text, std::string("1099"));
    QVERIFY(sameState(kept.states.front(), states[100]) && sameState(kept.states.back(), states[1100]));
  }

  void theTextHasABound() {
    Project project = fullProject();
    for (int i = 0; i < 60; ++i) {
      const std::string name = std::to_string(i) + std::string(100'000, 'n');
      edit(project, std::to_string(i), [&](Fusion& fusion) { fusion.name = name; });
    }
    const std::string bytes = bytesOf(project);
    QVERIFY(entriesOf(bytes).at("history.json").size() <= history_bounds::kMostBytes);
    const Result<LoadedProject> loaded = parse(bytes);
    QVERIFY(loaded && loaded->damage.empty());
    const History& kept = loaded->project.history;
    QCOMPARE(kept.steps.size(), std::size_t{40});
    QCOMPARE(kept.steps.front().text, std::string("20"));
    QVERIFY(sameState(kept.states.front(), project.history.states[20]));
    // Not even one step.
    const std::string huge(5'000'000, 'n');
    edit(project, "huge", [&](Fusion& fusion) { fusion.name = huge; });
    edit(project, "small", [&](Fusion& fusion) { fusion.name = "small"; });
    QVERIFY(!entriesOf(bytesOf(project)).contains("history.json"));
  }

  void meshesThatOnlyTheHistoryNeedsHaveABound() {
    Project project = fullProject();
    const shapes::MeshPtr ball = shapes::icosphere(7);
    const std::size_t size = ball->points().size() * sizeof(Point) + ball->faces().size() * sizeof(Face);
    const std::size_t room = history_bounds::kMostMeshBytes / size;
    const std::size_t steps = room + 3;
    for (std::size_t i = 0; i < steps; ++i) {
      edit(project, std::to_string(i), [&](Fusion& fusion) {
        setAsset(fusion, Side::Base, asset("ball", std::make_shared<TriangleMesh>(*ball)));
        fusion.inputs.loop.clear();
      });
    }
    const std::string bytes = bytesOf(project);
    QCOMPARE(meshCount(entriesOf(bytes)), 2 + room);
    QCOMPARE(parse(bytes)->project.history.steps.size(), room);
  }

  void aHistoryOfAnotherStateIsNotWritten() {
    Project project = editedProject();
    project.document = edits::renameFusion(project.document, 1, "behind its back");
    QVERIFY(!entriesOf(bytesOf(project)).contains("history.json"));
  }

  void damageCostsTheHistoryAlone_data() {
    QTest::addColumn<QByteArray>("patch");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const json& patch, const char* says) {
      QTest::newRow(name) << QByteArray::fromStdString(patch.dump()) << says;
    };
    const auto replace = [](const char* path, const json& value) {
      return json::array({{{"op", "replace"}, {"path", path}, {"value", value}}});
    };
    row("no object", replace("", {1, 2}), "no list \"states\"");
    row("no list", replace("/steps", 7), "no list \"steps\"");
    row("counts", replace("/steps", json::array()), "numbers of steps and of states");
    row("index", replace("/index", 8), "which state is the present one");
    row("negative index", replace("/index", -1), "which state is the present one");
    row("another state", replace("/index", 4), "no list \"variants\"");
    row("fusion", replace("/fusions/1", "nose"), "a fusion in it is no object");
    row("fusion's number", replace("/fusions/1/id", 0), "a fusion in it has no number");
    row("fusion's setting", replace("/fusions/1/paths", "zigzag"), "cannot be understood");
    row("fusion's curve", replace("/fusions/2/fcf", json::array()), "cannot be understood");
    row("vertex", replace("/fusions/4/cvp/0/0", 5000), "cannot be understood");
    row("mesh", replace("/fusions/4/base", 77), "a mesh that it needs");
    row("unknown fusion", replace("/states/5/fusions", {0, 99}), "names a fusion");
    row("fusion twice", replace("/states/5/fusions", {0, 0}), "do not fit together");
    row("no fusion", replace("/states/5/fusions", json::array()), "do not fit together");
    row("circle", replace("/fusions/0/base", {{"result", 1}}), "do not fit together");
    row("source", replace("/fusions/0/base", {{"result", 5}}), "do not fit together");
    row("unknown variant", replace("/states/5/variants", {3}), "names a variant");
    row("variant", replace("/variants/0", 3), "no list \"fusions\"");
    row("variant's number", replace("/variants/0/id", "one"), "a variant in it has no number");
    row("variant twice", replace("/states/5/variants", {0, 0}), "two variants of one number");
    row("state", replace("/states/2", 3), "a state in it is no object");
    row("step", replace("/steps/2", 3), "a step in it is no object");
    row("shown", replace("/steps/2/shown", 3), "which fusions were shown");
    row("touched", replace("/steps/1/cv", -3), "\"cv\" must be");
    row("mismatch", replace("/fusions/0/name", "another"), "not the document that the project holds");
  }
  void damageCostsTheHistoryAlone() {
    QFETCH(QByteArray, patch);
    QFETCH(QString, says);
    verifyHistoryLost(
        withHistory([&](json& history) { history = history.patch(json::parse(patch.toStdString())); }),
        says.toStdString());
  }

  void bytesThatAreNoHistoryCostItAlone() {
    Entries entries = entriesOf(bytesOf(editedProject()));
    entries["history.json"] = "{\"steps\": [";
    verifyHistoryLost(zipOf(entries), "not valid JSON");
    entries["history.json"] = std::string(history_bounds::kMostBytes + 1, ' ');
    verifyHistoryLost(zipOf(entries), "larger than this program keeps");
    entries = entriesOf(bytesOf(editedProject()));
    std::string bytes = zipOf(entries, ZipWriter::Packing::Stored);
    bytes[bytes.find("Keep as a variant")] = 'k';
    verifyHistoryLost(bytes, "CRC");
  }

  void aDamagedMeshOfTheHistoryCostsTheHistory() {
    Entries entries = entriesOf(bytesOf(editedProject()));
    QVERIFY(entries.contains("meshes/3.mesh"));
    entries["meshes/3.mesh"] = "nothing";
    verifyHistoryLost(zipOf(entries), "a mesh that it needs");
  }

  void moreThanFitsIntoMemoryIsRefused() {
    // A state costs nothing in the file if it is like its neighbour.
    Project project = fullProject();
    for (int i = 0; i < 3000; ++i) {
      project.document.variants.push_back(std::make_shared<const Variant>(
          Variant{i + 1, "v", "", false, 1, {project.document.fusions.front()}}));
    }
    for (int i = 0; i < 1000; ++i) {
      edit(project, "e", [i](Fusion& fusion) { setCurve(fusion, i / 2000.0); });
    }
    const History kept = parse(bytesOf(project))->project.history;
    QVERIFY2(kept.steps.size() > 500 && kept.steps.size() < 700, "two million variants listed");
  }

  void whatANewerVersionAddedSurvives() {
    const Project read = parse(withHistory([](json& history) { history["people"] = {1, "two"}; }))->project;
    QCOMPARE(read.history.steps.size(), std::size_t{7});
    Project edited = read;
    edit(edited, edits::renameFusion(edited.document, 1, "later"), "Rename");
    QVERIFY(json::parse(entriesOf(bytesOf(edited)).at("history.json"))["people"] == json({1, "two"}));
    QCOMPARE(parse(bytesOf(edited))->project.history.steps.size(), std::size_t{6});
  }

  void aHistoryOfANewerFormatIsKeptUntilThereIsAnother() {
    Entries entries = entriesOf(bytesOf(editedProject()));
    entries["history.json"] = R"({"format": 2, "deeds": []})";
    const Result<LoadedProject> loaded = parse(zipOf(entries));
    QVERIFY(loaded && loaded->damage.empty() && loaded->project.history.steps.empty());
    Project project = loaded->project;
    QCOMPARE(entriesOf(bytesOf(project)).at("history.json"), entries["history.json"]);
    QCOMPARE(meshCount(entriesOf(bytesOf(project))), std::size_t{3});
    edit(project, edits::renameFusion(project.document, 1, "later"), "Rename");
    QCOMPARE(parse(bytesOf(project))->project.history.steps.size(), std::size_t{1});
  }

  void whoWantsResultsReadsNoHistory() {
    Entries entries = entriesOf(bytesOf(editedProject()));
    entries["history.json"] = "{";
    const Result<LoadedProject> loaded = parseProject(zipOf(entries), "a.graft", {}, Wanted::Results);
    QVERIFY(loaded && loaded->damage.empty() && loaded->project.history.steps.empty());
    QVERIFY(sameState(loaded->project.document, editedProject().document));
  }
};

QTEST_GUILESS_MAIN(HistoryTest)
#include "history_test.moc"
