#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/fusion/rigid_fit.h"
#include "core/io/printable.h"
#include "core/io/scenario.h"
#include "tests/support/samples.h"
#include "tests/support/scenario_texts.h"

using namespace graftsman;
namespace fs = std::filesystem;

namespace {

// Two triangles that share no vertex: reading welds them.
const char* const kSoup = "v 1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 4 1 3\nf 2 5 6\n";
const char* const kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

// A temporary folder to put files into.
class Folder {
 public:
  [[nodiscard]] fs::path path() const { return folder_.path().toStdString(); }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path() / name, std::ios::binary) << text;
    return path() / name;
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace

class ScenarioFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aScenarioSavedElsewhereStillFindsItsMeshes() {
    Scenario scenario;
    scenario.part = "models/part.obj";
    scenario.base = "base.obj";
    const auto reopened = [&](const fs::path& path) {
      const Scenario back = parseScenario(formatScenario(scenario, path), path).value();
      const auto full = [](const fs::path& file) { return fs::absolute(file).lexically_normal(); };
      return full(back.part) == full(scenario.part) && full(back.base) == full(scenario.base);
    };
    for (const char* path : {"x.json", "models/x.json", "other/deep/x.json", "../x.json", "/tmp/x.json"}) {
      QVERIFY2(reopened(path), path);
    }
  }

  void everySampleLoadsWithItsMeshes() {
    for (const std::string& name : samples::kScenarios) {
      const Result<LoadedScenario> loaded = readScenario(samples::scenarioPath(name), {});
      QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
      const FusionInputs& inputs = loaded->scenario.inputs;
      for (const CVP& cvp : inputs.loop) {
        QVERIFY(cvp.part.vertex >= 0 && cvp.part.vertex < inputs.part->vertexCount());
        QVERIFY(cvp.base.vertex >= 0 && cvp.base.vertex < inputs.base->vertexCount());
      }
    }
    const FusionInputs cone = samples::load("fig4a_cone_sphere");
    QCOMPARE(cone.part->faceCount(), 864);
    QCOMPARE(cone.base->faceCount(), 1840);
    // The note says that both boundaries are the circle of radius 0.8: the files' numbers were kept.
    std::vector<Point> part;
    std::vector<Point> base;
    for (const CVP& cvp : cone.loop) {
      part.push_back(cone.part->point(cvp.part.vertex));
      base.push_back(cone.base->point(cvp.base.vertex));
    }
    for (const std::vector<Point>& circle : {part, base}) {
      for (const Point& p : circle) {
        QVERIFY(std::abs((p - centroid(circle)).norm() - 0.8) < 1e-5);
      }
    }
    const Adjustment adjusted = adjust({}, part, base, {}, {}).value();
    QCOMPARE(adjusted.report.reached, AdjustmentStep::Rigid);
  }

  void cvsFollowTheVerticesThatReadingWelds() {
    const Folder folder;
    folder.write("soup.obj", kSoup);
    folder.write("base.obj", kQuad);
    const fs::path file = folder.write(
        "s.json", R"({"m1": "soup.obj", "m2": "base.obj", "cvp": [[3, 3], [1, 1], [5, 2], [4, 0]]})");
    const LoadedScenario loaded = readScenario(file, {}).value();
    const FusionInputs& inputs = loaded.scenario.inputs;
    QCOMPARE(inputs.part->vertexCount(), 4);
    QVERIFY(loaded.partReport.welded == 2);
    const std::vector<Point> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
      QVERIFY(inputs.part->point(inputs.loop[i].part.vertex) == expected[i]);
    }
    QCOMPARE(inputs.loop[0].base.vertex, 3);
  }

  void aFileThatIsPartAndBaseIsReadOnce() {
    const Folder folder;
    folder.write("a.obj", kQuad);
    const fs::path file =
        folder.write("s.json", R"({"m1": "a.obj", "m2": "./a.obj", "cvp": [[0, 0], [1, 1], [2, 2]]})");
    const FusionInputs inputs = readScenario(file, {})->scenario.inputs;
    QVERIFY(inputs.part && inputs.part == inputs.base);
  }

  void numbersBeyondTheMeshAreNamedWithWhatItHas() {
    const Folder folder;
    folder.write("soup.obj", kSoup);
    folder.write("base.obj", kQuad);
    const auto errorOf = [&](const std::string& cvp) {
      const fs::path file =
          folder.write("s.json", R"({"m1": "soup.obj", "m2": "base.obj", "cvp": [[0, 0], )" + cvp + "]}");
      return readScenario(file, {}).error();
    };
    const Error part = errorOf("[6, 0]");
    QCOMPARE(part.code, ErrorCode::LoopIndexOutOfRange);
    QVERIFY(part.side == Side::Part && part.cvs == std::vector<int>{1});
    QVERIFY2(contains(part.message, "CV 1 of the part is vertex 6") && contains(part.message, "soup.obj") &&
                 contains(part.message, "6 vertices"),
             part.message.c_str());
    const Error base = errorOf("[5, 4]");
    QCOMPARE(base.code, ErrorCode::LoopIndexOutOfRange);
    QVERIFY(base.side == Side::Base);
    QVERIFY2(contains(base.message, "base.obj has 4 vertices"), base.message.c_str());
    const Error face = errorOf("[{\"face\": 2, \"bary\": [1, 0, 0]}, 0]");
    QCOMPARE(face.code, ErrorCode::LoopIndexOutOfRange);
    QVERIFY2(contains(face.message, "face 2") && contains(face.message, "2 faces"), face.message.c_str());
  }

  void filesThatCannotBeReadAreNamed() {
    const Folder folder;
    const Error missing = readScenario(folder.path() / "none.json", {}).error();
    QCOMPARE(missing.code, ErrorCode::FileUnreadable);
    QVERIFY(contains(missing.message, "none.json"));
    QCOMPARE(readScenario(folder.path(), {}).error().code, ErrorCode::FileUnreadable);

    folder.write("a.obj", kQuad);
    const Error mesh =
        readScenario(folder.write("s.json", R"({"m1": "a.obj", "m2": "no.obj", "cvp": []})"), {}).error();
    QCOMPARE(mesh.code, ErrorCode::FileUnreadable);
    QVERIFY(mesh.side == Side::Base);
    QVERIFY(contains(mesh.message, "no.obj"));
    const Error format =
        readScenario(folder.write("s.json", R"({"m1": "a.xyz", "m2": "a.obj", "cvp": []})"), {}).error();
    QCOMPARE(format.code, ErrorCode::FormatUnknown);
    QVERIFY(format.side == Side::Part);
  }

  void aHugeFileIsNoScenario() {
    const Folder folder;
    const fs::path file = folder.write("huge.json", "{");
    fs::resize_file(file, std::uintmax_t{1} << 31);
    QCOMPARE(readScenario(file, {}).error().code, ErrorCode::ScenarioMalformed);
  }

  void aCancelledReadSaysSo() {
    const Progress cancel([](double) { return false; }, std::chrono::seconds(0));
    QCOMPARE(readScenario(samples::scenarioPath("fig9b_bird_plane"), cancel).error().code,
             ErrorCode::Cancelled);
  }
};

QTEST_APPLESS_MAIN(ScenarioFilesTest)
#include "scenario_files_test.moc"
