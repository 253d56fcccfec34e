#include "core/io/scenario.h"
#include "tests/support/places.h"

#include <QtTest>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/fusion/rigid_fit.h"
#include "core/io/printable.h"
#include "tests/support/samples.h"
#include "tests/support/scenario_texts.h"

using namespace graftsman;
namespace fs = std::filesystem;

namespace {

const std::string kHead = R"({"m1": "a.obj", "m2": "b.obj", "cvp": [[0, 1], [2, 3], [4, 5]])";

// A valid scenario with one more key, or one that it overrides.
std::string with(const std::string& keyAndValue) {
  return kHead + ", " + keyAndValue + "}";
}

Result<Scenario> parse(const std::string& text) {
  return parseScenario(text, "folder/some.json");
}

std::string messageOf(const Result<Scenario>& result) {
  return result ? "no error" : result.error().message;
}

// Checks that `text` is refused with a message that names `key`.
void mustFail(const std::string& text, const std::string& key,
              ErrorCode code = ErrorCode::ScenarioMalformed) {
  const Result<Scenario> result = parse(text);
  QVERIFY2(!result, text.c_str());
  QVERIFY2(result.error().code == code, messageOf(result).c_str());
  QVERIFY2(contains(messageOf(result), key), (text + " → " + messageOf(result)).c_str());
  QVERIFY2(contains(messageOf(result), "folder/some.json"), messageOf(result).c_str());
}

std::string readAll(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool sameInputs(const FusionInputs& a, const FusionInputs& b) {
  return a.loop == b.loop && a.paths == b.paths && a.tile.allowLargeTile == b.tile.allowLargeTile &&
         a.adjustment == b.adjustment && a.embedding == b.embedding && a.fcf == b.fcf;
}

}  // namespace

class ScenarioTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everySampleParsesWithItsCounts() {
    const std::vector<std::pair<const char*, std::size_t>> samples = {
        {"fig4a_cone_sphere", 8}, {"fig4b_cone_sphere", 8},     {"fig4c_cone_sphere", 8},
        {"fig4d_cone_sphere", 8}, {"fig7_letters_bottle", 6},   {"fig8b_cone_nose", 8},
        {"fig8c_cone_nose", 8},   {"fig8d_hemisphere_nose", 8}, {"fig8e_hemisphere_nose", 8},
        {"fig9a_cars", 7},        {"fig9b_bird_plane", 5}};
    const fs::path folder = places::samples() / "scenarios";
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
      files += entry.path().extension() == ".json" ? 1 : 0;
    }
    QCOMPARE(files, samples.size());
    for (const auto& [name, pairs] : samples) {
      const fs::path path = folder / (std::string(name) + ".json");
      const Result<Scenario> scenario = parseScenario(readAll(path), path);
      QVERIFY2(scenario, messageOf(scenario).c_str());
      QCOMPARE(scenario->inputs.loop.size(), pairs);
      QVERIFY(scenario->inputs.adjustment == AdjustmentSettings());
      QVERIFY(scenario->inputs.fcf.points().size() >= 4);
      QVERIFY(fs::exists(scenario->part) && fs::exists(scenario->base));
      QVERIFY(!scenario->name.empty());
    }
  }

  void aSampleHasTheCurveOfItsFigure() {
    const fs::path path = places::samples() / "scenarios" / "fig4b_cone_sphere.json";
    QVERIFY(parseScenario(readAll(path), path)->inputs.fcf == FCF::preset(FCF::Preset::Paste));
  }

  void aMinimalScenarioHasTheDefaults() {
    const Scenario scenario = parse(kHead + "}").value();
    QCOMPARE(scenario.name, std::string("some"));
    QCOMPARE(scenario.part, fs::path("folder/a.obj"));
    QCOMPARE(scenario.base, fs::path("folder/b.obj"));
    FusionInputs defaults;
    defaults.loop = {{SurfacePoint::atVertex(0), SurfacePoint::atVertex(1)},
                     {SurfacePoint::atVertex(2), SurfacePoint::atVertex(3)},
                     {SurfacePoint::atVertex(4), SurfacePoint::atVertex(5)}};
    QVERIFY(sameInputs(scenario.inputs, defaults));
    QVERIFY(!scenario.inputs.part && !scenario.inputs.base);
  }

  void everySettingIsRead() {
    const Scenario scenario =
        parse(with(R"("name": "nose", "fcf": [[0, 0.1], [0.3, 0.2], [0.5, 0.9], [1, 0.8]], "monotone": false,
                      "deform_exponent": 4.5, "paths": "paper", "allow_large_tile": true, "note": [1, {}],
                      "unknown": null, "embedding": "low-stretch",
                      "adjustment": {"rigid": false, "scale": false, "line_field": false, "exact_fit": false, "epsilon": 0,
                                     "max_iterations": 7})"))
            .value();
    QCOMPARE(scenario.name, std::string("nose"));
    FusionInputs expected = scenario.inputs;
    expected.paths = PathMode::Paper;
    expected.tile.allowLargeTile = true;
    expected.adjustment = {false, false, false, false, 0, 4.5, 7};
    expected.embedding.method = EmbeddingSettings::Method::LowStretch;
    expected.fcf = FCF::through({{0, 0.1}, {0.3, 0.2}, {0.5, 0.9}, {1, 0.8}}, false).value();
    QVERIFY(sameInputs(scenario.inputs, expected));
    QCOMPARE(parse(with(R"("embedding": "cotangent")"))->inputs.embedding.method,
             EmbeddingSettings::Method::Cotangent);
    QCOMPARE(parse(with(R"("embedding": "mean-value")"))->inputs.embedding.method,
             EmbeddingSettings::Method::MeanValue);
    QCOMPARE(parse(with(R"("paths": "straightened")"))->inputs.paths, PathMode::Straightened);
  }

  void aCurveMayBeAPresetsName() {
    QVERIFY(parse(with(R"("fcf": "half")"))->inputs.fcf == FCF::preset(FCF::Preset::Half));
    const FCF plain = parse(with(R"("fcf": "paste", "monotone": false)"))->inputs.fcf;
    QVERIFY(!plain.monotone());
    QVERIFY(plain.points() == FCF::preset(FCF::Preset::Paste).points());
  }

  void aCvMayBeAPointOfAFace() {
    const Scenario scenario =
        parse(R"({"m1": "a", "m2": "b", "cvp": [[{"face": 7, "bary": [0.25, 0.5, 0.25]}, 9]]})").value();
    const CVP expected = {{-1, 7, {0.25, 0.5, 0.25}}, SurfacePoint::atVertex(9)};
    QVERIFY(scenario.inputs.loop == Loop{expected});
  }

  void anAbsoluteMeshPathStaysAsItIs() {
    const Scenario scenario = parse(R"({"m1": "/x/a.obj", "m2": "../b.obj", "cvp": []})").value();
    QCOMPARE(scenario.part, fs::path("/x/a.obj"));
    QCOMPARE(scenario.base, fs::path("folder/../b.obj"));
  }

  void missingKeysAreNamed() {
    mustFail("{}", "\"m1\" is missing");
    mustFail(R"({"m1": "a"})", "\"m2\" is missing");
    mustFail(R"({"m1": "a", "m2": "b"})", "\"cvp\" is missing");
  }

  void unknownSettingsOfTheAdjustmentAreNamed() {
    mustFail(
        with(R"("adjustment": {"rigid": true, "exactfit": false})"),
        "\"adjustment.exactfit\" is no setting; \"adjustment\" takes rigid, scale, line_field, exact_fit, "
        "epsilon, max_iterations.");
    mustFail(with("\"adjustment\": {\"\\u001b[31m\": {\"a\": 1}}"), "\"adjustment.\\x1b[31m\" is no setting");
  }

  void keysGivenTwiceAreNamed() {
    mustFail(with(R"("m1": "c.obj")"), "\"m1\" is given twice; leave one of them out.");
    mustFail(with(R"("adjustment": {"rigid": true, "scale": true, "rigid": true})"),
             "\"adjustment.rigid\" is given twice");
    mustFail(with(R"("adjustment": {"rigid": true}, "adjustment": {"rigid": true})"),
             "\"adjustment\" is given twice");
    mustFail(R"({"m1": "a", "m2": "b", "cvp": [[0, 1], [2, {"face": 5, "bary": [1, 0, 0], "face": 6}]]})",
             "\"cvp.face\" is given twice");
    QVERIFY(parse(with(R"("note": {"a": 1, "a": 2, "adjustment": {"b": 3, "b": 4}}, "fcf": "paste")")));
  }

  void wrongTypesAreNamedWithWhatWasExpected() {
    mustFail("[]", "JSON object");
    mustFail("3", "JSON object");
    mustFail(R"({"m1": 3, "m2": "b", "cvp": []})", "\"m1\"");
    mustFail(R"({"m1": "", "m2": "b", "cvp": []})", "\"m1\"");
    mustFail(R"({"m1": "a\u0000b", "m2": "b", "cvp": []})", "\"m1\"");
    mustFail(R"({"m1": "a", "m2": ["b"], "cvp": []})", "\"m2\"");
    mustFail(R"({"m1": "a", "m2": "b", "cvp": {"0": [1, 2]}})", "\"cvp\"");
    mustFail(with(R"("name": 3)"), "\"name\" must be a text");
    mustFail(with(R"("monotone": "yes")"), "\"monotone\" must be true or false");
    mustFail(with(R"("allow_large_tile": 1)"), "\"allow_large_tile\"");
    mustFail(with(R"("deform_exponent": "5")"), "\"deform_exponent\"");
    mustFail(with(R"("paths": "shortest")"), "\"straightened\", \"paper\"");
    mustFail(with(R"("paths": 1)"), "\"paths\"");
    mustFail(with(R"("embedding": "harmonic")"), "\"embedding\" must be one of \"automatic\"");
    mustFail(with(R"("adjustment": true)"), "\"adjustment\"");
    mustFail(with(R"("adjustment": {"rigid": 1})"), "\"adjustment.rigid\"");
    mustFail(with(R"("adjustment": {"epsilon": null})"), "\"adjustment.epsilon\"");
  }

  void settingsOutOfRangeAreNamed() {
    for (const char* value : {"0", "-5", "-0.0"}) {
      mustFail(with(std::string("\"deform_exponent\": ") + value), "\"deform_exponent\"");
    }
    mustFail(with(R"("adjustment": {"epsilon": -0.001})"), "\"adjustment.epsilon\"");
    for (const char* value : {"0", "-1", "1.5", "3000000000", "1e9"}) {
      mustFail(with(std::string(R"("adjustment": {"max_iterations": )") + value + "}"),
               "\"adjustment.max_iterations\"");
    }
  }

  void entriesOfCvpThatAreNoPairAreNamed() {
    for (const char* entry : {"[5]", "[1, 2, 3]", "[]", "5", "null", "\"1,2\"", "{\"part\": 1}"}) {
      mustFail(std::string(R"({"m1": "a", "m2": "b", "cvp": [[0, 0], )") + entry + "]}", "\"cvp[1]\"");
    }
  }

  void numbersThatAreNoVertexAreNamedWithEntryAndSide() {
    for (const char* number : {"-1", "1.5", "2.0", "1e300", "1e2", "2147483648", "99999999999999999999999",
                               "\"3\"", "true", "null", "[1]"}) {
      const std::string text = std::string(R"({"m1": "a", "m2": "b", "cvp": [[0, 0], [1, )") + number + "]]}";
      mustFail(text, "\"cvp[1][1]\" must be a vertex number of the base");
    }
    mustFail(R"({"m1": "a", "m2": "b", "cvp": [[-1, 0]]})",
             "\"cvp[0][0]\" must be a vertex number of the part");
  }

  void pointsOfFacesThatAreNoneAreNamed() {
    for (const char* point :
         {R"({"face": 1})", R"({"bary": [1, 0, 0]})", R"({"face": 1, "bary": [1, 0]})",
          R"({"face": 1, "bary": [1, 0, 0, 0]})", R"({"face": 1, "bary": "1 0 0"})", "{}"}) {
      mustFail(std::string(R"({"m1": "a", "m2": "b", "cvp": [[)") + point + ", 0]]}", "\"cvp[0][0]\"");
    }
    mustFail(R"({"m1": "a", "m2": "b", "cvp": [[{"face": -1, "bary": [1, 0, 0]}, 0]]})",
             "\"cvp[0][0].face\"");
    mustFail(R"({"m1": "a", "m2": "b", "cvp": [[0, {"face": 1, "bary": [1, null, 0]}]]})",
             "\"cvp[0][1].bary[1]\"");
  }

  void curvesOfAWrongShapeAreNamed() {
    mustFail(with(R"("fcf": "bump")"), "\"fcf\"");
    mustFail(with(R"("fcf": {"0": 1})"), "\"fcf\"");
    mustFail(with(R"("fcf": [[0, 0], [0.3], [0.6, 0.5], [1, 1]])"), "\"fcf[1]\"");
    mustFail(with(R"("fcf": [[0, 0], [0.3, 0, 1], [0.6, 0.5], [1, 1]])"), "\"fcf[1]\"");
    mustFail(with(R"("fcf": [[0, 0], [0.3, "0"], [0.6, 0.5], [1, 1]])"), "\"fcf[1][1]\"");
    mustFail(with(R"("fcf": [0, 0, 1, 1])"), "\"fcf[0]\"");
  }

  void theCurvesOwnErrorsAreKept() {
    mustFail(with(R"("fcf": [[0, 0], [0.3, 0], [1, 1]])"), "fcf", ErrorCode::CurveTooShort);
    mustFail(with(R"("fcf": [[0.1, 0], [0.3, 0], [0.5, 0], [1, 1]])"), "point 0", ErrorCode::CurveEndsWrong);
    mustFail(with(R"("fcf": [[0, 0], [0.3, 0], [0.3, 0], [1, 1]])"), "point 2",
             ErrorCode::CurveNotIncreasing);
    mustFail(with(R"("fcf": [[0, 0], [0.3, 2], [0.5, 0], [1, 1]])"), "point 1", ErrorCode::CurveOutOfRange);
  }

  void numbersMustBeFinite() {
    mustFail(with(R"("deform_exponent": 1e999)"), "");
    mustFail(with(R"("deform_exponent": NaN)"), "line 1");
    mustFail(with(R"("fcf": [[0, 0], [0.3, Infinity], [0.5, 0], [1, 1]])"), "line 1");
  }

  void brokenJsonNamesItsLine() {
    mustFail("{\n\"m1\": \"a\",\n\"m2\": }", "line 3");
    mustFail(with(R"("deform_exponent": 1e99999)"), "not valid JSON: number overflow parsing '1e99999'");
    mustFail("", "line 1");
    mustFail("{\"m1\": \"a\"", "line 1");
    mustFail(kHead + "} trailing", "line 1");
    mustFail(kHead + ",\n// comment\n}", "line 2");
  }

  void hostileNestingIsRefused() {
    mustFail(std::string(1000000, '['), "nested");
    mustFail(with("\"note\": " + std::string(100000, '[') + std::string(100000, ']')), "nested");
    std::string objects;
    for (int i = 0; i < 100000; ++i) {
      objects += "{\"a\":";
    }
    mustFail(objects, "nested");
    const std::string harmless = with("\"note\": \"" + std::string(1000, '[') + "\\\"{\"");
    QVERIFY2(parse(harmless), messageOf(parse(harmless)).c_str());
  }

  void strangeBytesDoNotGetIntoTheMessage() {
    const std::string bytes = std::string("{\"m1\": \"a\xff\xfe") + '\0' + "\x1b[31m\", \"m2\": \"b\"}";
    const Result<Scenario> result = parseScenario(bytes, "bad\xffname\n.json");
    QCOMPARE(result.error().code, ErrorCode::ScenarioMalformed);
    for (const char c : result.error().message) {
      QVERIFY(static_cast<unsigned char>(c) >= 0x20 && c != '\xff' && c != '\xfe');
    }
    QVERIFY(contains(result.error().message, "bad\\xffname\\x0a.json"));
    QVERIFY(!parse(std::string("\0\0\0", 3)));
  }

  void printableKeepsTextAndEscapesTheRest() {
    QCOMPARE(printable("Größe ✓ 𝄞"), std::string("Größe ✓ 𝄞"));
    QCOMPARE(printable("a\n\x7f\xc3"), std::string("a\\x0a\\x7f\\xc3"));
    QCOMPARE(printable("\xc0\xaf\xed\xa0\x80\xf5"), std::string("\\xc0\\xaf\\xed\\xa0\\x80\\xf5"));
    QCOMPARE(printable("abcdef", 3), std::string("abc…"));
  }

  void whatIsFormattedParsesBackTheSame() {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 50; ++i) {
      Scenario scenario;
      scenario.name = "näme \"quoted\" \n";
      scenario.part = "some/folder/../models/part.obj";
      scenario.base = i % 2 == 0 ? "/absolute/base.ply" : "some/folder/base.ply";
      const double a = unit(random);
      scenario.inputs.loop = {{SurfacePoint::atVertex(i), {-1, 2 * i, {a, unit(random), 1 - a}}},
                              {{-1, 0, {1e-300, 1, 0.1 + 0.2}}, SurfacePoint::atVertex(2147483647)}};
      scenario.inputs.paths = i % 2 == 0 ? PathMode::Paper : PathMode::Straightened;
      scenario.inputs.tile.allowLargeTile = i % 3 == 0;
      scenario.inputs.adjustment = {.rigid = i % 2 == 0,
                                    .scale = i % 3 == 0,
                                    .lineField = i % 5 == 0,
                                    .exactFit = i % 7 == 0,
                                    .epsilon = unit(random),
                                    .falloff = 5 * unit(random),
                                    .maxIterations = 1 + i};
      scenario.inputs.embedding.method = static_cast<EmbeddingSettings::Method>(i % 4);
      scenario.inputs.fcf =
          FCF::through({{0, unit(random)}, {0.1 + 0.2 * unit(random), unit(random)}, {0.7, 1.0 / 3}, {1, 0}},
                       i % 2 == 0)
              .value();
      const fs::path path = "some/folder/x.json";
      const Result<Scenario> back = parseScenario(formatScenario(scenario, path), path);
      QVERIFY2(back, messageOf(back).c_str());
      QCOMPARE(back->name, scenario.name);
      QCOMPARE(back->part, scenario.part);
      QCOMPARE(back->base, scenario.base);
      QVERIFY(sameInputs(back->inputs, scenario.inputs));
    }
  }
};

QTEST_APPLESS_MAIN(ScenarioTest)
#include "scenario_test.moc"
