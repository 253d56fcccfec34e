#include <QLabel>
#include <QPointer>
#include <QSlider>
#include <QToolButton>
#include <tuple>

#include "app/document/document_commands.h"
#include "app/workbench/compare_window.h"
#include "core/fusion/difference.h"
#include "tests/support/gallery.h"
#include "tests/support/panes.h"
#include "widgets/panels/problem_line.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/surface_pane.h"

using namespace graftsman;

namespace {

/// The comparison under a test's hands.
struct CompareHands {
  const Workbench& bench;

  [[nodiscard]] CompareWindow* window() const { return bench.window->findChild<CompareWindow*>(); }
  template <class T>
  [[nodiscard]] T* part(const char* name) const {
    return window()->findChild<T*>(name);
  }
  /// A shortcut of the comparison's window.
  void key(std::size_t side, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const {
    QVERIFY(activated(*window()));
    QTest::keyClick(window()->pane(side), key, modifiers);
  }
  void press(const char* button) const { QTest::mouseClick(part<QToolButton>(button), Qt::LeftButton); }
  /// True once what was asked for is shown.
  [[nodiscard]] bool ready() const {
    return QTest::qWaitFor([this] { return window() && window()->shown() && !window()->busy(); },
                           kPatienceMs);
  }
  /// Selects the variants and opens the comparison by its shortcut.
  [[nodiscard]] bool open(const QStringList& names) const {
    const GalleryHands gallery{bench};
    gallery.click(names.front());
    for (const QString& name : names.mid(1)) {
      gallery.click(name, Qt::ControlModifier);
    }
    QTest::keyClick(gallery.view(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    return ready() && activated(*window());
  }
  /// What the right pane's footer says.
  [[nodiscard]] QString words() const {
    return part<QWidget>("compareFrameB")->findChild<QLabel*>("problemText")->text();
  }
  /// What a pane's footer says is wrong.
  [[nodiscard]] QString problem(const char* frame) const {
    return part<QWidget>(frame)->findChild<ProblemLine*>("paneLine")->problem();
  }
};

// A number as a person reads it.
QString written(double value) {
  return QLocale().toString(value, 'g', 3);
}

bool isPlain(const QImage& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    // The background is a gradient from top to bottom.
    for (int x = 1; x < picture.width(); ++x) {
      if (picture.pixel(x, y) != picture.pixel(0, y)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

// Two variants compared, with real mouse and keys on the real window.
class CompareTest : public QObject {
  Q_OBJECT

 private:
  /// A sample with two variants of different curves and a third of another loop, in Variants mode.
  static bool keepThree(const Workbench& bench) {
    if (!bench.openSample("fig4c_cone_sphere")) {
      return false;
    }
    MainWindow* window = bench.window.get();
    QTest::keyClick(window, Qt::Key_1, Qt::ShiftModifier);
    QTest::keyClick(window, Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(window, Qt::Key_4, Qt::ShiftModifier);
    QTest::keyClick(window, Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(window, Qt::Key_T);  // another correspondence: another combined tile
    QTest::keyClick(window, Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(window, Qt::Key_F4);
    return bench.settle() && GalleryHands{bench}.drawn();
  }

  static std::vector<Point> pointsOf(const Workbench& bench, std::size_t variant) {
    const Variant& kept = *bench.window->model().document().variants[variant];
    return graftsman::update(find(kept.fusions, kept.shown)->inputs, {}, {}).fused->points;
  }

 private Q_SLOTS:
  void bothAreSeenFromOnePlaceAndTurnTogether() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 1", "Variant 2"}));
    CompareWindow& window = *hands.window();
    QCOMPARE(window.mode(), CompareWindow::Mode::SideBySide);
    QCOMPARE(window.windowTitle(), QString("Compare “Variant 1” with “Variant 2”"));
    QVERIFY(window.pane(0)->isVisible() && window.pane(1)->isVisible());
    QVERIFY(std::abs(window.pane(0)->width() - window.pane(1)->width()) <= 1);
    QCOMPARE(window.pane(0)->shownPoints(), pointsOf(bench, 0));
    QCOMPARE(window.pane(1)->shownPoints(), pointsOf(bench, 1));
    QVERIFY(window.pane(0)->shownPoints() != window.pane(1)->shownPoints());
    QVERIFY(!isPlain(window.pane(0)->picture()));
    QVERIFY(window.pane(0)->picture() != window.pane(1)->picture());

    // At first from where the result is seen.
    const Camera result = bench.resultPane()->camera();
    const Camera first = window.pane(0)->camera();
    QVERIFY(window.pane(1)->camera() == first);
    QCOMPARE(first.pivot, result.pivot);
    QVERIFY((first.position - first.pivot).normalized().dot((result.position - result.pivot).normalized()) >
            1 - 1e-12);

    // A turn in the right one turns the left one, and the other way round.
    for (const std::size_t side : {1U, 0U}) {
      const Camera before = window.pane(side)->camera();
      panes::drag(*window.pane(side), {200, 200}, {260, 230}, Qt::MiddleButton);
      QVERIFY(!(window.pane(side)->camera() == before));
      QVERIFY(window.pane(1 - side)->camera() == window.pane(side)->camera());
    }
    const QPointer<CompareWindow> open(&window);
    hands.key(0, Qt::Key_Escape);
    QTRY_VERIFY(!open);
  }

  void theViewKeysTurnBothAsTheyDoInTheMainWindow() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 1", "Variant 2"}));
    CompareWindow& window = *hands.window();
    const Camera result = bench.resultPane()->camera();
    const std::tuple<Qt::Key, Qt::KeyboardModifiers, AxisView> views[] = {
        {Qt::Key_1, {}, AxisView::Front}, {Qt::Key_1, Qt::ControlModifier, AxisView::Back},
        {Qt::Key_3, {}, AxisView::Right}, {Qt::Key_3, Qt::ControlModifier, AxisView::Left},
        {Qt::Key_7, {}, AxisView::Top},   {Qt::Key_7, Qt::ControlModifier, AxisView::Bottom}};
    const auto turnsBoth = [&](std::size_t side) {
      for (const auto& [key, modifiers, view] : views) {
        const Camera wanted = lookingFrom(window.pane(side)->camera(), view);
        hands.key(side, key, modifiers);
        QVERIFY(window.pane(0)->camera() == window.pane(1)->camera());
        const Camera& camera = window.pane(side)->camera();
        QVERIFY((camera.position - wanted.position).norm() < 1e-9 && (camera.up - wanted.up).norm() < 1e-9);
      }
    };
    turnsBoth(0);
    turnsBoth(1);
    hands.press("compareDifference");
    turnsBoth(1);
    QVERIFY(bench.resultPane()->camera() == result);
  }

  void theDifferenceIsThatOfTheSurfaces() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 1", "Variant 2"}));
    CompareWindow& window = *hands.window();
    const Join& join = *bench.window->fusionPage().shown()->join;
    const QImage uncoloured = window.pane(1)->picture();
    hands.press("compareDifference");
    QCOMPARE(window.mode(), CompareWindow::Mode::Difference);
    QVERIFY(!window.pane(0)->isVisible());
    QTRY_COMPARE(window.pane(1)->width(), window.width());
    const std::vector<Face>& faces = window.shown()->sides[0].mesh->faces();
    QVERIFY(faces.size() > join.faces.size() / 2);
    const auto a = std::make_shared<const TriangleMesh>(pointsOf(bench, 0), faces);
    const TriangleMesh b(pointsOf(bench, 1), window.shown()->sides[1].mesh->faces());
    const auto difference = differenceOf(b, a, {});
    QVERIFY(difference);
    QCOMPARE(window.shown()->difference->distances, difference->distances);
    // Half of the cone lies within all of it: much inward, next to nothing outward.
    QVERIFY(difference->least < -0.01 * a->diagonal());
    QCOMPARE(hands.words(), QString("Greatest outward %1, greatest inward %2, mean %3, in the model's unit.")
                                .arg(written(std::max(0.0, difference->greatest)),
                                     written(-difference->least), written(difference->meanAbsolute)));
    const double range = difference->usual;
    QVERIFY(range > 0 && range < -difference->least);
    const QString legend = window.pane(1)->accessibleDescription();
    QVERIFY2(legend.contains("Distance from “Variant 1”") && legend.contains("≤ −" + written(range)) &&
                 legend.contains("≥ +" + written(range)),
             qPrintable(legend));
    // Blue somewhere: inside.
    const QImage coloured = window.pane(1)->picture();
    bool blue = false;
    for (int y = 0; y < coloured.height() / 2; ++y) {
      for (int x = 0; x < coloured.width(); ++x) {
        const QColor colour = coloured.pixelColor(x, y);
        blue = blue || colour.blue() > colour.red() + 60;
      }
    }
    QVERIFY(blue);
    QVERIFY(coloured != uncoloured);
  }

  void theSliderGoesFromOneExactlyToTheOther() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 1", "Variant 2"}));
    CompareWindow& window = *hands.window();
    hands.press("compareMorph");
    auto* slider = hands.part<QSlider>("compareSlider");
    QVERIFY(slider->isEnabled() && hands.words().isEmpty());
    const std::vector<Point> a = pointsOf(bench, 0);
    const std::vector<Point> b = pointsOf(bench, 1);
    QCOMPARE(window.pane(1)->shownPoints(), a);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    const double t = static_cast<double>(slider->value()) / slider->maximum();
    QVERIFY(t > 0 && t < 1);
    const std::vector<Point> between = window.pane(1)->shownPoints();
    QCOMPARE(between.size(), a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      QVERIFY((between[i] - ((1 - t) * a[i] + t * b[i])).norm() < 1e-12);
    }
    QTest::keyClick(slider, Qt::Key_End);
    QCOMPARE(window.pane(1)->shownPoints(), b);
    QTest::keyClick(slider, Qt::Key_Home);
    QCOMPARE(window.pane(1)->shownPoints(), a);

    hands.press("compareFlip");
    QCOMPARE(window.pane(1)->shownPoints(), b);
    hands.key(1, Qt::Key_X);
    QCOMPARE(window.pane(1)->shownPoints(), a);

    // To B and back, as often as one likes; a hand on the slider ends it.
    QSignalSpy moved(slider, &QSlider::valueChanged);
    hands.press("comparePlay");
    QVERIFY(QTest::qWaitFor([&] { return slider->value() > slider->maximum() / 2; }, kPatienceMs));
    QVERIFY(QTest::qWaitFor([&] { return slider->value() < slider->maximum() / 2; }, kPatienceMs));
    QTest::keyClick(slider, Qt::Key_Home);
    QVERIFY(!hands.part<QToolButton>("comparePlay")->isChecked());
    QCOMPARE(window.pane(1)->shownPoints(), a);
  }

  void whereTheTilesDifferTheSliderSaysWhyAndFlipStillWorks() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 1", "Variant 3"}));
    hands.press("compareMorph");
    QVERIFY(!hands.part<QSlider>("compareSlider")->isEnabled());
    QVERIFY(hands.words().contains("combined tiles differ"));
    SurfacePane& pane = *hands.window()->pane(1);
    QCOMPARE(pane.shownPoints(), pointsOf(bench, 0));
    hands.press("compareFlip");
    QCOMPARE(pane.shownPoints(), pointsOf(bench, 2));
    hands.press("compareFlip");
    QCOMPARE(pane.shownPoints(), pointsOf(bench, 0));
    hands.press("comparePlay");
    QTRY_COMPARE(pane.shownPoints(), pointsOf(bench, 2));
    QTRY_COMPARE(pane.shownPoints(), pointsOf(bench, 0));
    hands.press("comparePlay");
    // There is a difference all the same.
    hands.press("compareDifference");
    QVERIFY(hands.words().startsWith("Greatest outward"));
  }

  void theOnlyOneSelectedIsComparedWithThePresentStateAsItChanges() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 3"}));  // as the present state is
    QCOMPARE(hands.window()->windowTitle(), QString("Compare “Variant 3” with the present state"));
    hands.press("compareDifference");
    QCOMPARE(hands.words(), QString("The two have the same surface."));
    bench.action("paste")->trigger();
    QVERIFY(hands.ready());
    QVERIFY(hands.words().startsWith("Greatest outward"));
    QCOMPARE(hands.window()->pane(1)->shownPoints(),
             graftsman::update(bench.fusion().inputs, {}, {}).fused->points);
    bench.action("undo")->trigger();
    QVERIFY(hands.ready());
    QCOMPARE(hands.words(), QString("The two have the same surface."));

    // Without a result it says so, and shows it again once there is one.
    bench.action("openLoop")->trigger();
    QVERIFY(hands.ready());
    QVERIFY2(hands.problem("compareFrameB").contains("The loop is open"),
             qPrintable(hands.problem("compareFrameB")));
    QVERIFY(isPlain(hands.window()->pane(1)->picture()));
    hands.press("compareSideBySide");
    QVERIFY(hands.problem("compareFrameB").contains("The loop is open"));
    QVERIFY(!hands.problem("compareFrameA").contains("loop"));
    QVERIFY(!isPlain(hands.window()->pane(0)->picture()));
    bench.action("undo")->trigger();
    QVERIFY(hands.ready());
    QVERIFY(!isPlain(hands.window()->pane(1)->picture()));
    QVERIFY(!hands.problem("compareFrameB").contains("loop"));
  }

  void aRenamedOneIsNamedAndARemovedOneClosesTheWindow() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    DocumentModel& model = bench.window->model();
    QVERIFY(hands.open({"Variant 1", "Variant 2"}));
    const VariantId second = model.document().variants[1]->id;
    model.push(std::make_unique<RenameVariant>(model, second, "Flat"));
    QCOMPARE(hands.window()->windowTitle(), QString("Compare “Variant 1” with “Flat”"));
    QVERIFY(!hands.window()->busy());  // its shape is the same

    // Another curve for it is another shape.
    model.push(std::make_unique<ChangeVariants>(
        model, std::set<VariantId>{second},
        [](Fusion& fusion) { fusion.inputs.fcf = FCF::preset(FCF::Preset::Paste); }, "Curve"));
    QVERIFY(hands.ready());
    QCOMPARE(hands.window()->pane(1)->shownPoints(), pointsOf(bench, 1));

    const QPointer<CompareWindow> open(hands.window());
    model.push(std::make_unique<RemoveVariants>(model, std::set<VariantId>{second}));
    QTRY_VERIFY(!open);
    bench.action("undo")->trigger();
    QVERIFY(!hands.window());
  }

  void removedWhileItIsComputedItClosesToo() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    const GalleryHands gallery{bench};
    gallery.click("Variant 1");
    gallery.click("Variant 2", Qt::ControlModifier);
    bench.action("compareVariants")->trigger();
    const QPointer<CompareWindow> open(hands.window());
    QVERIFY(open && open->busy());
    gallery.key(Qt::Key_Delete);
    QTRY_VERIFY(!open);
    QCOMPARE(gallery.shown(), QStringList{"Variant 3"});
  }

  void anotherProjectClosesIt() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 1", "Variant 2"}));
    const QPointer<CompareWindow> open(hands.window());
    bench.window->model().reset(Document(), 1);
    QTRY_VERIFY(!open);
  }

  void itTakesOneOrTwo() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const GalleryHands gallery{bench};
    const QAction* compare = bench.action("compareVariants");
    gallery.gallery().select({});
    QVERIFY(!compare->isEnabled());
    gallery.click("Variant 1");
    QVERIFY(compare->isEnabled());
    gallery.click("Variant 2", Qt::ControlModifier);
    QVERIFY(compare->isEnabled());
    gallery.click("Variant 3", Qt::ControlModifier);
    QVERIFY(!compare->isEnabled());
  }

  void theSameWindowComparesTheNextTwo() {
    Workbench bench;
    QVERIFY(keepThree(bench));
    const CompareHands hands{bench};
    QVERIFY(hands.open({"Variant 1", "Variant 2"}));
    const CompareWindow* window = hands.window();
    bench.activate();
    QVERIFY(hands.open({"Variant 3", "Variant 2"}));
    QCOMPARE(hands.window(), window);
    QCOMPARE(bench.window->findChildren<CompareWindow*>().size(), 1);
    QCOMPARE(window->pane(0)->shownPoints(), pointsOf(bench, 2));
  }
};

QTEST_MAIN(CompareTest)
#include "compare_test.moc"
