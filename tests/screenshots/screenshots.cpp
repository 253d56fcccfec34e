// Takes pictures of the running window in its states: screenshots FOLDER [--all]. Without --all those of the
// README.

#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QPalette>
#include <QPushButton>
#include <QScreen>
#include <QSlider>
#include <cstdio>

#include "app/document/document_commands.h"
#include "app/workbench/compare_window.h"
#include "app/workbench/samples.h"
#include "app/workbench/suggester.h"
#include "app/workbench/sweep_dialog.h"
#include "core/picture/fusion_view.h"
#include "tests/support/gallery.h"
#include "tests/support/stacked.h"
#include "tests/support/workbench.h"
#include "widgets/theme/indicator_style.h"
#include "widgets/variants/suggestion_strip.h"
#include "widgets/variants/suggestions_model.h"
#include "widgets/viewport/result_pane.h"

using namespace graftsman;

namespace {

// Twice the size that the start page shows, for screens with small pixels.
constexpr QSize kSamplePicture(464, 304);

QPalette darkPalette() {
  QPalette palette;
  const auto set = [&](QPalette::ColorRole role, const char* colour) {
    palette.setColor(role, QColor(colour));
  };
  set(QPalette::Window, "#2B2D30");
  set(QPalette::WindowText, "#E6E6E6");
  set(QPalette::Base, "#1F2123");
  set(QPalette::AlternateBase, "#26282B");
  set(QPalette::Text, "#E6E6E6");
  set(QPalette::Button, "#35383C");
  set(QPalette::ButtonText, "#E6E6E6");
  set(QPalette::ToolTipBase, "#35383C");
  set(QPalette::ToolTipText, "#E6E6E6");
  set(QPalette::PlaceholderText, "#9AA0A6");
  set(QPalette::Highlight, "#3D8BFD");
  set(QPalette::HighlightedText, "#FFFFFF");
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor("#7A7F85"));
  }
  return palette;
}

class Photographer {
 public:
  Photographer(Workbench& bench, QString folder) : bench_(bench), folder_(std::move(folder)) {}

  void take(const QString& name) { take(name, bench_.window.get()); }

  void take(const QString& name, QWidget* window) {
    if (!bench_.settle()) {
      qFatal("the stages do not settle");
    }
    // What was asked to be drawn is drawn.
    QTest::qWait(200);
    const QString path = folder_ + '/' + name + ".png";
    if (!window->screen()->grabWindow(window->winId()).save(path)) {
      qFatal("%s cannot be written", qPrintable(path));
    }
    std::printf("%s\n", qPrintable(path));
  }

 private:
  Workbench& bench_;
  QString folder_;
};

// Opens a sample; what was there is let go.
void open(const Workbench& bench, const std::string& name) {
  bench.window->model().history()->setClean();
  if (!bench.openSample(name)) {
    qFatal("%s makes no result", name.c_str());
  }
}

// A dozen variants of a nose: as a designer leaves them after half an hour.
void keepVariants(const Workbench& bench) {
  DocumentModel& model = bench.window->model();
  open(bench, "fig8b_cone_nose");
  const auto keep = [&](const char* name, std::vector<FCFPoint> points, double falloff, bool starred) {
    Fusion fusion = model.committed();
    fusion.inputs.fcf = *FCF::through(std::move(points), true);
    fusion.inputs.adjustment.falloff = falloff;
    model.push(std::make_unique<AddVariant>(
        model, FusionList{std::make_shared<const Fusion>(std::move(fusion))}, model.shown(), name));
    if (starred) {
      model.push(std::make_unique<StarVariants>(
          model, std::set<VariantId>{model.document().variants.back()->id}, true));
    }
  };
  // From near enough to see what differs.
  const FusionResults& results = *bench.window->fusionPage().shown();
  const Camera whole = bench.resultPane()->camera();
  const PictureCamera near =
      cameraFor(results, FusionView::Tile, {whole.position - whole.pivot, whole.axis}, 4.0 / 3);
  bench.resultPane()->setCamera({near.position, near.pivot, near.up, whole.axis});

  keep("Cone, pasted", {{0, 0}, {0.02, 0.9}, {0.08, 1}, {1, 1}}, 5, false);
  keep("Soft foot", {{0, 0}, {0.2, 0.1}, {0.45, 0.9}, {1, 1}}, 5, true);
  keep("Half cone", {{0, 0}, {0.1, 0.45}, {0.5, 0.5}, {1, 0.5}}, 5, false);
  keep("As it was", {{0, 0}, {0.3, 0}, {0.6, 0}, {1, 0}}, 5, false);
  keep("Broad base", {{0, 0}, {0.04, 0.9}, {0.35, 0.95}, {1, 0.3}}, 5, true);
  keep("Button", {{0, 0}, {0.15, 0.1}, {0.3, 1}, {1, 0.6}}, 5, false);
  keep("Only the tip", {{0, 0}, {0.45, 0}, {0.6, 0.9}, {1, 1}}, 5, false);
  keep("Needle", {{0, 0}, {0.6, 0.05}, {0.8, 0.5}, {1, 1}}, 5, false);
  keep("Clown", {{0, 0}, {0.12, 0.9}, {0.4, 1}, {1, 0.75}}, 5, true);
  keep("Crater", {{0, 0}, {0.1, 0.8}, {0.3, 0.9}, {1, 0}}, 5, false);
  keep("Even", {{0, 0}, {0.3, 0.3}, {0.6, 0.6}, {1, 1}}, 5, false);
  keep("Two steps", {{0, 0}, {0.1, 0.6}, {0.4, 0.55}, {1, 1}}, 5, false);
  model.push(std::make_unique<NoteVariant>(model, 5, "Closest to the sketch: ask for a wider loop"));
  model.push(std::make_unique<ApplyVariant>(model, 2));
  bench.window->setMode(MainWindow::Mode::Variants);
  QCursor::setPos(bench.window->mapToGlobal(QPoint(1200, 700)));
  bench.window->variantsPage().gallery()->select({5});
  if (!bench.settle() || !GalleryHands{bench}.drawn()) {
    qFatal("the variants have no pictures");
  }
}

