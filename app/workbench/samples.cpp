#include "app/workbench/samples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <utility>

namespace graftsman {
namespace {

QString samplesFolder() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* folder :
       {"../share/graftsman/samples", "../../resources/samples", "../resources/samples"}) {
    if (program.exists(folder)) {
      return QDir::cleanPath(program.filePath(folder));
    }
  }
  return GRAFTSMAN_SAMPLES;
}

}  // namespace

std::vector<Sample> findSamples() {
  static constexpr std::pair<const char*, const char*> kSamples[] = {
      {"fig8b_cone_nose", QT_TRANSLATE_NOOP("graftsman::Samples", "A cone for a nose")},
      {"fig9b_bird_plane", QT_TRANSLATE_NOOP("graftsman::Samples", "A penguin's head on a plane")},
      {"fig7_letters_bottle", QT_TRANSLATE_NOOP("graftsman::Samples", "Letters on a bottle")},
      {"fig9a_cars", QT_TRANSLATE_NOOP("graftsman::Samples", "Two cars in one")},
      {"fig4c_cone_sphere", QT_TRANSLATE_NOOP("graftsman::Samples", "A cone on a sphere")},
  };
  std::vector<Sample> samples;
  const QDir folder(samplesFolder());
  for (const auto& [name, title] : kSamples) {
    const QString path = folder.filePath(QString("scenarios/%1.json").arg(name));
    if (QFileInfo::exists(path)) {
      samples.push_back({path, QCoreApplication::translate("graftsman::Samples", title),
                         folder.filePath(QString("pictures/%1.png").arg(name))});
    }
  }
  return samples;
}

}  // namespace graftsman
