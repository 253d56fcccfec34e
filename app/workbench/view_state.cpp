#include "app/workbench/view_state.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <utility>

#include "app/workbench/main_window.h"
#include "app/workbench/variant_pictures.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {
namespace {

constexpr std::pair<const char*, MainWindow::Mode> kModes[] = {{"start", MainWindow::Mode::Start},
                                                               {"tiles", MainWindow::Mode::Tiles},
                                                               {"fusion", MainWindow::Mode::Fusion},
                                                               {"variants", MainWindow::Mode::Variants}};
constexpr const char* kPanes[] = {"partPane", "basePane", "resultPane"};

QJsonArray toJson(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

// False: no three numbers.
bool fromJson(const QJsonValue& value, Eigen::Vector3d& v) {
  const QJsonArray array = value.toArray();
  if (array.size() != 3) {
    return false;
  }
  for (int i = 0; i < 3; ++i) {
    if (!array[i].isDouble()) {
      return false;
    }
    v[i] = array[i].toDouble();
  }
  return v.allFinite();
}

// A file may say anything.
bool isUsable(const Camera& camera) {
  return camera.position != camera.pivot && camera.up.norm() > 0 && std::abs(camera.axis.norm() - 1) < 1e-9;
}

void readPictures(const QJsonObject& values, VariantPictures& pictures) {
  PictureCamera camera;
  camera.viewAngle = values["angle"].toDouble();
  const bool usable = fromJson(values["position"], camera.position) &&
                      fromJson(values["pivot"], camera.pivot) && fromJson(values["up"], camera.up) &&
                      camera.viewAngle > 0 && camera.viewAngle < 3;
  pictures.restoreLook(usable ? std::optional(camera) : std::nullopt, values["dark"].toBool(pictures.dark()));
}

}  // namespace

std::string writeViewState(const MainWindow& window) {
  QJsonObject state;
  for (const auto& [name, mode] : kModes) {
    if (window.mode() == mode) {
      state["mode"] = name;
    }
  }
  QJsonObject cameras;
  for (const char* name : kPanes) {
    const Camera camera = window.findChild<Viewport*>(name)->camera();
    cameras[name] = QJsonObject{{"position", toJson(camera.position)},
                                {"pivot", toJson(camera.pivot)},
                                {"up", toJson(camera.up)},
                                {"axis", toJson(camera.axis)}};
  }
  state["cameras"] = cameras;
  const VariantPictures& pictures = *window.variantsPage().pictures();
  if (const auto& camera = pictures.camera()) {
    state["variantPictures"] = QJsonObject{{"position", toJson(camera->position)},
                                           {"pivot", toJson(camera->pivot)},
                                           {"up", toJson(camera->up)},
                                           {"angle", camera->viewAngle},
                                           {"dark", pictures.dark()}};
  }
  return QJsonDocument(state).toJson(QJsonDocument::Compact).toStdString();
}

void readViewState(const std::string& text, MainWindow& window) {
  const QJsonObject state = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
  const Fusion& fusion = window.model().fusion();
  MainWindow::Mode wanted = fusion.closed                ? MainWindow::Mode::Fusion
                            : fusion.part || fusion.base ? MainWindow::Mode::Tiles
                                                         : MainWindow::Mode::Start;
  for (const auto& [name, mode] : kModes) {
    if (state["mode"].toString() == name) {
      wanted = mode;
    }
  }
  window.setMode(wanted);
  readPictures(state["variantPictures"].toObject(), *window.variantsPage().pictures());
  window.lookAtFirst();
  const QJsonObject cameras = state["cameras"].toObject();
  for (const char* name : kPanes) {
    const QJsonObject values = cameras[name].toObject();
    Camera camera;
    if (fromJson(values["position"], camera.position) && fromJson(values["pivot"], camera.pivot) &&
        fromJson(values["up"], camera.up) && fromJson(values["axis"], camera.axis) && isUsable(camera)) {
      window.findChild<Viewport*>(name)->setCamera(camera);
    }
  }
}

}  // namespace graftsman
