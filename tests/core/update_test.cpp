#include "core/fusion/update.h"

#include <QtTest>
#include <algorithm>
#include <cstring>

#include "core/base/parallel.h"
#include "core/fusion/verify.h"
#include "tests/support/samples.h"
#include "tests/support/surface_distance.h"

using namespace graftsman;

namespace {

void addScenarioRows() {
  QTest::addColumn<QString>("scenario");
  for (const std::string& name : samples::kScenarios) {
    QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
}

FCF constant(double f) {
  return *FCF::through({{0, f}, {0.3, f}, {0.6, f}, {1, f}});
}

bool sameBits(const FusedMesh& a, const FusedMesh& b) {
  return a.points.size() == b.points.size() && a.faces() == b.faces() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)) == 0;
}

FusionResults fuseAll(const FusionInputs& inputs) {
  return update(inputs, {}, {});
}

std::vector<Stage> stagesRun(const FusionResults& results) {
  std::vector<Stage> stages;
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    if (results.runs[i].ran) {
      stages.push_back(static_cast<Stage>(i));
    }
  }
  return stages;
}

}  // namespace

class UpdateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyScenarioHoldsTheInvariants_data() { addScenarioRows(); }
  void everyScenarioHoldsTheInvariants() {
    QFETCH(QString, scenario);
    const FusionResults results = fuseAll(samples::load(scenario.toStdString()));
    QVERIFY2(!results.error, results.error ? results.error->message.c_str() : "");
    const Verification verification = verify(results);
    QCOMPARE(verification.changedBaseVertices, 0);
    QVERIFY(verification.topologyKept());
    QCOMPARE(verification.invertedFaces, 0);
    QVERIFY(verification.embeddedAreaError <= 1e-12);
    QVERIFY(verification.baseDistance <= 1e-12);
    QVERIFY(verification.partDistance <= 1e-12);
    QVERIFY(verification.baseAreaError <= 1e-9);
    QVERIFY(verification.holds());
  }

  void aVerificationSaysWhatDoesNotHold() {
    Verification verification;
    QVERIFY(verification.holds());
    verification.invertedFaces = 3;
    verification.partDistance = 0.0123456;
    QVERIFY(!verification.holds());
    QCOMPARE(verification.broken(),
             "3 faces of the combined tile are turned over, the combined tile leaves the adjusted part by "
             "0.0123 of "
             "the base's diagonal");
    verification.changedBaseVertices = 2;
    QVERIFY(verification.broken().starts_with("2 vertices of the base outside the tile moved, 3 faces"));
  }

  void withTheZeroCurveTheResultIsTheBasesSurface_data() { addScenarioRows(); }
  void withTheZeroCurveTheResultIsTheBasesSurface() {
    QFETCH(QString, scenario);
    FusionInputs inputs = samples::load(scenario.toStdString());
    inputs.fcf = constant(0);
    const FusionResults results = fuseAll(inputs);
    QVERIFY(results.fused);
    const double tolerance = 1e-12 * inputs.base->diagonal();
    const SurfaceDistance toBase(inputs.base->points(), inputs.base->faces());
    const SurfaceDistance toResult(results.fused->points, results.fused->faces());
    QVERIFY(toBase.greatestTo(results.fused->points, results.fused->faces()) <= tolerance);
    QVERIFY(toResult.greatestTo(inputs.base->points(), inputs.base->faces()) <= tolerance);
  }

  void withTheCurveOfOnesTheCombinedTileLiesOnTheAdjustedPart_data() { addScenarioRows(); }
  void withTheCurveOfOnesTheCombinedTileLiesOnTheAdjustedPart() {
    QFETCH(QString, scenario);
    FusionInputs inputs = samples::load(scenario.toStdString());
    inputs.fcf = constant(1);
    const FusionResults results = fuseAll(inputs);
    QVERIFY(results.fused);
    const SurfaceDistance toPart(results.fitted->points, results.fitted->faces);
    double greatest = 0;
    for (const Index v : results.join->tileVertices) {
      greatest = std::max(greatest, toPart(results.fused->points[static_cast<std::size_t>(v)]));
    }
    QVERIFY2(greatest <= 1e-12 * inputs.base->diagonal(), qPrintable(QString::number(greatest)));
  }

  void theTilesAreThoseOfTheTableWithinTheStraightenedBoundary_data() { addScenarioRows(); }
  void theTilesAreThoseOfTheTableWithinTheStraightenedBoundary() {
    QFETCH(QString, scenario);
    const FusionResults results = fuseAll(samples::load(scenario.toStdString()));
    QVERIFY(results.fused);
    // Euler: a disk of v vertices, f faces and b boundary edges has f = 2v − b − 2.
    const Tile& tile = *results.base.tile;
    QCOMPARE(static_cast<Index>(tile.faces.size()),
             2 * static_cast<Index>(tile.points.size()) - tile.boundarySize - 2);
    const CombinedTile& combined = *results.combined;
    QCOMPARE(static_cast<Index>(combined.faces.size()),
             2 * static_cast<Index>(combined.part.size()) - combined.seamSize - 2);
  }

  void anEditOfTheCurveRunsTheBlendAlone() {
    FusionInputs inputs = samples::load("fig8b_cone_nose");
    const FusionResults first = fuseAll(inputs);
    inputs.fcf = FCF::preset(FCF::Preset::Half);
    const FusionResults second = update(inputs, first, {});
    QCOMPARE(stagesRun(second), std::vector<Stage>{Stage::Blend});
    QCOMPARE(second.join, first.join);
    QCOMPARE(second.combined, first.combined);
    QVERIFY(second.fused != first.fused);
    QVERIFY(sameBits(*second.fused, *fuseAll(inputs).fused));
  }

  void equalInputsRunNothing() {
    const FusionInputs inputs = samples::load("fig4a_cone_sphere");
    const FusionResults first = fuseAll(inputs);
    const FusionResults second = update(inputs, first, {});
    QVERIFY(stagesRun(second).empty());
    QCOMPARE(second.fused, first.fused);
  }

  void aMovedBaseCvLeavesThePartsTileAndTheOtherPathsAlone() {
    FusionInputs inputs = samples::load("fig9b_bird_plane");
    const FusionResults first = fuseAll(inputs);
    const TriangleMesh& base = *inputs.base;
    const Index moved = base.to(base.outgoing(inputs.loop[2].base.vertex));
    inputs.loop[2].base = SurfacePoint::atVertex(moved);
    const FusionResults second = update(inputs, first, {});
    QVERIFY(second.fused);
    QCOMPARE(second.part.anchored, first.part.anchored);
    QCOMPARE(second.part.paths, first.part.paths);
    QCOMPARE(second.part.tile, first.part.tile);
    for (const std::size_t i : {0U, 3U, 4U}) {
      QCOMPARE(second.base.paths->direct[i], first.base.paths->direct[i]);
    }
    for (const std::size_t i : {1U, 2U}) {
      QVERIFY(second.base.paths->direct[i] != first.base.paths->direct[i]);
    }
    QVERIFY(second.base.tile != first.base.tile);
    QVERIFY(second.adjustment != first.adjustment);
    QVERIFY(sameBits(*second.fused, *fuseAll(inputs).fused));
  }

  void anEditOfTheAdjustmentKeepsTheBasesSide() {
    FusionInputs inputs = samples::load("fig7_letters_bottle");
    const FusionResults first = fuseAll(inputs);
    inputs.adjustment.lineField = false;
    const FusionResults second = update(inputs, first, {});
    const std::vector<Stage> expected = {Stage::Adjust,  Stage::Fit,  Stage::Embed,
                                         Stage::Overlay, Stage::Join, Stage::Blend};
    QCOMPARE(stagesRun(second), expected);
    QCOMPARE(second.base.embedding, first.base.embedding);
    QCOMPARE(second.part.tile, first.part.tile);
    QVERIFY(second.part.embedding != first.part.embedding);
  }

  void withoutTheExactFitTheAdjustedPartIsLeftAsThePapersStepsMadeIt_data() { addScenarioRows(); }
  void withoutTheExactFitTheAdjustedPartIsLeftAsThePapersStepsMadeIt() {
    QFETCH(QString, scenario);
    FusionInputs inputs = samples::load(scenario.toStdString());
    inputs.adjustment.exactFit = false;
    inputs.paths = PathMode::Paper;
    inputs.fcf = constant(1);
    const FusionResults results = fuseAll(inputs);
    QVERIFY2(results.fused, results.error ? results.error->message.c_str() : "");
    QCOMPARE(results.fitted->points, results.adjustment->points);
    const Verification verification = verify(results);
    QVERIFY(verification.holds());
    const SurfaceDistance toPart(results.adjustment->points, results.part.tile->faces);
    double greatest = 0;
    for (const Index v : results.join->tileVertices) {
      greatest = std::max(greatest, toPart(results.fused->points[static_cast<std::size_t>(v)]));
    }
    QVERIFY2(greatest <= 1e-12 * inputs.base->diagonal(), qPrintable(QString::number(greatest)));
  }

  void theExactFitBringsBothBoundariesTogether_data() { addScenarioRows(); }
  void theExactFitBringsBothBoundariesTogether() {
    QFETCH(QString, scenario);
    const FusionInputs inputs = samples::load(scenario.toStdString());
    const FusionResults results = fuseAll(inputs);
    QVERIFY(results.fused);
    QVERIFY(results.fitted->meanDistance > 0);
    for (Index i = 0; i < results.combined->seamSize; ++i) {
      const auto v = static_cast<std::size_t>(i);
      QVERIFY((results.combined->part[v] - results.combined->base[v]).norm() <=
              1e-12 * inputs.base->diagonal());
    }
  }

  void anEditOfThePathModeKeepsTheAnchors() {
    FusionInputs inputs = samples::load("fig4a_cone_sphere");
    const FusionResults first = fuseAll(inputs);
    inputs.paths = PathMode::Paper;
    const FusionResults second = update(inputs, first, {});
    QVERIFY(second.fused);
    QCOMPARE(second.part.anchored, first.part.anchored);
    QVERIFY(second.part.paths != first.part.paths);
    QVERIFY(verify(second).holds());
  }

  void afterAFailureWhatFinishedIsTakenOver() {
    FusionInputs inputs = samples::load("fig4a_cone_sphere");
    const FusionResults good = fuseAll(inputs);
    FusionInputs bad = inputs;
    bad.loop[1].base = bad.loop[0].base;
    const FusionResults failed = update(bad, good, {});
    QVERIFY(failed.error);
    QCOMPARE(failed.error->code, ErrorCode::LoopRepeatsPoint);
    QCOMPARE(failed.failedAt, Stage::Anchor);
    QCOMPARE(*failed.error->side, Side::Base);
    QVERIFY(!failed.fused);
    QCOMPARE(failed.part.tile, good.part.tile);
    const FusionResults again = update(inputs, failed, {});
    QVERIFY(again.fused);
    QCOMPARE(again.part.tile, good.part.tile);
    QVERIFY(sameBits(*again.fused, *good.fused));
  }

  void aCancelAtAnyProgressCallIsGoneOnFrom_data() { addScenarioRows(); }
  void aCancelAtAnyProgressCallIsGoneOnFrom() {
    QFETCH(QString, scenario);
    const FusionInputs inputs = samples::load(scenario.toStdString());
    int calls = 0;
    double last = 0;
    bool monotone = true;
    const auto count = [&](double done) {
      monotone = monotone && done >= last && done <= 1;
      last = done;
      ++calls;
      return true;
    };
    const FusionResults whole = update(inputs, {}, Progress(count, std::chrono::nanoseconds(0)));
    QVERIFY(whole.fused);
    QVERIFY(monotone);
    QVERIFY(calls >= kStageCount);
    constexpr int kMostTried = 40;
    const int stride = std::max(1, calls / kMostTried);
    int cancelled = 0;
    for (int k = 1; k <= calls; k += stride) {
      int call = 0;
      const Progress stop([&](double) { return ++call < k; }, std::chrono::nanoseconds(0));
      const FusionResults part = update(inputs, {}, stop);
      if (part.fused) {
        continue;  // threads may share out the calls otherwise than in the counted run
      }
      ++cancelled;
      QVERIFY(part.error);
      QCOMPARE(part.error->code, ErrorCode::Cancelled);
      const FusionResults rest = update(inputs, part, {});
      QVERIFY(rest.fused);
      QVERIFY(sameBits(*rest.fused, *whole.fused));
      if (part.part.tile) {
        QCOMPARE(rest.part.tile, part.part.tile);
      }
    }
    QVERIFY(cancelled > 0);
  }

  void theNumberOfThreadsNeverShows_data() { addScenarioRows(); }
  void theNumberOfThreadsNeverShows() {
    QFETCH(QString, scenario);
    const FusionInputs inputs = samples::load(scenario.toStdString());
    setThreadCount(1);
    const FusionResults one = fuseAll(inputs);
    setThreadCount(3);
    const FusionResults three = fuseAll(inputs);
    setThreadCount(0);
    QVERIFY(one.fused && three.fused);
    QVERIFY(sameBits(*one.fused, *three.fused));
  }

  void aModelsUnitNeverShowsInTheOutcome_data() {
    QTest::addColumn<double>("scale");
    QTest::newRow("a thousandth") << 1.0 / 1024;
    QTest::newRow("a million") << 1048576.0;
  }
  void aModelsUnitNeverShowsInTheOutcome() {
    QFETCH(double, scale);
    const FusionInputs inputs = samples::load("fig9b_bird_plane");
    FusionInputs scaled = inputs;
    for (auto* mesh : {&scaled.part, &scaled.base}) {
      std::vector<Point> points = (*mesh)->points();
      for (Point& p : points) {
        p *= scale;
      }
      *mesh = std::make_shared<TriangleMesh>(std::move(points), (*mesh)->faces());
    }
    const FusionResults one = fuseAll(inputs);
    const FusionResults other = fuseAll(scaled);
    QVERIFY(one.fused && other.fused);
    QCOMPARE(other.fused->faces(), one.fused->faces());
    for (std::size_t i = 0; i < one.fused->points.size(); ++i) {
      QVERIFY((other.fused->points[i] / scale - one.fused->points[i]).norm() <=
              1e-9 * inputs.base->diagonal());
    }
  }

  void aTinyModelFarFromTheOriginFuses() {
    FusionInputs inputs = samples::load("fig4c_cone_sphere");
    for (auto* mesh : {&inputs.part, &inputs.base}) {
      std::vector<Point> points = (*mesh)->points();
      for (Point& p : points) {
        p = 1e-4 * p + Point(100, 200, 300);
      }
      *mesh = std::make_shared<TriangleMesh>(std::move(points), (*mesh)->faces());
    }
    const FusionResults results = fuseAll(inputs);
    QVERIFY2(results.fused, results.error ? results.error->message.c_str() : "");
    QVERIFY(verify(results).holds());
  }

  void aMeshBeyondDoublePrecisionIsRefused_data() {
    QTest::addColumn<double>("scale");
    QTest::newRow("huge") << 1e300;
    QTest::newRow("tiny") << 1e-160;
    QTest::newRow("a point") << 0.0;
  }
  void aMeshBeyondDoublePrecisionIsRefused() {
    QFETCH(double, scale);
    FusionInputs inputs = samples::load("fig4a_cone_sphere");
    std::vector<Point> points = inputs.base->points();
    for (Point& p : points) {
      p *= scale;
    }
    inputs.base = std::make_shared<TriangleMesh>(std::move(points), inputs.base->faces());
    const FusionResults results = fuseAll(inputs);
    QVERIFY(results.error);
    QCOMPARE(results.error->code, ErrorCode::MeshOutOfRange);
  }

  void aClockwiseLoopIsRefusedWithTheRemedy() {
    FusionInputs inputs = samples::load("fig9b_bird_plane");
    std::reverse(inputs.loop.begin(), inputs.loop.end());
    const FusionResults results = fuseAll(inputs);
    QVERIFY(results.error);
    QCOMPARE(results.error->code, ErrorCode::TileClockwise);
    QVERIFY(results.error->message.find("everse") != std::string::npos);
    inputs.tile.allowLargeTile = true;
    QVERIFY(verify(update(inputs, results, {})).holds());
  }
};

QTEST_APPLESS_MAIN(UpdateTest)
#include "update_test.moc"
