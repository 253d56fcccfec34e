#include <QAbstractButton>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QtTest>

#include "widgets/panels/adjustment_panel.h"

using namespace graftsman;

class AdjustmentPanelTest : public QObject {
  Q_OBJECT

 private:
  struct Panel {
    AdjustmentPanel panel;
    std::vector<AdjustmentSettings> edited;

    Panel() {
      connect(&panel, &AdjustmentPanel::settingsEdited, &panel,
              [this](const AdjustmentSettings& settings) { edited.push_back(settings); });
      panel.resize(320, 300);
      panel.show();
    }
    template <class T>
    T* find(const char* name) {
      return panel.findChild<T*>(name);
    }
  };

 private Q_SLOTS:
  void whatIsShownByCodeIsNoEdit() {
    Panel p;
    AdjustmentSettings settings;
    settings.scale = false;
    settings.falloff = 7;
    settings.epsilon = 0.02;
    p.panel.setSettings(settings);
    QVERIFY(p.edited.empty());
    QVERIFY(!p.find<QCheckBox>("scaleStep")->isChecked());
    QCOMPARE(p.find<QDoubleSpinBox>("falloff")->value(), 7.0);
    QCOMPARE(p.find<QDoubleSpinBox>("epsilon")->value(), 2.0);
  }

  void eachStepIsSwitchedByItself() {
    for (const auto& [name, setting] : {std::pair{"rigidStep", &AdjustmentSettings::rigid},
                                        {"scaleStep", &AdjustmentSettings::scale},
                                        {"lineFieldStep", &AdjustmentSettings::lineField},
                                        {"exactFitStep", &AdjustmentSettings::exactFit}}) {
      Panel p;
      QTest::mouseClick(p.find<QCheckBox>(name), Qt::LeftButton, {}, QPoint(8, 8));
      AdjustmentSettings expected;
      expected.*setting = false;
      QCOMPARE(p.edited.size(), std::size_t{1});
      QVERIFY(p.edited.front() == expected);
    }
  }

  // Beside the scroll bar, also once the numbers have come.
  void nothingIsCutOffAtTheSide() {
    Panel p;
    p.panel.resize(1, 200);
    AdjustmentReport report;
    report.reached = AdjustmentStep::LineField;
    report.iterations = 20;
    report.scale = 12.34;
    report.distanceBefore = 1234.5;
    report.distanceAfterRigid = report.distanceAfterScale = 0.00456;
    p.panel.setReport(report);
    const auto* scroll = p.find<QScrollArea>("adjustmentScroll");
    QTRY_VERIFY(scroll->verticalScrollBar()->isVisible());
    QTRY_VERIFY(scroll->widget()->width() <= scroll->viewport()->width());
  }

  void aTypedNumberIsOneEditWhenItIsComplete() {
    Panel p;
    auto* falloff = p.find<QDoubleSpinBox>("falloff");
    falloff->setFocus();
    falloff->selectAll();
    QTest::keyClicks(falloff, "12");
    QVERIFY(p.edited.empty());
    QTest::keyClick(falloff, Qt::Key_Return);
    QCOMPARE(p.edited.size(), std::size_t{1});
    QCOMPARE(p.edited.front().falloff, 12.0);
    QTest::keyClick(falloff, Qt::Key_Up);
    QCOMPARE(p.edited.back().falloff, 13.0);
  }

  void theStepReachedIsMarkedByMoreThanColour() {
    Panel p;
    AdjustmentReport report;
    report.reached = AdjustmentStep::Scale;
    report.iterations = 3;
    report.scale = 1.4;
    report.distanceBefore = 2;
    report.distanceAfterRigid = 0.5;
    report.distanceAfterScale = 0.0312;
    p.panel.setReport(report);
    QCOMPARE(p.find<QLabel>("scaleStepReached")->accessibleName(), QString("The step reached"));
    QVERIFY(p.find<QLabel>("rigidStepReached")->accessibleName().isEmpty());
    QCOMPARE(p.find<QLabel>("distanceBefore")->text(), QString("2.00"));
    QCOMPARE(p.find<QLabel>("rigidStepDistance")->text(), QString("0.500"));
    QCOMPARE(p.find<QLabel>("scaleStepDistance")->text(), QString("0.0312"));
    QVERIFY(p.find<QLabel>("lineFieldStepDistance")->text().isEmpty());
    QVERIFY(p.find<QCheckBox>("scaleStep")->text().contains("1.40"));
    p.panel.setReport({});
    QVERIFY(p.find<QLabel>("distanceBefore")->text().isEmpty());
    QCOMPARE(p.find<QCheckBox>("scaleStep")->text(), QString("2 scale"));
  }

  void whatAnUndoBringsBackFlashesOnce() {
    Panel p;
    AdjustmentSettings settings;
    settings.falloff = 9;
    settings.rigid = false;
    p.panel.showChange(settings);
    QVERIFY(p.edited.empty());
    QCOMPARE(p.find<QDoubleSpinBox>("falloff")->value(), 9.0);
    const QList<QWidget*> flashes = p.panel.findChildren<QWidget*>("flash");
    QCOMPARE(flashes.size(), 2);
    QVERIFY(flashes[0]->geometry().contains(p.find<QCheckBox>("rigidStep")->geometry().center()));
    QVERIFY(flashes[1]->geometry().contains(p.find<QDoubleSpinBox>("falloff")->geometry().center()));
    QSignalSpy gone(flashes[1], &QObject::destroyed);
    QVERIFY(gone.wait());
    p.panel.showChange(settings);
    QVERIFY(p.panel.findChildren<QWidget*>("flash").isEmpty());
  }

  void whatCannotBeDoneIsOff() {
    Panel p;
    p.panel.setRunnable(false);
    QVERIFY(!p.find<QAbstractButton>("runAdjustment")->isEnabled());
    QVERIFY(!p.find<QAbstractButton>("showBefore")->isEnabled());
    p.panel.setRunnable(true);
    p.panel.setReport(AdjustmentReport{});
    QVERIFY(p.find<QAbstractButton>("runAdjustment")->isEnabled());
    QVERIFY(p.find<QAbstractButton>("showBefore")->isEnabled());
  }

  void runAndShownAreTold() {
    Panel p;
    p.panel.setReport(AdjustmentReport{});
    QSignalSpy run(&p.panel, &AdjustmentPanel::runWanted);
    QTest::mouseClick(p.find<QAbstractButton>("runAdjustment"), Qt::LeftButton);
    QCOMPARE(run.size(), 1);
    std::vector<AdjustmentPanel::Shown> shown;
    connect(&p.panel, &AdjustmentPanel::shownChanged, &p.panel,
            [&](AdjustmentPanel::Shown what) { shown.push_back(what); });
    QTest::mouseClick(p.find<QAbstractButton>("showBefore"), Qt::LeftButton);
    QTest::mouseClick(p.find<QAbstractButton>("showAfter"), Qt::LeftButton);
    using Shown = AdjustmentPanel::Shown;
    QVERIFY(shown == (std::vector{Shown::Before, Shown::After}));
  }
};

QTEST_MAIN(AdjustmentPanelTest)
#include "adjustment_panel_test.moc"
