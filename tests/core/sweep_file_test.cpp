#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

#include "core/project/project_file.h"
#include "core/sweep/sweep_file.h"
#include "tests/support/documents.h"
#include "tests/support/places.h"
#include "tests/support/samples.h"

using namespace graftsman;
namespace fs = std::filesystem;

namespace {

const fs::path kPath = "folder/sweep.json";

Result<SweepFile> parse(const std::string& text) {
  return parseSweep(text, kPath);
}

// A sweep with these keys besides "fusion".
Result<SweepFile> with(const std::string& keys) {
  return parse("{\"fusion\": \"a.json\", " + keys + "}");
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string quoted(const fs::path& path) {
  return '"' + path.string() + '"';
}

const fs::path kSamples = places::samples();

}  // namespace

class SweepFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyKeyIsRead() {
    const Result<SweepFile> file = parse(
        R"({)"
        R"("fusion": "../scenarios/a.json",)"
        R"("parts": [{"name": "own one"}, {"m1": "m/cone.stl", "cvp": [[1, 2], [3, {"face": 4, "bary": [0, 0.5, 0.5]}], [5, 6]]}],)"
        R"("embedding": ["automatic", "mean-value"],)"
        R"("shift": [0, -1],)"
        R"("adjustment": [{}, {"name": "rigid", "scale": false, "line_field": false, "epsilon": 0.5}],)"
        R"("deform_exponent": [2, 5.5],)"
        R"("fcf": ["paste", [[0, 0], [0.2, 0.1], [0.6, 0.9], [1, 1]], {"name": "late", "fcf": "half"}],)"
        R"("monotone": [true, false],)"
        R"("mesh": "glb",)"
        R"("picture": {"size": [640, 480], "view": "whole", "up": "y", "towards": [0, 0, 2]},)"
        R"("note": "anything"})");
    QVERIFY2(file, file ? "" : file.error().message.c_str());
    QCOMPARE(file->fusion, fs::path("folder/../scenarios/a.json"));
    const Sweep& sweep = file->sweep;
    QCOMPARE(sweep.count(), std::size_t{2 * 2 * 2 * 2 * 2 * 3 * 2});
    QCOMPARE(sweep.parts[0].name, std::string("own one"));
    QVERIFY(sweep.parts[0].source.empty());
    QCOMPARE(sweep.parts[1].name, std::string("cone"));
    QCOMPARE(sweep.parts[1].source, fs::path("folder/m/cone.stl"));
    QCOMPARE(sweep.parts[1].loop.size(), std::size_t{3});
    QCOMPARE(sweep.parts[1].loop[1].base.face, 4);
    QVERIFY(sweep.embeddings[1] == EmbeddingSettings::Method::MeanValue);
    QVERIFY(sweep.shifts == (std::vector<int>{0, -1}));
    QCOMPARE(sweep.adjustments[0].name, std::string("adjustment-1"));
    QVERIFY(sweep.adjustments[0].settings == AdjustmentSettings());
    QCOMPARE(sweep.adjustments[1].name, std::string("rigid"));
    QVERIFY(!sweep.adjustments[1].settings.scale && sweep.adjustments[1].settings.exactFit);
    QCOMPARE(sweep.adjustments[1].settings.epsilon, 0.5);
    QVERIFY(sweep.falloffs == (std::vector<double>{2, 5.5}));
    QCOMPARE(sweep.curves[0].name, std::string("paste"));
    QCOMPARE(sweep.curves[1].name, std::string("curve-2"));
    QCOMPARE(sweep.curves[1].curve.points()[1].f, 0.1);
    QCOMPARE(sweep.curves[2].name, std::string("late"));
    QVERIFY(sweep.curves[2].curve == FCF::preset(FCF::Preset::Half));
    QCOMPARE(file->output.mesh, std::string("glb"));
    QVERIFY((file->output.picture->size == PictureSize{640, 480}));
    QVERIFY(file->output.picture->view == FusionView::Whole && file->output.picture->yUp == true);
    QVERIFY(*file->output.picture->towards == Eigen::Vector3d(0, 0, 2));
  }

