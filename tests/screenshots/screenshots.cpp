// Takes pictures of the running window in its states: screenshots FOLDER [--all]. Without --all those of the
// README.

#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QPalette>
#include <QScreen>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/workbench/project_files.h"
#include "app/workbench/samples.h"
#include "tests/support/documents.h"
#include "tests/support/shapes.h"
#include "tests/support/workbench.h"
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

  void take(const QString& name) {
    if (!bench_.settle()) {
      qFatal("the stages do not settle");
    }
    // What was asked to be drawn is drawn, also where a scroll bar has just gone.
    QTest::qWait(200);
    for (QWidget* widget : bench_.window->findChildren<QWidget*>()) {
      widget->update();
    }
    QTest::qWait(100);
    const QString path = folder_ + '/' + name + ".png";
    MainWindow* window = bench_.window.get();
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

void takeForReadme(Workbench& bench, Photographer& photographer, const QString& prefix) {
  bench.window->setMode(MainWindow::Mode::Start);
  photographer.take(prefix + "start");
  open(bench, "fig9b_bird_plane");
  bench.window->setMode(MainWindow::Mode::Tiles);
  photographer.take(prefix + "tiles");
  open(bench, "fig8b_cone_nose");
  bench.window->setMode(MainWindow::Mode::Fusion);
  photographer.take(prefix + "fusion");
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

// A base of more than a million faces.
void takeMillion(Workbench& bench, Photographer& photographer, const QString& theme) {
  constexpr Index kSize = 720;
  auto document = samples::document("fig4c_cone_sphere");
  document.inputs.base = shapes::torus(kSize, kSize);
  document.base =
      std::make_shared<const MeshAsset>(MeshAsset{"ring.ply", "ring.ply", {}, document.inputs.base});
  for (std::size_t k = 0; k < document.inputs.loop.size(); ++k) {
    const double angle = std::numbers::pi / 4 * static_cast<double>(k);
    document.inputs.loop[k].base =
        SurfacePoint::atVertex(static_cast<Index>(180 + 60 * std::cos(angle)) * kSize +
                               static_cast<Index>(90 + 60 * std::sin(angle)));
  }
  bench.window->model().reset(document);
  bench.window->lookAtFirst();
  photographer.take(theme + "-million-tiles");
  bench.window->setMode(MainWindow::Mode::Fusion);
  photographer.take(theme + "-million");
}

void takeAll(Workbench& bench, Photographer& photographer, const QString& theme) {
  const auto take = [&](const QString& name) { photographer.take(theme + '-' + name); };
  bench.window->model().history()->setClean();
  bench.window->files().startNew();
  bench.window->setMode(MainWindow::Mode::Tiles);
  take("empty");
  bench.window->setMode(MainWindow::Mode::Fusion);
  take("empty-fusion");
  open(bench, "fig7_letters_bottle");
  for (int colouring = 0; colouring < 5; ++colouring) {
    bench.window->findChild<QComboBox*>("colouring")->setCurrentIndex(colouring);
    take(QString("colour-%1").arg(colouring));
  }
  bench.window->findChild<QComboBox*>("colouring")->setCurrentIndex(0);
  bench.window->setMode(MainWindow::Mode::Tiles);
  bench.action("reverse")->trigger();
  bench.window->findChild<QDockWidget*>("stagesDock")->raise();
  take("clockwise");
  bench.window->setMode(MainWindow::Mode::Fusion);
  take("failed");
  bench.window->findChild<QDockWidget*>("historyDock")->raise();
  bench.action("reverse")->trigger();
  take("history");
  bench.window->findChild<QDockWidget*>("adjustmentDock")->raise();
  bench.window->setMode(MainWindow::Mode::Tiles);
  bench.action("openLoop")->trigger();
  bench.clickVertex(Side::Base, 5);
  take("half-made");
  bench.window->resize(1920, 1080);
  take("1920x1080");
  bench.window->resize(1280, 800);
  bench.action("undo")->trigger();
  takeMillion(bench, photographer, theme);
}

// Every label a third wider, as in the longest translations.
void takeLong(Workbench& bench, Photographer& photographer) {
  const QFont font = QApplication::font();
  QFont wide = font;
  wide.setStretch(133);
  QApplication::setFont(wide);
  takeForReadme(bench, photographer, "long-");
  QApplication::setFont(font);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Graftsman");
  QApplication::setApplicationName("Screenshots");
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
    takeLong(bench, photographer);
    takeAll(bench, photographer, "light");
    QApplication::setPalette(darkPalette());
    takeForReadme(bench, photographer, "dark-");
    takeAll(bench, photographer, "dark");
  }
  return 0;
}