// A cone for a nose, with other settings beside it, of which one was taken.
void openSuggestions(const Workbench& bench) {
  open(bench, "fig8b_cone_nose");
  bench.window->setMode(MainWindow::Mode::Fusion);
  if (!bench.action("suggestions")->isChecked()) {
    bench.action("suggestions")->trigger();
  }
  const auto* strip = bench.window->findChild<SuggestionStrip*>("suggestionStrip");
  const QAbstractItemModel& rows = *strip->view()->model();
  const auto drawn = [&] {
    for (int row = 0; row < rows.rowCount(); ++row) {
      if (rows.index(row, 0).data(SuggestionsModel::Picture).value<QImage>().isNull()) {
        return false;
      }
    }
    return rows.rowCount() > 0 && !strip->model()->outdated() && !bench.window->suggester().busy() &&
           bench.settle();
  };
  auto* order = bench.window->findChild<QComboBox*>("suggestionsOrder");
  order->setCurrentIndex(static_cast<int>(SuggestionOrder::GreatestDistance));
  if (!QTest::qWaitFor(drawn, kPatienceMs)) {
    qFatal("the suggestions have no pictures");
  }
  const QModelIndex third = rows.index(2, 0);
  QTest::mouseClick(strip->view()->viewport(), Qt::LeftButton, {}, strip->view()->visualRect(third).center());
  if (!bench.settle() || !QTest::qWaitFor(drawn, kPatienceMs)) {
    qFatal("the suggestion was not taken");
  }
}

void closeSuggestions(const Workbench& bench) {
  bench.action("suggestions")->trigger();
}

// Two of the variants that were kept, in every way of comparing; without `all` by their difference alone.
void takeCompared(const Workbench& bench, Photographer& photographer, const QString& prefix, bool all) {
  bench.window->variantsPage().gallery()->select({5, 7});
  bench.action("compareVariants")->trigger();
  auto* window = bench.window->findChild<CompareWindow*>();
  if (window == nullptr || !QTest::qWaitForWindowExposed(window) ||
      !QTest::qWaitFor([window] { return window->shown() && !window->busy(); }, kPatienceMs)) {
    qFatal("nothing is compared");
  }
  QCursor::setPos(window->mapToGlobal(QPoint(window->width() / 2, 2)));
  window->setMode(CompareWindow::Mode::Difference);
  photographer.take(prefix + "compare", window);
  if (all) {
    window->setMode(CompareWindow::Mode::SideBySide);
    photographer.take(prefix + "compare-beside", window);
    window->setMode(CompareWindow::Mode::Morph);
    window->findChild<QSlider*>("compareSlider")->setValue(500);
    photographer.take(prefix + "compare-morph", window);
  }
  delete window;
  bench.activate();
}

// A sweep of the nose, done or under way.
void takeSweep(const Workbench& bench, Photographer& photographer, const QString& name, bool running) {
  keepVariants(bench);
  bench.action("sweep")->trigger();
  auto* dialog = bench.window->findChild<SweepDialog*>("sweepDialog");
  const auto tick = [&](const char* list, const char* entry, bool on) {
    auto* view = dialog->findChild<QListWidget*>(list);
    view->findItems(entry, Qt::MatchStartsWith).front()->setCheckState(on ? Qt::Checked : Qt::Unchecked);
  };
  tick("sweepCurves", "Paste", true);
  tick("sweepCurves", "Half", true);
  tick("sweepCurves", "Present", true);
  tick("sweepShifts", "1", running);
  tick("sweepAdjustments", "All steps", true);
  tick("sweepAdjustments", "Rigid only", true);
  dialog->findChild<QLineEdit*>("sweepFalloffs")
      ->setText(running ? "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16" : "2, 5, 9");
  dialog->findChild<QPushButton*>("sweepRun")->click();
  if (!running && !QTest::qWaitFor([&] { return !dialog->busy(); }, kPatienceMs)) {
    qFatal("the sweep does not end");
  }
  photographer.take(name, dialog);
  dialog->cancel();
  if (!QTest::qWaitFor([&] { return !dialog->busy(); }, kPatienceMs)) {
    qFatal("the sweep does not end");
  }
  dialog->close();
}

