#include "widgets/viewport/mesh_pane.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "widgets/viewport/mesh_pane_content.h"
#include "widgets/viewport/shading.h"

namespace graftsman {
namespace {

constexpr std::size_t kTileAtOnce = 20000;  // faces that are made ready within a frame
constexpr int kFlashMilliseconds = 700;
constexpr double kAmbient = 0.1;  // light that shadows keep

std::shared_ptr<const ShownMesh> makeShown(std::shared_ptr<const TriangleMesh> mesh) {
  try {
    return std::make_shared<const ShownMesh>(std::move(mesh));
  } catch (const std::bad_alloc&) {
    return nullptr;  // the pane shows nothing; there is no memory for the model either way
  }
}

DrawnTriangles makeTile(const Tile& tile, const Eigen::AlignedBox3d& box) {
  try {
    const TriangleMesh mesh(tile.points, tile.faces);
    return drawTriangles(mesh, shade(mesh), box);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

/// The unit normal of the surface at a point of it.
Eigen::Vector3d outwardAt(const TriangleMesh& mesh, const SurfacePoint& at) {
  const auto areaOf = [&](Index face) -> Eigen::Vector3d {
    const Face& corners = mesh.face(face);
    const Point& origin = mesh.point(corners[0]);
    return (mesh.point(corners[1]) - origin).cross(mesh.point(corners[2]) - origin);
  };
  if (at.vertex < 0) {
    return areaOf(at.face).stableNormalized();
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Index first = mesh.outgoing(at.vertex);
  for (Index h = first; h >= 0;) {
    sum += areaOf(TriangleMesh::faceOf(h));
    h = mesh.twin(TriangleMesh::prev(h));
    if (h == first) {
      break;
    }
  }
  return sum.stableNormalized();
}

}  // namespace

MeshPane::Content::Content(MeshPane& pane, Side meshSide)
    : side(meshSide),
      standIn(*pane.renderer(), *actor, vtkSmartPointer<vtkPolyDataMapper>::New()),
      loop(*pane.renderer()),
      meshJob([&pane](std::shared_ptr<const ShownMesh> made) { pane.showMesh(std::move(made)); }),
      tileJob([this, &pane](const DrawnTriangles& made) {
        loop.setTile(made);
        pane.renderLater();
      }) {
  mapper->SetScalarVisibility(false);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(kAmbient);
  actor->GetProperty()->SetDiffuse(1 - kAmbient);
  actor->SetVisibility(false);
  pane.renderer()->AddActor(actor);
  flash.setStartValue(0.0);
  flash.setEndValue(1.0);
  flash.setDuration(kFlashMilliseconds);
  QObject::connect(&flash, &QVariantAnimation::valueChanged, &pane, [&pane] { pane.repaintLater(); });
}

MeshPane::MeshPane(Side side, QWidget* parent)
    : Viewport(parent), content_(std::make_unique<Content>(*this, side)) {
  setObjectName(side == Side::Part ? "partPane" : "basePane");
  setAccessibleName(side == Side::Part ? tr("Part, 3D view") : tr("Base, 3D view"));
  setAccessibleDescription(tr("Arrow keys walk over the vertices, Enter picks."));
  MeshPane::applyTheme(themeFor(palette()));
}

MeshPane::~MeshPane() = default;

void MeshPane::setMesh(std::shared_ptr<const TriangleMesh> mesh) {
  if (mesh == content_->wanted) {
    return;
  }
  cancelDrag();
  content_->press.reset();
  content_->wanted = std::move(mesh);
  content_->marks = {};
  content_->cursorVertex = -1;
  showMarks();
  hover({});
  if (content_->wanted) {
    setPreparing(true);
    content_->meshJob.start([wanted = content_->wanted] { return makeShown(wanted); });
  } else {
    content_->meshJob.cancel();
    showMesh(nullptr);
  }
}

void MeshPane::showMesh(std::shared_ptr<const ShownMesh> shown) {
  content_->shown = std::move(shown);
  setPreparing(false);
  content_->actor->SetVisibility(content_->shown != nullptr);
  if (content_->shown) {
    content_->mapper->SetInputData(content_->shown->drawn().all);
    content_->standIn.setInput(content_->shown->drawn().few);
    keepFramed();
  }
  showMarks();
  renderLater();
  if (content_->ready()) {
    Q_EMIT meshShown();
  }
}

void MeshPane::setMarks(LoopMarks marks) {
  content_->marks = std::move(marks);
  const auto& cvs = content_->marks.cvs;
  if (content_->drag &&
      std::ranges::none_of(cvs, [this](const CVMark& cv) { return cv.number == content_->drag->number; })) {
    cancelDrag();
  }
  showMarks();
}

void MeshPane::showMarks() {
  const std::vector<PathMark> paths = content_->ready() ? content_->marks.paths : std::vector<PathMark>();
  if (paths != content_->drawnPaths) {
    content_->loop.setPaths(paths);
    content_->drawnPaths = paths;
    renderLater();
  }
  showTile();
  repaintLater();
}

void MeshPane::showTile() {
  const std::shared_ptr<const Tile> tile = content_->ready() ? content_->marks.tile : nullptr;
  if (tile == content_->drawnTile) {
    return;
  }
  content_->drawnTile = tile;
  renderLater();
  if (tile && tile->faces.size() > kTileAtOnce) {
    content_->tileJob.start([tile, box = content_->shown->box()] { return makeTile(*tile, box); });
  } else {
    content_->tileJob.cancel();
    content_->loop.setTile(tile ? makeTile(*tile, content_->shown->box()) : DrawnTriangles());
  }
}

void MeshPane::setPicking(bool enabled) {
  content_->picking = enabled;
  if (!enabled) {
    cancelDrag();
    content_->press.reset();
    hover({});
  }
}

void MeshPane::flashCV(int number) {
  content_->flash.stop();
  content_->flashed = number;
  content_->flash.start();
  const auto& cvs = content_->marks.cvs;
  const auto mark = std::ranges::find(cvs, number, &CVMark::number);
  if (mark != cvs.end() && content_->ready()) {
    bringIntoSight(mark->at);
  }
}

void MeshPane::bringIntoSight(const SurfacePoint& at) {
  const auto place = content_->shown->place(at);
  if (!place) {
    return;
  }
  const CameraView now = view();
  const bool faces = content_->shown->isVisible(*place, now);
  const bool within = now.depth(*place) > 0 && QRectF(rect()).contains(now.project(*place));
  if (faces && within) {
    return;
  }
  Camera camera = moved(now.camera, *place - now.camera.pivot);
  if (!faces) {
    const Eigen::Vector3d outward = outwardAt(*content_->wanted, at);
    camera.position = *place + (camera.position - *place).norm() * outward;
  }
  glideTo(camera);
}

std::optional<SurfacePoint> MeshPane::pickAt(const QPointF& position, bool free) const {
  if (!content_->ready()) {
    return {};
  }
  const CameraView now = view();
  const auto hit = content_->shown->firstHit(now.rayThrough(position));
  if (!hit) {
    return {};
  }
  if (free) {
    return SurfacePoint{-1, hit->face, hit->bary};
  }
  const TriangleMesh& mesh = *content_->wanted;
  const auto seenDistance = [&](Index vertex) {
    const Point& point = mesh.point(vertex);
    const QPointF off = now.project(point) - position;
    return now.depth(point) > 0 ? std::hypot(off.x(), off.y()) : std::numeric_limits<double>::infinity();
  };
  return SurfacePoint::atVertex(*std::ranges::min_element(mesh.face(hit->face), {}, seenDistance));
}

std::optional<Point> MeshPane::surfaceAt(const QPointF& position) const {
  if (!content_->shown) {
    return {};
  }
  const auto hit = content_->shown->firstHit(view().rayThrough(position));
  return hit ? std::optional(hit->point) : std::nullopt;
}

void MeshPane::applyTheme(const Theme& theme) {
  vtkProperty& look = *content_->actor->GetProperty();
  look.SetColor(theme.mesh.redF(), theme.mesh.greenF(), theme.mesh.blueF());
  content_->loop.applyTheme(theme, content_->side);
}

std::vector<StandIn*> MeshPane::standIns() const {
  return {&content_->standIn, &content_->loop.standIn()};
}

void MeshPane::prepareFrame(const CameraView& view) {
  content_->loop.prepare(view);
}

}  // namespace graftsman

#include "moc_mesh_pane.cpp"  // NOLINT(bugprone-suspicious-include)
