#include <QApplication>
#include <QCommandLineParser>
#include <QImage>
#include <QSurfaceFormat>
#include <QTimer>
#include <cstdio>

#include "app/workbench/autosave.h"
#include "app/workbench/desktop_colours.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/main_window.h"
#include "core/base/large_array.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/indicator_style.h"

using namespace graftsman;

namespace {

constexpr QSize kPictureSize(1280, 960);

// Opens the file, waits for its result, writes the picture and ends the program: 0, or 1 with a line on
// stderr.
void writePicture(MainWindow& window, const QString& file, const QString& picture) {
  const auto end = [](const QString& message) {
    std::fprintf(stderr, "error: %s\n", qPrintable(message));
    QCoreApplication::exit(1);
  };
  QObject::connect(&window.files(), &ProjectFiles::failed, &window, end);
  QObject::connect(&window, &MainWindow::settled, &window, [&window, file, picture, end] {
    if (!window.fusionPage().shown()) {
      end(QCoreApplication::translate("main", "%1: makes no result. Open it to see why.").arg(file));
    } else if (!window.resultPicture(kPictureSize).save(picture)) {
      end(QCoreApplication::translate("main", "%1: cannot be written.").arg(picture));
    } else {
      QCoreApplication::exit(0);
    }
  });
  window.openFile(file);
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();
  // Debian's VTK finds its OpenGL functions through X11; under Wayland the window is XWayland's.
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "xcb");
  }
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);

  QApplication application(argc, argv);
  QApplication::setOrganizationName("Graftsman");
  QApplication::setApplicationName("Graftsman");
  QApplication::setApplicationVersion(GRAFTSMAN_VERSION);
  QApplication::setWindowIcon(applicationIcon());
  IndicatorStyle::install();

#if QT_VERSION < QT_VERSION_CHECK(6, 5, 0)
  const DesktopColours desktopColours;
#endif

  QCommandLineParser parser;
  parser.setApplicationDescription("A workbench for mesh fusion.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("FILE", "A project (.graft), a scenario (.json) or a mesh to open.", "[FILE]");
  const QCommandLineOption picture("picture", "Write a picture of FILE's result to PICTURE and end.",
                                   "PICTURE");
  parser.addOption(picture);
  parser.process(application);
  const QStringList files = parser.positionalArguments();
  if (files.size() > 1 || (parser.isSet(picture) && files.isEmpty())) {
    std::fprintf(stderr, "error: give one file. Try --help.\n");
    return 2;
  }

  MainWindow window(Autosave::defaultFolder());
  window.show();
  if (parser.isSet(picture)) {
    writePicture(window, files.first(), parser.value(picture));
    return QApplication::exec();
  }
  if (!files.isEmpty()) {
    window.openFile(files.first());
  }
  QTimer::singleShot(0, &window, &MainWindow::offerRecovery);
  return QApplication::exec();
}