  void theFusionAloneIsASweepOfOne() {
    const Result<SweepFile> file = parse(R"({"fusion": "/a.json"})");
    QVERIFY(file);
    QCOMPARE(file->fusion, fs::path("/a.json"));
    QCOMPARE(file->sweep.count(), std::size_t{1});
    QCOMPARE(file->output.mesh, std::string("ply"));
    QVERIFY(!file->output.picture);
    QVERIFY(with(R"("mesh": "none")")->output.mesh.empty());
    QVERIFY(with(R"("picture": true)")->output.picture);
    QVERIFY(!with(R"("picture": false)")->output.picture);
  }

  void whatIsWrittenReadsBack() {
    const Result<SweepFile> file = with(
        R"("parts": [{"name": "own"}, {"m1": "x.obj", "cvp": [[0, 1], [2, 3], [4, 5]]}],)"
        R"("fcf": ["linear", {"name": "ü \u0022quoted\u0022", "fcf": [[0, 0], [0.1, 0.30000000000000004], [0.6, 0.9], [1, 1]]}],)"
        R"("deform_exponent": [0.1, 1e-300], "adjustment": [{"max_iterations": 7}], "shift": [-3], "monotone": [false],)"
        R"("embedding": ["low-stretch"], "mesh": "none", "picture": {"towards": [0.1, 0.2, 0.3], "up": "z"})");
    QVERIFY2(file, file ? "" : file.error().message.c_str());
    const std::string text = formatSweep(*file, kPath);
    const Result<SweepFile> back = parse(text);
    QVERIFY2(back, back ? "" : back.error().message.c_str());
    QCOMPARE(formatSweep(*back, kPath), text);
    QVERIFY(back->fusion.lexically_normal() == file->fusion.lexically_normal());
    QVERIFY(back->sweep.curves[1].curve == file->sweep.curves[1].curve);
    QCOMPARE(back->sweep.curves[1].name, file->sweep.curves[1].name);
    QVERIFY(back->sweep.parts[1].loop == file->sweep.parts[1].loop);
    QVERIFY(back->sweep.falloffs == file->sweep.falloffs);
    QVERIFY(back->sweep.adjustments[0].settings == file->sweep.adjustments[0].settings);
    QVERIFY(*back->output.picture->towards == *file->output.picture->towards);
  }

