#pragma once

#include <QtTest>
#include <filesystem>
#include <string>
#include <vector>

#include "core/fusion/update.h"
#include "core/io/mesh_file.h"
#include "core/io/scenario.h"
#include "tests/support/places.h"

/// The project's sample models and scenarios, for tests.
namespace graftsman::samples {

inline const std::vector<std::string> kScenarios = {
    "fig4a_cone_sphere",     "fig4b_cone_sphere", "fig4c_cone_sphere", "fig4d_cone_sphere",
    "fig7_letters_bottle",   "fig8b_cone_nose",   "fig8c_cone_nose",   "fig8d_hemisphere_nose",
    "fig8e_hemisphere_nose", "fig9a_cars",        "fig9b_bird_plane"};

inline const std::vector<std::string> kModels = {"cone.stl",   "sphere.off",  "hemisphere.stl", "letters.obj",
                                                 "bottle.ply", "head.obj",    "nefertiti.ply",  "beetle.off",
                                                 "boxcar.off", "penguin.obj", "plane.ply",      "spot.obj"};

inline std::filesystem::path scenarioPath(const std::string& name) {
  return places::samples() / "scenarios" / (name + ".json");
}

inline std::filesystem::path modelPath(const std::string& name) {
  return places::samples() / "models" / name;
}

/// The inputs of a sample scenario; aborts the program with the message if it cannot be read.
inline FusionInputs load(const std::string& name) {
  const Result<LoadedScenario> loaded = readScenario(scenarioPath(name), {});
  if (!loaded) {
    qFatal("%s", loaded.error().message.c_str());
  }
  return loaded->scenario.inputs;
}

inline std::shared_ptr<const TriangleMesh> model(const std::string& name) {
  const Result<MeshFile> file = readMesh(modelPath(name), {});
  if (!file) {
    qFatal("%s", file.error().message.c_str());
  }
  return file->mesh;
}

}  // namespace graftsman::samples
