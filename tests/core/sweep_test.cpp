#include <QtTest>
#include <set>

#include "core/io/mesh_file.h"
#include "core/sweep/sweep_folder.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/sweeps.h"

using namespace graftsman;

class SweepTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
};

QTEST_APPLESS_MAIN(SweepTest)
#include "sweep_test.moc"
