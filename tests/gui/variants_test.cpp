#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>
#include <QUndoView>

#include "app/document/commands.h"
#include "tests/support/gallery.h"

using namespace graftsman;

// Keeping, comparing and changing alternatives, with real mouse and keys on the real window.
class VariantsTest : public QObject {
  Q_OBJECT

 private:
  /// A sample with three variants of different curves, in Variants mode.
  static bool keepThree(const Workbench& bench) {
    if (!bench.openSample("fig4c_cone_sphere")) {
      return false;
    }
    for (const auto curve : {Qt::Key_1, Qt::Key_2, Qt::Key_4}) {
      QTest::keyClick(bench.window.get(), curve, Qt::ShiftModifier);
      QTest::keyClick(bench.window.get(), Qt::Key_B, Qt::ControlModifier);
    }
    QTest::keyClick(bench.window.get(), Qt::Key_F4);
    return bench.settle() && GalleryHands{bench}.drawn();
  }

  static FCF curveOf(const Workbench& bench, std::size_t variant) {
    return bench.window->model().document().variants[variant]->fusions.front()->inputs.fcf;
  }

 private Q_SLOTS:
  void theFirstVisitSaysHowToKeepAVariant() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_F4);
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Variants);
    auto* empty = bench.window->findChild<QLabel*>("variantsEmpty");
    QVERIFY(empty->isVisible());
    QVERIFY(empty->text().contains("Ctrl+B"));
    QTest::keyClick(bench.window.get(), Qt::Key_B, Qt::ControlModifier);
    QVERIFY(!empty->isVisible());
    QCOMPARE(GalleryHands{bench}.shown(), QStringList{"Variant 1"});
  }

  void aDayWithVariants() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const GalleryHands hands{bench};
    QUndoStack& history = *bench.window->model().history();
    QCOMPARE(hands.shown(), (QStringList{"Variant 1", "Variant 2", "Variant 3"}));
    QVERIFY(curveOf(bench, 0) == FCF::preset(FCF::Preset::Linear));
    QVERIFY(curveOf(bench, 1) == FCF::preset(FCF::Preset::Paste));
    QVERIFY(hands.picture("Variant 1") != hands.picture("Variant 2"));

    // Rename in place, and a note.
    hands.click("Variant 2");
    QTest::keyClick(bench.window.get(), Qt::Key_F2, Qt::ShiftModifier);
    auto* editor = hands.view()->findChild<QLineEdit*>("variantNameEditor");
    QVERIFY(editor);
    QTest::keyClicks(editor, "Spike");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(hands.shown(), (QStringList{"Variant 1", "Spike", "Variant 3"}));
    auto* note = bench.window->findChild<QLineEdit*>("variantNote");
    QTest::mouseClick(note, Qt::LeftButton);
    QTest::keyClicks(note, "too sharp");
    QTest::keyClick(note, Qt::Key_Return);
    QCOMPARE(hands.variants()[1]->note, std::string("too sharp"));

    // Star, filter.
    hands.click("Spike");
    hands.key(Qt::Key_S);
    QVERIFY(hands.variants()[1]->starred);
    auto* starred = bench.window->findChild<QToolButton*>("variantsStarred");
    QTest::mouseClick(starred, Qt::LeftButton);
    QCOMPARE(hands.shown(), QStringList{"Spike"});
    QTest::mouseClick(starred, Qt::LeftButton);
    auto* words = bench.window->findChild<QLineEdit*>("variantsWords");
    QTest::keyClicks(words, "sharp");
    QCOMPARE(hands.shown(), QStringList{"Spike"});
    words->clear();

    // Apply one: the document is as that variant, and back.
    const Fusion before = bench.fusion();
    hands.click("Variant 1");
    hands.key(Qt::Key_Return);
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::Linear));
    QCOMPARE(history.undoText(), QString("Apply “Variant 1”"));
    QVERIFY(bench.settle());
    QVERIFY(bench.window->fusionPage().shown()->fused->points ==
            update(bench.fusion().inputs, {}, {}).fused->points);
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.fusion() == before);

    // Delete two, and back.
    const VariantList kept = hands.variants();
    const int steps = history.count();
    hands.click("Variant 1");
    hands.click("Variant 3", Qt::ControlModifier);
    hands.key(Qt::Key_Delete);
    QCOMPARE(hands.shown(), QStringList{"Spike"});
    QCOMPARE(history.index(), steps);
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(hands.variants(), kept);
    QVERIFY(!hands.picture("Variant 3").isNull());

    // Saved, closed, opened again: the same variants and pictures.
    QVERIFY(bench.settle() && hands.drawn());
    QMap<QString, QImage> pictures;
    for (const QString& name : hands.shown()) {
      pictures[name] = hands.picture(name);
    }
    const Document saved = bench.window->model().document();
    const QString path = bench.folder.filePath("variants.graft");
    bench.window->files().save(path);
    QVERIFY(bench.settle());
    bench.action("newProject")->trigger();
    QVERIFY(hands.shown().isEmpty());
    bench.window->openFile(path);
    QVERIFY(bench.settle());
    QCOMPARE(bench.window->mode(), MainWindow::Mode::Variants);
    QVERIFY(hands.drawn());
    const VariantList& reopened = hands.variants();
    QCOMPARE(reopened.size(), saved.variants.size());
    for (std::size_t i = 0; i < reopened.size(); ++i) {
      QCOMPARE(reopened[i]->name, saved.variants[i]->name);
      QCOMPARE(reopened[i]->note, saved.variants[i]->note);
      QCOMPARE(reopened[i]->starred, saved.variants[i]->starred);
      QVERIFY(reopened[i]->fusions.front()->inputs.fcf == saved.variants[i]->fusions.front()->inputs.fcf);
      QVERIFY(reopened[i]->fusions.front()->inputs.loop == saved.variants[i]->fusions.front()->inputs.loop);
      // Shared, not read twice.
      QCOMPARE(reopened[i]->fusions.front()->inputs.base, bench.fusion().inputs.base);
      const QString name = QString::fromStdString(reopened[i]->name);
      QCOMPARE(hands.picture(name), pictures[name]);
    }
  }

  void twoGiveOneTheLoopAndTheOtherTheCurve() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_B, Qt::ControlModifier);
    const Loop loop = bench.fusion().inputs.loop;
    QTest::keyClick(bench.window.get(), Qt::Key_T);  // another correspondence
    QTest::keyClick(bench.window.get(), Qt::Key_4, Qt::ShiftModifier);
    QTest::keyClick(bench.window.get(), Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(bench.window.get(), Qt::Key_F4);
    const GalleryHands hands{bench};
    hands.click("Variant 1");
    QVERIFY(!bench.action("crossVariants")->isEnabled());
    hands.click("Variant 2", Qt::ControlModifier);
    QVERIFY(bench.action("crossVariants")->isEnabled());
    QTest::keyClick(bench.window.get(), Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(hands.variants().size(), std::size_t{3});
    const FusionInputs& crossed = hands.variants()[2]->fusions.front()->inputs;
    QVERIFY(crossed.loop == loop);
    QVERIFY(crossed.fcf == FCF::preset(FCF::Preset::Half));
    QCOMPARE(hands.shown().last(), QString("Variant 1 × Variant 2"));
    QVERIFY(bench.settle() && hands.drawn());
  }

  void severalTakeTheShownCurveOrAdjustmentInOneStep() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const GalleryHands hands{bench};
    const VariantList before = hands.variants();
    const QImage picture = hands.picture("Variant 1");
    QTest::keyClick(bench.window.get(), Qt::Key_3, Qt::ShiftModifier);
    const int steps = bench.window->model().history()->count();
    hands.click("Variant 1");
    hands.click("Variant 2", Qt::ControlModifier);
    auto* button = bench.window->findChild<QToolButton*>("giveCurveButton");
    QVERIFY(button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(bench.window->model().history()->count(), steps + 1);
    for (const std::size_t i : {0, 1}) {
      QVERIFY(curveOf(bench, i) == FCF::preset(FCF::Preset::KeepBaseSlope));
    }
    QVERIFY(curveOf(bench, 2) == FCF::preset(FCF::Preset::Half));
    QVERIFY(bench.settle() && hands.drawn());
    QVERIFY(hands.picture("Variant 1") != picture);
    // Undone, it has its picture at once.
    QTest::keyClick(bench.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(hands.variants(), before);
    QCOMPARE(hands.picture("Variant 1"), picture);

    Fusion changed = bench.window->model().committed();
    AdjustmentSettings settings = changed.inputs.adjustment;
    settings.falloff = 3;
    bench.window->model().push(std::make_unique<SetAdjustment>(bench.window->model(), settings));
    QTest::keyClick(bench.window.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(hands.variants()[0]->fusions.front()->inputs.adjustment, settings);
    QCOMPARE(hands.variants()[1]->fusions.front()->inputs.adjustment, settings);
    QVERIFY(!(hands.variants()[2]->fusions.front()->inputs.adjustment == settings));
  }

  void aStateOfTheHistoryBecomesAVariant() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    const Fusion opened = bench.fusion();
    QTest::keyClick(bench.window.get(), Qt::Key_4, Qt::ShiftModifier);
    QTest::keyClick(bench.window.get(), Qt::Key_2, Qt::ShiftModifier);
    QVERIFY(bench.settle());
    auto* view = bench.window->findChild<QUndoView*>("historyView");
    const auto keep = [&](int row) {
      const QPoint at = view->visualRect(view->model()->index(row, 0)).center();
      Q_EMIT view->customContextMenuRequested(at);
      auto* menu = view->findChild<QMenu*>("historyMenu");
      menu->findChild<QAction*>("keepState")->trigger();
      menu->close();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    keep(1);
    keep(0);
    QCOMPARE(bench.window->model().document().variants.size(), std::size_t{2});
    QVERIFY(curveOf(bench, 0) == FCF::preset(FCF::Preset::Half));
    QVERIFY(curveOf(bench, 1) == opened.inputs.fcf);
    QVERIFY(bench.fusion().inputs.fcf == FCF::preset(FCF::Preset::Paste));
  }

  void aVariantWithoutAResultSaysWhyAndShowsItsBase() {
    Workbench bench;
    QVERIFY(bench.openSample("fig4c_cone_sphere"));
    QTest::keyClick(bench.window.get(), Qt::Key_B, Qt::ControlModifier);
    bench.action("openLoop")->trigger();
    QTest::keyClick(bench.window.get(), Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(bench.window.get(), Qt::Key_F4);
    const GalleryHands hands{bench};
    QVERIFY(bench.settle() && hands.drawn());
    const auto problem = [&](int row) {
      return hands.view()->model()->index(row, 0).data(VariantsModel::Problem).toString();
    };
    QCOMPARE(problem(0), QString());
    QVERIFY(problem(1).contains("loop is open"));
    QVERIFY(hands.picture("Variant 2") != hands.picture("Variant 1"));
  }

  void picturesAreTakenAnewFromTheViewThatTheResultHas() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const GalleryHands hands{bench};
    const QImage before = hands.picture("Variant 2");
    Camera camera = bench.resultPane()->camera();
    camera.position = camera.pivot - (camera.position - camera.pivot);
    bench.resultPane()->setCamera(camera);
    QTest::keyClick(bench.window.get(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(hands.picture("Variant 2") != before);
    QVERIFY(hands.drawn());
  }

  void lettersInTheGalleryAreNoToolsOfTheLoop() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const Fusion before = bench.fusion();
    const GalleryHands hands{bench};
    hands.click("Variant 1");
    for (const auto key : {Qt::Key_R, Qt::Key_T, Qt::Key_M}) {
      hands.key(key);
    }
    QVERIFY(bench.fusion() == before);
  }
};

QTEST_MAIN(VariantsTest)
#include "variants_test.moc"
