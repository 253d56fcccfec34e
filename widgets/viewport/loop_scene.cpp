#include "widgets/viewport/loop_scene.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace graftsman {
namespace {

// How much nearer to the eye than the mesh, in parts of the distance: enough for a line of 2 px on a slope of
// 80°, where a pixel's depth is the greater part of it.
constexpr double kLineLift = 4e-3;
constexpr double kTileLift = 5e-4;

constexpr double kDashPixels = 7;
constexpr double kDashShare = 0.6;  // of a dash and its gap

vtkSmartPointer<vtkPolyData> polylines(const std::vector<std::vector<Point>>& lines) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Point& point : line) {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

double lengthOf(const std::vector<Point>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += (line[i] - line[i - 1]).norm();
  }
  return length;
}

/// The pieces of a line that are drawn when it is dashed with this length, or a longer one if they were
/// uncountable.
void addDashes(const std::vector<Point>& line, double wanted, std::vector<std::vector<Point>>& pieces) {
  constexpr double kMostDashes = 2000;
  const double dash = std::max(wanted, lengthOf(line) / kMostDashes);
  const double on = dash * kDashShare;
  double along = 0;  // since the last dash began
  pieces.push_back({line.front()});
  for (std::size_t i = 1; i < line.size(); ++i) {
    Point at = line[i - 1];
    const Point& end = line[i];
    for (double rest = (end - at).norm(); rest > 0;) {
      const bool drawn = along < on;
      const double step = std::min(rest, (drawn ? on : dash) - along);
      at += (end - at) * (step / rest);
      rest -= step;
      along += step;
      if (drawn) {
        pieces.back().push_back(at);
      }
      if (!drawn && along >= dash) {
        along = 0;
        pieces.push_back({at});
      } else if (step <= 0) {
        break;  // lengths below what doubles resolve here
      }
    }
  }
  std::erase_if(pieces, [](const auto& piece) { return piece.size() < 2; });
}

void lift(vtkActor& actor, const Point& eye, double by) {
  vtkNew<vtkMatrix4x4> towardsEye;
  for (int i = 0; i < 3; ++i) {
    towardsEye->SetElement(i, i, 1 - by);
    towardsEye->SetElement(i, 3, by * eye[i]);
  }
  actor.SetUserMatrix(towardsEye);
}

void setColour(vtkActor& actor, const QColor& colour) {
  actor.GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

}  // namespace

LoopScene::LoopScene(vtkRenderer& renderer)
    : standIn_(renderer, *tile_.actor, vtkSmartPointer<vtkPolyDataMapper>::New()) {
  for (Part* part : {&tile_, &sound_, &problem_}) {
    add(renderer, *part);
  }
  for (Part* part : {&sound_, &problem_}) {
    part->actor->GetProperty()->SetLighting(false);
  }
}

LoopScene::~LoopScene() = default;

void LoopScene::add(vtkRenderer& renderer, Part& part) {
  part.mapper->SetScalarVisibility(false);
  part.actor->SetMapper(part.mapper);
  part.actor->SetVisibility(false);
  part.actor->SetUseBounds(false);  // the mesh alone is framed
  renderer.AddActor(part.actor);
}

void LoopScene::setPaths(const std::vector<PathMark>& paths) {
  std::vector<std::vector<Point>> sound;
  problemPaths_.clear();
  for (const PathMark& path : paths) {
    if (path.points.size() >= 2) {
      (path.problem ? problemPaths_ : sound).push_back(path.points);
    }
  }
  sound_.mapper->SetInputData(polylines(sound));
  sound_.actor->SetVisibility(!sound.empty());
  problem_.actor->SetVisibility(!problemPaths_.empty());
  dash_ = 0;
}

void LoopScene::setTile(const DrawnTriangles& tile) {
  tile_.actor->SetVisibility(tile.all != nullptr);
  standIn_.setInput(tile.few);
  if (tile.all) {
    tile_.mapper->SetInputData(tile.all);
  }
}

void LoopScene::applyTheme(const Theme& theme, Side side) {
  constexpr float kTint = 0.55F;
  const QColor& tint = theme.of(side);
  const QColor& mesh = theme.mesh;
  setColour(*tile_.actor, QColor::fromRgbF(kTint * tint.redF() + (1 - kTint) * mesh.redF(),
                                           kTint * tint.greenF() + (1 - kTint) * mesh.greenF(),
                                           kTint * tint.blueF() + (1 - kTint) * mesh.blueF()));
  setColour(*sound_.actor, theme.loop);
  setColour(*problem_.actor, theme.problem);
}

void LoopScene::prepare(const CameraView& view) {
  const Point& eye = view.camera.position;
  lift(*tile_.actor, eye, kTileLift);
  lift(*sound_.actor, eye, kLineLift);
  lift(*problem_.actor, eye, kLineLift);
  const auto width = static_cast<float>(sizes::kLoopWidth * view.ratio);
  sound_.actor->GetProperty()->SetLineWidth(width);
  problem_.actor->GetProperty()->SetLineWidth(width);
  if (problemPaths_.empty()) {
    return;
  }
  // Dashes keep about their size on the screen: cut anew when it has changed by more than a third.
  const double wanted = kDashPixels / kDashShare * view.pixelLength(view.depth(problemPaths_[0][0]));
  if (wanted > 0 && (dash_ == 0 || std::abs(std::log(wanted / dash_)) > 0.3)) {
    dash_ = wanted;
    std::vector<std::vector<Point>> dashes;
    for (const auto& path : problemPaths_) {
      addDashes(path, dash_, dashes);
    }
    problem_.mapper->SetInputData(polylines(dashes));
  }
}

}  // namespace graftsman
