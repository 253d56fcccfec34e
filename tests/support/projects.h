#pragma once

#include <QtTest>
#include <fstream>
#include <memory>
#include <string>

#include "core/project/project_file.h"
#include "tests/support/shapes.h"

/// Projects for tests, and what their files hold.
namespace graftsman::projects {

inline std::string readAll(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::shared_ptr<const MeshAsset> asset(const std::string& name, shapes::MeshPtr mesh) {
  MeshAsset made;
  made.name = name;
  made.source = "/models/" + name;
  made.report = {MeshFormat::Ply, true, 7, 6, 5, 4, 3, 2, 1};
  made.mesh = std::move(mesh);
  return std::make_shared<const MeshAsset>(std::move(made));
}

/// The project's first fusion, to be changed; no other document has it.
inline Fusion& fusionOf(Project& project) {
  std::shared_ptr<const Fusion>& first = project.document.fusions.front();
  if (first.use_count() > 1) {
    first = std::make_shared<const Fusion>(*first);
  }
  return const_cast<Fusion&>(*first);
}
inline const Fusion& fusionOf(const Project& project) {
  return *project.document.fusions.front();
}

/// A project in which nothing has its default value.
inline Project fullProject() {
  Project project;
  Fusion& fusion = fusionOf(project);
  fusion.name = "Ball on ring";
  fusion.part = asset("ball.ply", shapes::icosphere(2));
  fusion.base = asset("ring.ply", shapes::torus(12, 9));
  fusion.closed = true;
  FusionInputs& inputs = fusion.inputs;
  inputs.part = fusion.part->mesh;
  inputs.base = fusion.base->mesh;
  inputs.loop = {{SurfacePoint::atVertex(3), SurfacePoint::atVertex(107)},
                 {{-1, 319, {0.1, 0.2, 0.7}}, {-1, 0, {1.0 / 3, 1.0 / 3, 1 - 2 * (1.0 / 3)}}},
                 {SurfacePoint::atVertex(0), {-1, 5, {0, 0.5, 0.5}}},
                 {SurfacePoint::atVertex(161), SurfacePoint::atVertex(1)}};
  inputs.paths = PathMode::Paper;
  inputs.tile.allowLargeTile = true;
  inputs.adjustment = {false, false, false, false, 0.1 + 0.2, 4.5, 7};
  inputs.embedding.method = EmbeddingSettings::Method::MeanValue;
  inputs.fcf = FCF::through({{0, 0.1}, {0.1 + 0.2, 0.2}, {0.5, 0.9}, {1, 0.8}}, false).value();
  project.thumbnail = std::string("\x89PNG\r\n\x1a\n\0picture", 16);
  project.viewState = R"({"mode": "tiles"})";
  return project;
}

/// Aborts the program with the message of an error.
inline void mustSucceed(const Result<void>& done) {
  if (!done) {
    qFatal("%s", done.error().message.c_str());
  }
}

}  // namespace graftsman::projects