void takeForReadme(Workbench& bench, Photographer& photographer, const QString& prefix) {
  bench.window->setMode(MainWindow::Mode::Start);
  photographer.take(prefix + "start");
  open(bench, "fig9b_bird_plane");
  bench.window->setMode(MainWindow::Mode::Tiles);
  photographer.take(prefix + "tiles");
  open(bench, "fig8b_cone_nose");
  bench.window->setMode(MainWindow::Mode::Fusion);
  photographer.take(prefix + "fusion");
  openSuggestions(bench);
  photographer.take(prefix + "suggestions");
  closeSuggestions(bench);
  keepVariants(bench);
  photographer.take(prefix + "variants");
  takeCompared(bench, photographer, prefix, false);
  takeSweep(bench, photographer, prefix + "sweep-dialog", false);
}

// The start page's pictures of the samples' results.
void takeSamples(const Workbench& bench, const QString& folder) {
  for (const Sample& sample : findSamples()) {
    const QString name = QFileInfo(sample.path).completeBaseName();
    open(bench, name.toStdString());
    const QString path = QString("%1/%2.png").arg(folder, name);
    if (!bench.resultPane()->picture(kSamplePicture).save(path)) {
      qFatal("%s cannot be written", qPrintable(path));
    }
    std::printf("%s\n", qPrintable(path));
  }
}

// A fusion of a fusion, with a source that has none, and with a CV that moved.
void takeStacked(const Workbench& bench, Photographer& photographer, const QString& theme) {
  const auto take = [&](const QString& name) { photographer.take(theme + "-stacked-" + name); };
  DocumentModel& model = bench.window->model();
  Document document = edits::renameFusion(samples::fiveStackedFusions(), 1, "Horn");
  document = edits::renameFusion(document, 2, "Second horn");
  model.reset(document, 5);
  bench.window->findChild<QDockWidget*>("fusionsDock")->raise();
  bench.window->setMode(MainWindow::Mode::Tiles);
  take("tiles");
  bench.window->setMode(MainWindow::Mode::Fusion);
  bench.window->lookAtFirst();
  take("fusion");
  model.show(2);
  Fusion moved = *find(document.fusions, 2);
  *moved.inputs.loop[3].base.place *= 1.2;
  model.reset(edits::withFusion(document, moved), 2);
  bench.window->setMode(MainWindow::Mode::Tiles);
  take("moved");
  document = edits::withFusion(document, edits::openLoop(*find(document.fusions, 1)));
  model.reset(document, 2);
  take("unfused");
}

void takeAll(Workbench& bench, Photographer& photographer, const QString& theme) {
  const auto take = [&](const QString& name) { photographer.take(theme + '-' + name); };
  keepVariants(bench);
  bench.window->variantsPage().gallery()->select({2, 5, 9});
  take("variants-several");
  takeCompared(bench, photographer, theme + '-', true);
  bench.window->setMode(MainWindow::Mode::Tiles);
  take("empty");
  open(bench, "fig7_letters_bottle");
  bench.window->setMode(MainWindow::Mode::Variants);
  take("variants-empty");
  bench.window->setMode(MainWindow::Mode::Fusion);
  for (int colouring = 0; colouring < 5; ++colouring) {
    bench.window->findChild<QComboBox*>("colouring")->setCurrentIndex(colouring);
    take(QString("colour-%1").arg(colouring));
  }
  bench.window->findChild<QComboBox*>("colouring")->setCurrentIndex(0);
  bench.window->setMode(MainWindow::Mode::Tiles);
  bench.action("reverse")->trigger();
  take("clockwise");
  bench.action("reverse")->trigger();
  bench.action("openLoop")->trigger();
  bench.clickVertex(Side::Base, 5);
  take("half-made");
  bench.window->resize(1920, 1080);
  take("1920x1080");
  openSuggestions(bench);
  take("1920x1080-suggestions");
  closeSuggestions(bench);
  bench.window->resize(1280, 800);
  bench.action("undo")->trigger();
  takeStacked(bench, photographer, theme);
  takeSweep(bench, photographer, theme + "-sweep-running", true);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Graftsman");
  QApplication::setApplicationName("Screenshots");
  IndicatorStyle::install();
  if (argc < 2) {
    std::fprintf(stderr, "usage: screenshots FOLDER [--all | --samples]\n");
    return 2;
  }
  Workbench bench;
  const QString what = argc > 2 ? argv[2] : "";
  if (what == "--samples") {
    takeSamples(bench, argv[1]);
    return 0;
  }
  Photographer photographer(bench, argv[1]);
  takeForReadme(bench, photographer, "");
  if (what == "--all") {
    takeAll(bench, photographer, "light");
    QApplication::setPalette(darkPalette());
    takeForReadme(bench, photographer, "dark-");
    takeAll(bench, photographer, "dark");
  }
  return 0;
}
