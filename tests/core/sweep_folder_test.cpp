#include "core/sweep/sweep_folder.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>

#include "core/base/parallel.h"
#include "core/io/mesh_file.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/sweeps.h"

using namespace graftsman;
namespace fs = std::filesystem;

namespace {

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

class SweepFolderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreadCount(0); }

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

QTEST_APPLESS_MAIN(SweepFolderTest)
#include "sweep_folder_test.moc"
