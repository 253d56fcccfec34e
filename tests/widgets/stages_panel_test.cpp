#include <QTableWidget>
#include <QtTest>

#include "tests/support/samples.h"
#include "widgets/panels/stages_panel.h"

using namespace graftsman;

class StagesPanelTest : public QObject {
  Q_OBJECT

 private:
  static QString state(const StagesPanel& panel, Stage stage) {
    return panel.findChild<QTableWidget*>("stagesTable")->item(static_cast<int>(stage), 1)->text();
  }

 private Q_SLOTS:
  void aFirstRunRanEverywhere() {
    StagesPanel panel;
    panel.setResults(update(samples::load("fig4c_cone_sphere"), {}, {}));
    for (int i = 0; i < kStageCount; ++i) {
      QCOMPARE(state(panel, static_cast<Stage>(i)), QString("ran"));
    }
  }

  void anEditOfTheCurveReusesAllButTheBlend() {
    FusionInputs inputs = samples::load("fig4c_cone_sphere");
    const FusionResults before = update(inputs, {}, {});
    inputs.fcf = FCF::preset(FCF::Preset::Half);
    StagesPanel panel;
    panel.setResults(update(inputs, before, {}));
    for (int i = 0; i < kStageCount; ++i) {
      const auto stage = static_cast<Stage>(i);
      QCOMPARE(state(panel, stage), stage == Stage::Blend ? QString("ran") : QString("reused"));
    }
  }

  void aFailureIsAtItsStageAndWhatFollowsIsNotReached() {
    FusionInputs inputs = samples::load("fig8b_cone_nose");
    std::reverse(inputs.loop.begin(), inputs.loop.end());
    StagesPanel panel;
    const FusionResults results = update(inputs, {}, {});
    QVERIFY(results.error);
    panel.setResults(results);
    QCOMPARE(state(panel, results.failedAt), QString("failed"));
    QCOMPARE(state(panel, Stage::Overlay), QString("not reached"));
    auto* table = panel.findChild<QTableWidget*>("stagesTable");
    QCOMPARE(table->item(static_cast<int>(results.failedAt), 1)->toolTip().toStdString(),
             results.error->message);
  }

  void theStageThatRunsSaysSo() {
    StagesPanel panel;
    panel.setRunning(Stage::Embed);
    QCOMPARE(state(panel, Stage::Embed), QString("running"));
    panel.setRunning(Stage::Overlay);
    QCOMPARE(state(panel, Stage::Embed), QString("not reached"));
    panel.setRunning({});
    QCOMPARE(state(panel, Stage::Overlay), QString("not reached"));
  }
};

QTEST_MAIN(StagesPanelTest)
#include "stages_panel_test.moc"
