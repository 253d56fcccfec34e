#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>
#include <set>

#include "core/base/parallel.h"
#include "core/io/mesh_file.h"
#include "core/sweep/sweep_folder.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"

using namespace graftsman;
namespace fs = std::filesystem;

namespace {

SweepCurve preset(FCF::Preset which) {
  return {std::string(name(which)), FCF::preset(which)};
}

// Two curves, two falloffs, three shifts on the small cone and sphere: twelve combinations.
Sweep smallSweep() {
  Sweep sweep;
  sweep.base = samples::load("fig4a_cone_sphere");
  sweep.curves = {preset(FCF::Preset::Paste), preset(FCF::Preset::KeepBaseSlope)};
  sweep.falloffs = {2, 5};
  sweep.shifts = {0, 1, -2};
  return sweep;
}

// A sweep of which half the combinations cannot fuse: two CVs of their part are the same.
Sweep halfBroken() {
  Sweep sweep;
  sweep.base = samples::load("fig4a_cone_sphere");
  Loop broken = sweep.base.loop;
  broken[1].part = broken[0].part;
  sweep.parts = {{"good", {}, nullptr, {}}, {"bad", "cone.stl", sweep.base.part, broken}};
  sweep.curves = {preset(FCF::Preset::Paste), preset(FCF::Preset::Half)};
  return sweep;
}

std::shared_ptr<const LoadedSweep> loaded(Sweep sweep, SweepOutput output = {}) {
  Result<LoadedSweep> result = loadSweep(std::move(sweep), std::move(output), false);
  if (!result) {
    qFatal("%s", result.error().message.c_str());
  }
  return std::make_shared<const LoadedSweep>(std::move(*result));
}

fs::path pathOf(const QTemporaryDir& dir) {
  return dir.path().toStdString();
}

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Every file of the folder with its content, but for the shares' tables.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("table-")) {
      result[name] = contentOf(entry.path());
    }
  }
  return result;
}

void runInto(const fs::path& folder, const std::shared_ptr<const LoadedSweep>& sweep,
             const SweepShare& share) {
  Result<SweepFolder> into = SweepFolder::open(folder, sweep, {});
  QVERIFY(into);
  SweepRun run({sweep, &sweep->sweep});
  for (const std::size_t combination : runOrder(sweep->sweep, share)) {
    QVERIFY(into->add(run.run(combination, {}), {}));
  }
  QVERIFY(into->writeTable(share));
}

std::vector<csv::Row> tableOf(const fs::path& folder) {
  return csv::parse(contentOf(folder / "table.csv"), "table.csv").value();
}

std::string cell(const std::vector<csv::Row>& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table[0].begin(), table[0].end(), column);
  return found == table[0].end() ? "no such column"
                                 : table[row][static_cast<std::size_t>(found - table[0].begin())];
}

}  // namespace

class SweepTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreadCount(0); }

  void theCountIsTheProductOfTheLists() {
    QCOMPARE(Sweep().count(), std::size_t{1});
    Sweep sweep = smallSweep();
    QCOMPARE(sweep.count(), std::size_t{12});
    sweep.monotone = {true, false};
    QCOMPARE(sweep.count(), std::size_t{24});
  }

  void aCombinationHasOneValueOfEachList() {
    const Sweep sweep = smallSweep();
    // Shifts slowest, curves fastest.
    const FusionInputs inputs = sweep.inputs(4 + 2 + 1);
    QCOMPARE(inputs.adjustment.falloff, 5.0);
    QVERIFY(inputs.fcf == FCF::preset(FCF::Preset::KeepBaseSlope));
    QVERIFY(inputs.loop[1].part == sweep.base.loop[0].part);
    QVERIFY(inputs.loop[1].base == sweep.base.loop[1].base);
    QVERIFY(sweep.inputs(8).loop[0].part == sweep.base.loop[2].part);
    QCOMPARE(sweep.name(7), std::string("keep-base-slope_falloff-5_shift-1"));
    QCOMPARE(sweep.name(8), std::string("paste_falloff-2_shift--2"));
  }

  void whatIsNotListedStaysAsTheBaseHasIt() {
    Sweep sweep;
    sweep.base = samples::load("fig4a_cone_sphere");
    sweep.base.adjustment.falloff = 3;
    sweep.base.embedding.method = EmbeddingSettings::Method::MeanValue;
    QCOMPARE(sweep.name(0), std::string("base"));
    sweep.adjustments = {{"rigid", {.scale = false, .lineField = false, .falloff = 9}}};
    const FusionInputs inputs = sweep.inputs(0);
    QVERIFY(!inputs.adjustment.scale && inputs.adjustment.rigid);
    QCOMPARE(inputs.adjustment.falloff, 3.0);
    QVERIFY(inputs.embedding == sweep.base.embedding && inputs.fcf == sweep.base.fcf);
    QVERIFY(inputs.part == sweep.base.part && inputs.base == sweep.base.base &&
            inputs.loop == sweep.base.loop);
  }

  void monotoneIsAppliedToEachCurve() {
    Sweep sweep = smallSweep();
    sweep.monotone = {false, true};
    for (std::size_t i = 0; i < sweep.count(); ++i) {
      const FCF fcf = sweep.inputs(i).fcf;
      QCOMPARE(fcf.monotone(), sweep.choice(i).monotone == 1);
      QVERIFY(fcf.points() == sweep.curves[sweep.choice(i).curve].curve.points());
    }
  }

  void namesAreAllDifferentAndCanNameFiles() {
    Sweep sweep = smallSweep();
    sweep.parts = {{"a/b: c", {}, nullptr, {}},
                   {std::string(300, 'x'), {}, nullptr, {}},
                   {"..", {}, nullptr, {}},
                   {"Näschen", {}, nullptr, {}},
                   {std::string(39, 'y') + "ü", {}, nullptr, {}}};
    sweep.embeddings = {EmbeddingSettings::Method::Cotangent, EmbeddingSettings::Method::MeanValue};
    QVERIFY(check(sweep));
    std::set<std::string> names;
    for (std::size_t i = 0; i < sweep.count(); ++i) {
      const std::string name = sweep.name(i);
      QVERIFY(names.insert(name).second);
      QVERIFY2(name.size() < 240 && name.find_first_of("/\\: \"*?<>|") == std::string::npos, name.c_str());
      QVERIFY(name.front() != '.');
      QVERIFY(QString::fromStdString(name).toStdString() == name);  // UTF-8 to the end
    }
    QVERIFY(sweep.name(0).starts_with("a-b--c_paste_falloff-2"));
  }

  void tooManyCombinationsAreRefused() {
    Sweep sweep = smallSweep();
    for (int i = 0; i < 60'000; ++i) {
      sweep.shifts.push_back(i + 10);
    }
    const Result<void> checked = check(sweep);
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, ErrorCode::SettingOutOfRange);
    QVERIFY(checked.error().message.find("60003 shifts × 2 falloffs × 2 curves") != std::string::npos);
    // Lists whose product leaves every integer.
    sweep.falloffs.assign(1'000'000, 1);
    sweep.monotone.assign(1'000'000, true);
    sweep.embeddings.assign(1'000'000, EmbeddingSettings::Method::Automatic);
    QCOMPARE(sweep.count(), Sweep::kMostCombinations + 1);
  }

  void entriesThatAreAlikeAreRefused() {
    const auto refused = [](const Sweep& sweep, const char* list) {
      const Result<void> checked = check(sweep);
      return !checked && checked.error().code == ErrorCode::SettingOutOfRange &&
             checked.error().message.find(list) != std::string::npos;
    };
    Sweep sweep = smallSweep();
    sweep.curves[1].name = "Paste";
    QVERIFY(refused(sweep, "\"fcf\" has \"Paste\" twice"));
    sweep = smallSweep();
    sweep.shifts[2] = 1;
    QVERIFY(refused(sweep, "\"shift\" has \"1\" twice"));
    sweep = smallSweep();
    sweep.parts = {{"a b", {}, nullptr, {}}, {"a/b", {}, nullptr, {}}};
    QVERIFY(refused(sweep, "\"parts\" has \"a-b\" twice"));
    sweep = smallSweep();
    sweep.falloffs[0] = -1;
    QVERIFY(refused(sweep, "\"deform_exponent\" has -1"));
    sweep.falloffs[0] = std::nan("");
    QVERIFY(refused(sweep, "\"deform_exponent\""));
  }

  void theRunningOrderChangesOneListAtATime() {
    Sweep sweep = smallSweep();
    sweep.monotone = {true, false};
    sweep.embeddings = {EmbeddingSettings::Method::Automatic, EmbeddingSettings::Method::MeanValue};
    const std::vector<std::size_t> order = runOrder(sweep);
    QCOMPARE(order.size(), sweep.count());
    QCOMPARE(std::set<std::size_t>(order.begin(), order.end()).size(), sweep.count());
    for (std::size_t i = 1; i < order.size(); ++i) {
      const SweepChoice a = sweep.choice(order[i - 1]);
      const SweepChoice b = sweep.choice(order[i]);
      const int changed = (a.embedding != b.embedding) + (a.shift != b.shift) + (a.falloff != b.falloff) +
                          (a.curve != b.curve) + (a.monotone != b.monotone);
      QCOMPARE(changed, 1);
    }
  }

  void sharesDivideTheRunningOrder() {
    const Sweep sweep = smallSweep();
    const std::vector<std::size_t> whole = runOrder(sweep);
    for (const std::size_t of : {1, 2, 5, 12, 30}) {
      std::vector<std::size_t> joined;
      for (std::size_t k = 1; k <= of; ++k) {
        const std::vector<std::size_t> share = runOrder(sweep, {k, of});
        QVERIFY(share.size() >= 12 / of && share.size() <= 12 / of + 1);
        joined.insert(joined.end(), share.begin(), share.end());
      }
      QVERIFY(joined == whole);
    }
  }

  void runningReusesWhatDidNotChange() {
    const auto sweep = std::make_shared<const Sweep>(smallSweep());
    SweepRun run(sweep);
    const FusionResults first = run.run(0, {}).results;
    const FusionResults otherCurve = run.run(1, {}).results;
    QVERIFY(otherCurve.join == first.join && !otherCurve.run(Stage::Overlay).ran &&
            otherCurve.run(Stage::Blend).ran);
    const FusionResults otherFalloff = run.run(3, {}).results;
    QVERIFY(otherFalloff.part.tile == first.part.tile && otherFalloff.run(Stage::Adjust).ran);
    const FusionResults otherShift = run.run(7, {}).results;
    QVERIFY(otherShift.base.embedding == first.base.embedding && otherShift.run(Stage::Overlay).ran);
  }

  void resultsDoNotDependOnTheOrder() {
    const auto sweep = std::make_shared<const Sweep>(smallSweep());
    SweepRun forwards(sweep);
    for (const std::size_t combination : runOrder(*sweep)) {
      const SweepResult here = forwards.run(combination, {});
      const SweepResult alone = SweepRun(sweep).run(combination, {});
      QVERIFY(here.results.fused->points == alone.results.fused->points);
      QVERIFY(here.results.fused->faces() == alone.results.fused->faces());
      QVERIFY(here.measures && here.measures == alone.measures);
    }
  }

  void aCancelledCombinationCanBeRunAgain() {
    const auto sweep = std::make_shared<const Sweep>(smallSweep());
    SweepRun run(sweep);
    const SweepResult cancelled = run.run(0, Progress([](double) { return false; }, {}));
    QVERIFY(cancelled.results.error && cancelled.results.error->code == ErrorCode::Cancelled);
    QVERIFY(!cancelled.measures);
    QVERIFY(run.run(0, {}).measures == SweepRun(sweep).run(0, {}).measures);
  }

  void progressNeverFallsWithinACombination() {
    const auto sweep = std::make_shared<const Sweep>(smallSweep());
    double last = 0;
    bool rises = true;
    const Progress progress(
        [&](double done) {
          rises = rises && done >= last && done <= 1;
          last = done;
          return true;
        },
        {});
    static_cast<void>(SweepRun(sweep).run(0, progress));
    QVERIFY(rises && last > 0.5);
  }

  void theTableHasARowForEachResult() {
    const QTemporaryDir dir;
    SweepOutput output;
    output.mesh = "off";
    const auto sweep = loaded(smallSweep(), output);
    runInto(pathOf(dir), sweep, {});
    const std::vector<csv::Row> table = tableOf(pathOf(dir));
    QCOMPARE(table.size(), std::size_t{13});
    QVERIFY(table[0] == SweepTable::header());
    SweepRun run({sweep, &sweep->sweep});
    for (std::size_t i = 0; i < 12; ++i) {
      const std::size_t row = i + 1;
      QCOMPARE(table[row].size(), table[0].size());
      const Measures measures = *run.run(i, {}).measures;
      QCOMPARE(cell(table, row, "number"), std::to_string(i + 1));
      QCOMPARE(cell(table, row, "name"), sweep->sweep.name(i));
      QCOMPARE(std::stoi(cell(table, row, "shift")), sweep->sweep.shifts[i / 4]);
      QCOMPARE(std::stod(cell(table, row, "deform_exponent")), sweep->sweep.inputs(i).adjustment.falloff);
      QVERIFY(parseFCF(cell(table, row, "fcf")).value().points() == sweep->sweep.inputs(i).fcf.points());
      // To the last bit.
      QVERIFY(std::stod(cell(table, row, "seam_angle_mean")) == measures.meanSeamAngle);
      QVERIFY(std::stod(cell(table, row, "volume")) == *measures.volume);
      QVERIFY(std::stod(cell(table, row, "distance_greatest")) == measures.greatestDistance);
      QVERIFY(std::stod(cell(table, row, "quality_5th_percentile")) == measures.lowQuality);
      QCOMPARE(cell(table, row, "error"), std::string());
      QCOMPARE(cell(table, row, "picture"), std::string());
      const Result<MeshFile> mesh = readMesh(pathOf(dir) / cell(table, row, "mesh"), {});
      QVERIFY(mesh);
      QCOMPARE(mesh->mesh->faceCount(), measures.faces);
    }
  }

  void whatDoesNotFuseSaysSoAndTheOthersGoOn() {
    const QTemporaryDir dir;
    SweepOutput output;
    output.picture = SweepPicture{{64, 48}};
    runInto(pathOf(dir), loaded(halfBroken(), output), {});
    const std::vector<csv::Row> table = tableOf(pathOf(dir));
    QCOMPARE(table.size(), std::size_t{5});
    for (const std::size_t row : {1, 2}) {
      QCOMPARE(cell(table, row, "part"), std::string("good"));
      QCOMPARE(cell(table, row, "error"), std::string());
      QVERIFY(fs::exists(pathOf(dir) / cell(table, row, "mesh")));
      QVERIFY(contentOf(pathOf(dir) / cell(table, row, "picture")).starts_with("\x89PNG"));
    }
    for (const std::size_t row : {3, 4}) {
      QCOMPARE(cell(table, row, "part"), std::string("bad"));
      QVERIFY(cell(table, row, "error").find("CV") != std::string::npos);
      QCOMPARE(cell(table, row, "mesh") + cell(table, row, "picture") + cell(table, row, "area"),
               std::string());
    }
    QCOMPARE(contents(pathOf(dir)).size(), std::size_t{2 + 2 + 1});
  }

  void sharesGiveTheSameBytesAsOneRunOnAnyNumberOfThreads() {
    SweepOutput output;
    output.mesh = "glb";
    output.picture = SweepPicture{{80, 60}};
    const auto sweep = loaded(smallSweep(), output);
    const QTemporaryDir whole;
    setThreadCount(1);
    runInto(pathOf(whole), sweep, {});
    const auto expected = contents(pathOf(whole));
    QCOMPARE(expected.size(), std::size_t{12 + 12 + 1});
    for (const std::size_t of : {3, 20}) {
      const QTemporaryDir shares;
      setThreadCount(2);
      for (std::size_t k = of; k >= 1; --k) {
        runInto(pathOf(shares), loaded(smallSweep(), output), {k, of});
      }
      const Result<MergedTables> merged = mergeTables(pathOf(shares));
      QVERIFY(merged);
      QCOMPARE(merged->shares, of);
      QCOMPARE(merged->rows, std::size_t{12});
      QVERIFY(contents(pathOf(shares)) == expected);
    }
  }

  void aMissingShareIsNamed() {
    const QTemporaryDir dir;
    const auto sweep = loaded(smallSweep(), {"", {}});
    QCOMPARE(mergeTables(pathOf(dir)).error().code, ErrorCode::FileUnreadable);
    runInto(pathOf(dir), sweep, {1, 3});
    runInto(pathOf(dir), sweep, {3, 3});
    const Result<MergedTables> merged = mergeTables(pathOf(dir));
    QVERIFY(!merged);
    QCOMPARE(merged.error().code, ErrorCode::FileUnreadable);
    QVERIFY(merged.error().message.find("share 2/3 is missing (table-2-of-3.csv)") != std::string::npos);
    QVERIFY(!fs::exists(pathOf(dir) / "table.csv"));
  }

  void sharesOfDifferentDivisionsAreRefused() {
    const QTemporaryDir dir;
    const auto sweep = loaded(smallSweep(), {"", {}});
    runInto(pathOf(dir), sweep, {1, 2});
    runInto(pathOf(dir), sweep, {2, 2});
    runInto(pathOf(dir), sweep, {2, 3});
    const Result<MergedTables> merged = mergeTables(pathOf(dir));
    QVERIFY(!merged && merged.error().code == ErrorCode::FileMalformed);
    QVERIFY(merged.error().message.find("table-1-of-2.csv and table-2-of-3.csv") != std::string::npos);
  }

  void sharesOfDifferentSweepsAreRefused() {
    const QTemporaryDir dir;
    runInto(pathOf(dir), loaded(smallSweep(), {"", {}}), {1, 2});
    Sweep other = smallSweep();
    other.falloffs[1] = 6;
    runInto(pathOf(dir), loaded(other, {"", {}}), {2, 2});
    const Result<MergedTables> merged = mergeTables(pathOf(dir));
    QVERIFY(!merged && merged.error().code == ErrorCode::FileMalformed);
    QVERIFY(merged.error().message.find("different sweeps") != std::string::npos);
  }

  void aShareTwiceUnderAnotherNameIsRefused() {
    const QTemporaryDir dir;
    runInto(pathOf(dir), loaded(smallSweep(), {"", {}}), {1, 2});
    fs::copy(pathOf(dir) / "table-1-of-2.csv", pathOf(dir) / "table-2-of-2.csv");
    const Result<MergedTables> merged = mergeTables(pathOf(dir));
    QVERIFY(!merged && merged.error().message.find("both have result 1") != std::string::npos);
  }

  void whatIsNoTableOfASweepIsRefused() {
    for (const char* content : {"", "a,b\r\n", "\"", "sweep,number\r\nx,1\r\n"}) {
      const QTemporaryDir dir;
      std::ofstream(pathOf(dir) / "table-1-of-2.csv") << content;
      std::ofstream(pathOf(dir) / "table-2-of-2.csv") << content;
      const Result<MergedTables> merged = mergeTables(pathOf(dir));
      QVERIFY(!merged && merged.error().code == ErrorCode::FileMalformed);
    }
  }

  void theFingerprintTellsSweepsApart() {
    const std::string own = loaded(smallSweep())->fingerprint;
    QCOMPARE(own.size(), std::size_t{16});
    QCOMPARE(loaded(smallSweep())->fingerprint, own);
    Sweep otherMesh = smallSweep();
    std::vector<Point> points = otherMesh.base.base->points();
    points[0].x() = std::nextafter(points[0].x(), 10);
    otherMesh.base.base = std::make_shared<const TriangleMesh>(points, otherMesh.base.base->faces());
    QVERIFY(loaded(otherMesh)->fingerprint != own);
    Sweep otherSetting = smallSweep();
    otherSetting.base.adjustment.exactFit = false;
    QVERIFY(loaded(otherSetting)->fingerprint != own);
  }

  void aSourceIsNotOverwritten() {
    const QTemporaryDir dir;
    Sweep sweep = smallSweep();
    LoadedSweep made = loadSweep(sweep, {"stl", {}}, false).value();
    const fs::path source = pathOf(dir) / (sweep.name(0) + ".stl");
    std::ofstream(source) << "my model";
    made.sources = {source};
    const auto shared = std::make_shared<const LoadedSweep>(std::move(made));
    SweepFolder folder = SweepFolder::open(pathOf(dir), shared, {}).value();
    const Result<void> added = folder.add(SweepRun({shared, &shared->sweep}).run(0, {}), {});
    QVERIFY(!added && added.error().code == ErrorCode::FileUnwritable);
    QCOMPARE(contentOf(source), std::string("my model"));
  }

  void aFolderThatCannotBeMadeIsRefused() {
    const QTemporaryDir dir;
    const fs::path file = pathOf(dir) / "file";
    std::ofstream(file) << "x";
    const auto sweep = loaded(smallSweep());
    for (const fs::path& folder : {file, file / "inside"}) {
      const Result<SweepFolder> opened = SweepFolder::open(folder, sweep, {});
      QVERIFY(!opened && opened.error().code == ErrorCode::FileUnwritable);
    }
  }
};

QTEST_APPLESS_MAIN(SweepTest)
#include "sweep_test.moc"
