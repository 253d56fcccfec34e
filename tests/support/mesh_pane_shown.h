#pragma once

#include <QtTest>
#include <random>

#include "core/fusion/path_position.h"
#include "tests/support/panes.h"
#include "tests/support/shapes.h"

namespace graftsman {

// A pane of 480 × 400 that shows the mesh from a little above the front.
struct Shown {
  MeshPane pane{Side::Base};
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<SurfacePoint> picked;

  explicit Shown(const std::string& model) : mesh(samples::model(model)) {
    pane.resize(480, 400);
    pane.show();
    pane.activateWindow();
    pane.aim({{1, -3, 1}, {0, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()});
    QObject::connect(&pane, &MeshPane::surfacePicked, &pane,
                     [this](const SurfacePoint& at) { picked.push_back(at); });
    if (!QTest::qWaitForWindowActive(&pane) || !panes::showMesh(pane, mesh)) {
      qFatal("the pane is not shown");
    }
  }
  [[nodiscard]] QPoint place(Index vertex) const {
    return pane.screenPosition(mesh->point(vertex)).toPoint();
  }
  /// A vertex that a click at its own place takes, with room round it.
  [[nodiscard]] Index pickable(std::mt19937& random) const {
    while (true) {
      const auto vertex = static_cast<Index>(random() % static_cast<unsigned>(mesh->vertexCount()));
      const QPoint at = place(vertex);
      if (pane.rect().adjusted(60, 60, -60, -60).contains(at) &&
          pane.pickAt(at, false) == SurfacePoint::atVertex(vertex)) {
        return vertex;
      }
    }
  }
};

}  // namespace graftsman