  void whatIsWrongIsToldByItsKey_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("told");
    const auto row = [](const char* text, const char* told) {
      QTest::newRow(text) << QByteArray(text) << QByteArray(told);
    };
    row("[]", "must be a JSON object");
    row("{\n\"fusion\": \"a\",\n}", "line 3");
    row("{}", "\"fusion\" is missing");
    row(R"({"fusion": ""})", "\"fusion\" must be");
    row(R"({"fusion": "a", "curves": ["linear"]})",
        "\"curves\" is no key of a sweep, which has fusion, parts");
    row(R"({"fusion": "a", "fusion": "b"})", "\"fusion\" is given twice");
    row(R"({"fusion": "a", "adjustment": [{"rigid": true, "rigid": false}]})", "\"rigid\" is given twice");
    row(R"({"fusion": "a", "adjustment": [{}, {"rigidly": true}]})", "\"adjustment[1].rigidly\" is no key");
    row(R"({"fusion": "a", "adjustment": [{"rigid": 1}]})", "\"adjustment[0].rigid\" must be true or false");
    row(R"({"fusion": "a", "adjustment": {"rigid": true}})", "\"adjustment\" must be a list");
    row(R"({"fusion": "a", "fcf": []})", "\"fcf\" must be a list of at least one");
    row(R"({"fusion": "a", "fcf": "linear"})", "\"fcf\" must be a list");
    row(R"({"fusion": "a", "fcf": ["linear", "curly"]})", "\"fcf[1]\" must be");
    row(R"({"fusion": "a", "fcf": [[[0, 0], [1, 1]]]})", "\"fcf[0]\":");
    row(R"({"fusion": "a", "fcf": [[[0, 0], [0.5, "x"], [0.6, 1], [1, 1]]]})", "\"fcf[0][1][1]\" must be");
    row(R"({"fusion": "a", "fcf": [{"name": "x"}]})", "\"fcf[0].fcf\" must be");
    row(R"({"fusion": "a", "fcf": [{"name": "", "fcf": "half"}]})", "\"fcf[0].name\" must be");
    row(R"({"fusion": "a", "fcf": ["half", {"name": "HALF", "fcf": "paste"}]})",
        "\"fcf\" has \"HALF\" twice");
    row(R"({"fusion": "a", "shift": [0.5]})", "\"shift[0]\" must be a whole number");
    row(R"({"fusion": "a", "shift": [12345678901234567890]})", "\"shift[0]\" must be");
    row(R"({"fusion": "a", "deform_exponent": [5, 0]})",
        "\"deform_exponent[1]\" must be a number greater than 0");
    row(R"({"fusion": "a", "embedding": ["flat"]})", "\"embedding[0]\" must be one of");
    row(R"({"fusion": "a", "monotone": [1]})", "\"monotone[0]\" must be true or false");
    row(R"({"fusion": "a", "parts": [{"m1": "x.obj"}]})", "\"parts[0]\" must be an object with both");
    row(R"({"fusion": "a", "parts": [{"m1": "x.obj", "cvp": [[0]]}]})", "\"parts[0]\": \"cvp[0]\" must be");
    row(R"({"fusion": "a", "parts": [{"m1": "x.obj", "cvp": [], "m2": "y"}]})", "\"parts[0].m2\" is no key");
    row(R"({"fusion": "a", "mesh": "fbx"})", "\"mesh\" must be \"obj\"");
    row(R"({"fusion": "a", "mesh": ""})", "\"mesh\" must be");
    row(R"({"fusion": "a", "picture": 1})", "\"picture\" must be");
    row(R"({"fusion": "a", "picture": {"width": 1}})", "\"picture.width\" is no key");
    row(R"({"fusion": "a", "picture": {"size": [0, 5]}})", "\"picture.size[0]\" must be");
    row(R"({"fusion": "a", "picture": {"size": [5, 99999]}})", "\"picture.size[1]\" must be");
    row(R"({"fusion": "a", "picture": {"view": "near"}})", "\"picture.view\" must be \"tile\" or \"whole\"");
    row(R"({"fusion": "a", "picture": {"up": "x"}})", "\"picture.up\" must be \"y\" or \"z\"");
    row(R"({"fusion": "a", "picture": {"towards": [0, 0, 0]}})", "\"picture.towards\" must be");
  }
  void whatIsWrongIsToldByItsKey() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, told);
    const Result<SweepFile> file = parse(text.toStdString());
    QVERIFY(!file);
    const QByteArray message = QByteArray::fromStdString(file.error().message);
    QVERIFY2(message.startsWith("folder/sweep.json: "), message);
    QVERIFY2(message.contains(told), message);
  }

  void anAbsurdProductIsRefused() {
    std::string numbers = "1";
    for (int i = 2; i <= 400; ++i) {
      numbers += "," + std::to_string(i);
    }
    const Result<SweepFile> file =
        with("\"shift\": [" + numbers + "], \"deform_exponent\": [" + numbers + "]");
    QVERIFY(!file);
    QVERIFY(file.error().message.find("400 shifts × 400 falloffs") != std::string::npos);
  }

  void theSampleIsReadWithItsMeshes() {
    const Result<LoadedSweep> loaded = readSweep(kSamples / "sweeps" / "nose.json", {});
    QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
    const Sweep& sweep = loaded->sweep;
    QCOMPARE(sweep.count(), std::size_t{24});
    QVERIFY(sweep.parts[0].mesh == nullptr);
    QCOMPARE(sweep.parts[1].mesh->faceCount(), 480);
    QVERIFY(sweep.inputs(0).part == sweep.base.part);
    QVERIFY(sweep.inputs(23).part == sweep.parts[1].mesh && sweep.inputs(23).base == sweep.base.base);
    QCOMPARE(loaded->sources.size(), std::size_t{5});
    // The part's pairs are those of the scenario that has it alone.
    QVERIFY(sweep.parts[1].loop == samples::load("fig8d_hemisphere_nose").loop);
    QVERIFY(loaded->direction.up == Eigen::Vector3d::UnitY());
  }

  void aMeshIsReadOnce() {
    const QTemporaryDir dir;
    const fs::path path = fs::path(dir.path().toStdString()) / "sweep.json";
    const std::string pairs = R"("cvp": [[0, 1], [2, 3], [4, 5]])";
    const std::string cone = quoted(samples::modelPath("cone.stl"));
    const std::string ball = quoted(samples::modelPath("hemisphere.stl"));
    write(path, "{\"fusion\": " + quoted(samples::scenarioPath("fig8b_cone_nose")) + ", \"parts\": [" +
                    "{\"name\": \"1\", \"m1\": " + cone + ", " + pairs + "}," + "{\"name\": \"2\", \"m1\": " +
                    ball + ", " + pairs + "}," + "{\"name\": \"3\", \"m1\": " + ball + ", " + pairs + "}]}");
    const Result<LoadedSweep> loaded = readSweep(path, {});
    QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
    QVERIFY(loaded->sweep.parts[0].mesh == loaded->sweep.base.part);
    QVERIFY(loaded->sweep.parts[1].mesh == loaded->sweep.parts[2].mesh);
  }

  void aProjectCanBeTheFusion() {
    const QTemporaryDir dir;
    const fs::path folder = dir.path().toStdString();
    const LoadedScenario scenario = readScenario(samples::scenarioPath("fig4a_cone_sphere"), {}).value();
    Project project;
    project.document = samples::documentOf(samples::fusion("fig4a_cone_sphere"));
    QVERIFY(writeProject(folder / "p.graft", project, {}));
    write(folder / "sweep.json", R"({"fusion": "p.graft", "fcf": ["paste", "half"]})");
    const Result<LoadedSweep> loaded = readSweep(folder / "sweep.json", {});
    QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
    QVERIFY(loaded->sweep.base.loop == scenario.scenario.inputs.loop);
    QCOMPARE(loaded->sweep.base.base->faceCount(), scenario.scenario.inputs.base->faceCount());
  }

  void filesThatAreNotThereAreNamed() {
    const QTemporaryDir dir;
    const fs::path path = fs::path(dir.path().toStdString()) / "sweep.json";
    const auto message = [&] {
      const Result<LoadedSweep> loaded = readSweep(path, {});
      return loaded ? std::string() : loaded.error().message;
    };
    QVERIFY(message().find("sweep.json: cannot be read") != std::string::npos);
    write(path, R"({"fusion": "none.json"})");
    QVERIFY(message().find("none.json") != std::string::npos);
    const std::string fusion = quoted(samples::scenarioPath("fig4a_cone_sphere"));
    write(path, "{\"fusion\": " + fusion + R"(, "parts": [{"m1": "none.stl", "cvp": []}]})");
    QVERIFY(message().find("Part \"none\": ") == 0);
    write(path, "{\"fusion\": " + fusion + ", \"parts\": [{\"m1\": " +
                    quoted(samples::modelPath("cone.stl")) + ", \"cvp\": [[999999, 0]]}]}");
    QVERIFY(message().find("Part \"cone\": CV 0 of the part is vertex 999999") == 0);
  }
};

QTEST_APPLESS_MAIN(SweepFileTest)
#include "sweep_file_test.moc"
