#include <QSignalSpy>
#include <QtTest>
#include <memory>

#include "app/document/stage_runner.h"
#include "tests/support/documents.h"

using namespace graftsman;

namespace {
constexpr int kPatienceMs = 60'000;
}

class StageRunnerTest : public QObject {
  Q_OBJECT

 private:
  // A runner, and the outcomes that it told.
  struct Run {
    StageRunner runner;
    std::vector<std::shared_ptr<const Outcome>> told;

    Run() {
      connect(&runner, &StageRunner::finished, &runner,
              [this](const std::shared_ptr<const Outcome>& outcome) { told.push_back(outcome); });
    }
    void request(const Fusion& fusion, StageRunner::Urgency urgency) {
      runner.request(samples::documentOf(fusion), fusion.id, urgency);
    }
    // The last outcome, once the runner is idle; null: there was none.
    std::shared_ptr<const Outcome> settle() {
      if (!QTest::qWaitFor([this] { return !runner.busy(); }, kPatienceMs) || told.empty()) {
        return nullptr;
      }
      return told.back();
    }
  };

 private Q_SLOTS:
  void aClosedLoopGivesWhatUpdateGives() {
    Run run;
    const Fusion fusion = samples::fusion("fig4c_cone_sphere");
    run.request(fusion, StageRunner::Urgency::Edit);
    QVERIFY(run.runner.busy());
    const auto outcome = run.settle();
    QVERIFY(outcome && outcome->results && outcome->results->fused);
    QVERIFY(outcome->results->fused->points == update(fusion.inputs, {}, {}).fused->points);
    QVERIFY(outcome->fusion == fusion);
  }

  void anOpenLoopGivesItsPaths() {
    Run run;
    Fusion fusion = samples::fusion("fig8b_cone_nose");
    fusion.closed = false;
    run.request(fusion, StageRunner::Urgency::Edit);
    const auto outcome = run.settle();
    QVERIFY(outcome && !outcome->results);
    QCOMPARE(outcome->openBase->paths.size(), fusion.inputs.loop.size() - 1);
    QVERIFY(!outcome->openBase->error);
  }

  void aLoopThatFailsOnOneMeshKeepsWhatTheOtherHas() {
    Run run;
    Fusion fusion = samples::fusion("fig8b_cone_nose");
    fusion.inputs.loop[1].base = fusion.inputs.loop[2].base;
    run.request(fusion, StageRunner::Urgency::Edit);
    const auto outcome = run.settle();
    QVERIFY(outcome && outcome->results && outcome->results->error);
    QCOMPARE(outcome->results->error->code, ErrorCode::LoopRepeatsPoint);
    QVERIFY(!outcome->results->fused);
    QVERIFY(outcome->results->part.paths && !outcome->openPart);
    QVERIFY(!outcome->results->base.paths && outcome->openBase);
  }

  void theNewestInputsWin() {
    Run run;
    Fusion fusion = samples::fusion("fig9b_bird_plane");
    for (int i = 0; i < 20; ++i) {
      fusion.inputs.adjustment.falloff = 3 + i;
      run.request(fusion, StageRunner::Urgency::Edit);
    }
    const auto outcome = run.settle();
    QVERIFY(outcome && outcome->fusion == fusion);
    QVERIFY(outcome->results->fused->points == update(fusion.inputs, {}, {}).fused->points);
    QVERIFY(run.told.size() < 20);
  }

  void aDragIsSeenOnItsWay() {
    Run run;
    Fusion fusion = samples::fusion("fig9b_bird_plane");
    QSignalSpy finished(&run.runner, &StageRunner::finished);
    for (int i = 0; i < 5; ++i) {
      fusion.inputs.adjustment.falloff = 3 + i;
      run.request(fusion, StageRunner::Urgency::Drag);
      // The next move comes before this one is done.
      fusion.inputs.adjustment.falloff = 3.5 + i;
      run.request(fusion, StageRunner::Urgency::Drag);
      QVERIFY(finished.wait(kPatienceMs));
    }
    QVERIFY(run.settle()->fusion == fusion);
  }

  void anEditOfTheCurveNeverCancelsARun() {
    Run run;
    Fusion fusion = samples::fusion("fig8b_cone_nose");
    run.request(fusion, StageRunner::Urgency::Edit);
    fusion.inputs.fcf = FCF::preset(FCF::Preset::Half);
    run.request(fusion, StageRunner::Urgency::Edit);
    const auto outcome = run.settle();
    QVERIFY(outcome && outcome->fusion == fusion);
    QVERIFY(!outcome->cancelled);
  }

  void cancelLeavesEverythingUsable() {
    const Fusion fusion = samples::fusion("fig9b_bird_plane");
    std::unique_ptr<Run> run;
    const auto cancelled = [&] {
      run = std::make_unique<Run>();
      run->request(fusion, StageRunner::Urgency::Edit);
      run->runner.cancel();
      const auto outcome = run->settle();
      return outcome && outcome->cancelled;
    };
    // On a busy machine a run may be over before this thread gets to cancel it.
    bool once = false;
    for (int attempt = 0; attempt < 20 && !once; ++attempt) {
      once = cancelled();
    }
    QVERIFY(once);
    run->request(fusion, StageRunner::Urgency::Edit);
    const auto outcome = run->settle();
    QVERIFY(!outcome->cancelled);
    QVERIFY(outcome->results->fused);
  }

  void cancelWithNothingUnderWayIsNothing() {
    Run run;
    run.runner.cancel();
    QCoreApplication::processEvents();
    QVERIFY(run.told.empty());
    QVERIFY(!run.runner.busy());
  }

  void theAdjustmentRunsAgainWhenAsked() {
    Run run;
    const Fusion fusion = samples::fusion("fig8d_hemisphere_nose");
    run.request(fusion, StageRunner::Urgency::Edit);
    const auto first = run.settle();
    run.runner.requestAdjustment(samples::documentOf(fusion), fusion.id);
    const auto second = run.settle();
    QVERIFY(first->results->adjustment != second->results->adjustment);
    QVERIFY(second->results->run(Stage::Adjust).ran);
    QVERIFY(!second->results->run(Stage::Paths).ran);
    QVERIFY(first->results->fused->points == second->results->fused->points);
  }

  void aRunnerGoesAwayInTheMiddleOfARun() {
    for (int i = 0; i < 10; ++i) {
      StageRunner runner;
      runner.request(samples::documentOf(samples::fusion("fig9b_bird_plane")), 1, StageRunner::Urgency::Edit);
    }
  }
};

QTEST_GUILESS_MAIN(StageRunnerTest)
#include "stage_runner_test.moc"
