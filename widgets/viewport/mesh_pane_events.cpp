// What a person does on a MeshPane: hovers, clicks, drags CVs, walks by keyboard.
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/viewport/mesh_pane_content.h"

namespace graftsman {
namespace {

constexpr double kReach = sizes::kHitArea / 2.0;  // of the pointer, to a CV's or a path's middle
constexpr double kWalkCosine = 0.25;  // an arrow leads to no vertex that lies further aside than this

double distance(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

bool isFree(const QInputEvent& event) {
  return event.modifiers().testFlag(Qt::ControlModifier);
}

bool isArrow(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool isEnter(int key) {
  return key == Qt::Key_Return || key == Qt::Key_Enter;
}

/// The direction of an arrow key on the screen.
QPointF direction(Qt::Key arrow) {
  switch (arrow) {
    case Qt::Key_Left:
      return {-1, 0};
    case Qt::Key_Right:
      return {1, 0};
    case Qt::Key_Up:
      return {0, -1};
    default:
      return {0, 1};
  }
}

/// The vertices that an edge joins to v (of one fan, where the mesh is not manifold there).
std::vector<Index> neighbours(const TriangleMesh& mesh, Index v) {
  std::vector<Index> result;
  const Index first = mesh.outgoing(v);
  for (Index h = first; h >= 0;) {
    result.push_back(mesh.to(h));
    const Index before = TriangleMesh::prev(h);
    h = mesh.twin(before);
    if (h < 0) {
      result.push_back(mesh.from(before));
    } else if (h == first || result.size() > static_cast<std::size_t>(mesh.faceCount())) {
      break;
    }
  }
  return result;
}

/// A place on a path, as seen.
struct PathPlace {
  double distance = kReach;
  QPointF position;
  Point point = Point::Zero();
};

/// The place of the path that is seen nearest to `position`, if nearer than `best`.
bool findNearer(const PathMark& path, const QPointF& position, const CameraView& view, PathPlace& best) {
  bool found = false;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Point& a = path.points[i - 1];
    const Point& b = path.points[i];
    if (view.depth(a) <= 0 || view.depth(b) <= 0) {
      continue;
    }
    const QPointF seenA = view.project(a);
    const QPointF along = view.project(b) - seenA;
    const double length = QPointF::dotProduct(along, along);
    const double t =
        length > 0 ? std::clamp(QPointF::dotProduct(position - seenA, along) / length, 0.0, 1.0) : 0;
    const QPointF seen = seenA + t * along;
    const double off = distance(seen, position);
    if (off < best.distance) {
      // Where the eye's ray passes the segment; not at t, as things far away look shorter.
      const double ratio = t * view.depth(a) / (t * view.depth(a) + (1 - t) * view.depth(b));
      best = {off, seen, a + ratio * (b - a)};
      found = true;
    }
  }
  return found;
}

}  // namespace

MeshPane::Pointed MeshPane::pointedAt(const QPointF& position, bool free) const {
  if (!content_->ready() || !content_->picking) {
    return {};
  }
  using Target = Pointed::Target;
  const CameraView now = view();
  const ShownMesh& shown = *content_->shown;
  Pointed found;
  double nearest = kReach;
  for (const CVMark& cv : content_->marks.cvs) {
    const auto place = shown.place(cv.at);
    if (!place || now.depth(*place) <= 0) {
      continue;
    }
    const double off = distance(now.project(*place), position);
    if (off <= nearest && shown.isVisible(*place, now)) {
      nearest = off;
      found = {Target::CV, cv.number, cv.at};
    }
  }
  if (found.target == Target::CV) {
    return found;
  }
  PathPlace best;
  for (const PathMark& path : content_->marks.paths) {
    const PathPlace before = best;
    if (findNearer(path, position, now, best)) {
      const auto at = shown.isVisible(best.point, now) ? pickAt(best.position, free) : std::nullopt;
      if (at) {
        found = {Target::Path, path.number, *at};
      } else {
        best = before;
      }
    }
  }
  if (found.target == Target::Path) {
    return found;
  }
  const auto at = pickAt(position, free);
  return at ? Pointed{Target::Surface, -1, *at} : Pointed();
}

void MeshPane::hover(const Pointed& pointed) {
  using Target = Pointed::Target;
  if (!(pointed == content_->hovered)) {
    content_->hovered = pointed;
    repaintLater();
  }
  switch (pointed.target) {
    case Target::Nothing:
      unsetCursor();
      break;
    case Target::CV:
      setCursor(Qt::OpenHandCursor);
      break;
    case Target::Path:
      setCursor(Qt::PointingHandCursor);
      break;
    case Target::Surface:
      setCursor(Qt::CrossCursor);
      break;
  }
  const Index vertex = pointed.onSurface() ? pointed.at.vertex : -1;
  if (vertex >= 0) {
    content_->cursorVertex = vertex;
  }
  if (vertex != content_->hoveredVertex) {
    content_->hoveredVertex = vertex;
    Q_EMIT vertexHovered(vertex);
  }
}

void MeshPane::mousePressEvent(QMouseEvent* event) {
  Viewport::mousePressEvent(event);
  if (event->isAccepted() || event->button() != Qt::LeftButton) {
    return;
  }
  event->accept();
  content_->byKeyboard = false;
  content_->lastClickPicked = false;
  const Pointed pointed = pointedAt(event->position(), isFree(*event));
  hover(pointed);
  content_->press = Content::Press{event->position(), pointed};
}

void MeshPane::mouseMoveEvent(QMouseEvent* event) {
  Viewport::mouseMoveEvent(event);
  if (event->isAccepted()) {
    return;
  }
  event->accept();
  content_->byKeyboard = false;
  if (content_->drag) {
    dragTo(event->position(), isFree(*event));
  } else if (!event->buttons().testFlag(Qt::LeftButton)) {
    content_->press.reset();
    hover(pointedAt(event->position(), isFree(*event)));
  } else if (content_->press && distance(content_->press->position, event->position()) > kDragDistance) {
    const Pointed pressed = content_->press->pointed;
    content_->press.reset();
    if (pressed.target == Pointed::Target::CV) {
      content_->drag = Content::Drag{pressed.number, pressed.at};
      setCursor(Qt::ClosedHandCursor);
      Q_EMIT cvDragStarted(pressed.number);
      dragTo(event->position(), isFree(*event));
    }
  }
}

void MeshPane::mouseReleaseEvent(QMouseEvent* event) {
  Viewport::mouseReleaseEvent(event);
  if (event->isAccepted() || event->button() != Qt::LeftButton) {
    return;
  }
  event->accept();
  if (content_->drag) {
    const int number = content_->drag->number;
    content_->drag.reset();
    hover(pointedAt(event->position(), isFree(*event)));
    Q_EMIT cvDragFinished(number);
  } else if (content_->press) {
    const Pointed pressed = content_->press->pointed;
    content_->press.reset();
    click(pressed);
  }
}

void MeshPane::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool takenBack = content_->lastClickPicked && event->button() == Qt::LeftButton;
  content_->lastClickPicked = false;
  Viewport::mouseDoubleClickEvent(event);
  if (takenBack && !content_->press) {
    Q_EMIT pickTakenBack();
  }
}

void MeshPane::wheelEvent(QWheelEvent* event) {
  Viewport::wheelEvent(event);
  if (!content_->drag) {
    hover(pointedAt(event->position(), isFree(*event)));
  }
}

void MeshPane::leaveEvent(QEvent* event) {
  Viewport::leaveEvent(event);
  if (!content_->byKeyboard) {
    hover({});
  }
}

void MeshPane::click(const Pointed& pointed) {
  switch (pointed.target) {
    case Pointed::Target::Nothing:
      break;
    case Pointed::Target::CV:
      Q_EMIT cvClicked(pointed.number);
      break;
    case Pointed::Target::Path:
      content_->lastClickPicked = true;
      Q_EMIT pathClicked(pointed.number, pointed.at);
      break;
    case Pointed::Target::Surface:
      content_->lastClickPicked = true;
      Q_EMIT surfacePicked(pointed.at);
      break;
  }
}

void MeshPane::dragTo(const QPointF& position, bool free) {
  const auto at = pickAt(position, free);
  if (!at || *at == content_->drag->at) {
    return;
  }
  content_->drag->at = *at;
  repaintLater();
  Q_EMIT cvDragged(content_->drag->number, *at);
}

void MeshPane::cancelDrag() {
  if (content_->drag) {
    const int number = content_->drag->number;
    content_->drag.reset();
    unsetCursor();
    repaintLater();
    Q_EMIT cvDragCancelled(number);
  }
}

bool MeshPane::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    // Keys that mean something here now are not to be taken by the window's actions.
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool walks = content_->ready() && content_->picking && isArrow(key);
    if ((key == Qt::Key_Escape && content_->drag) || walks || (isEnter(key) && content_->byKeyboard)) {
      event->accept();
      return true;
    }
  }
  if (event->type() == QEvent::UngrabMouse || event->type() == QEvent::Hide) {
    cancelDrag();
  }
  return Viewport::event(event);
}

void MeshPane::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool picks = content_->ready() && content_->picking && !content_->drag;
  if (key == Qt::Key_Escape && content_->drag) {
    cancelDrag();
  } else if (picks && isArrow(key)) {
    walk(static_cast<Qt::Key>(key));
  } else if (picks && isEnter(key) && content_->byKeyboard && content_->cursorVertex >= 0) {
    pickByKeyboard();
  } else {
    Viewport::keyPressEvent(event);
  }
}

void MeshPane::walk(Qt::Key arrow) {
  const CameraView now = view();
  const TriangleMesh& mesh = *content_->wanted;
  const ShownMesh& shown = *content_->shown;
  const Index from = content_->cursorVertex;
  Index best = -1;
  if (from < 0 || !shown.isVisible(mesh.point(from), now)) {
    // Nothing in sight to start from: what is in the middle of the pane.
    const auto middle = pickAt(QPointF(width(), height()) / 2, false);
    best = middle ? middle->vertex : -1;
  } else {
    const QPointF ahead = direction(arrow);
    double bestCosine = kWalkCosine;
    for (const Index v : neighbours(mesh, from)) {
      const QPointF way = now.project(mesh.point(v)) - now.project(mesh.point(from));
      const double cosine = QPointF::dotProduct(way, ahead) / std::max(distance(way, {}), 1e-12);
      if (cosine > bestCosine && shown.isVisible(mesh.point(v), now)) {
        bestCosine = cosine;
        best = v;
      }
    }
  }
  content_->byKeyboard = true;
  if (best >= 0) {
    hover({Pointed::Target::Surface, -1, SurfacePoint::atVertex(best)});
  }
  repaintLater();
}

void MeshPane::pickByKeyboard() {
  const SurfacePoint at = SurfacePoint::atVertex(content_->cursorVertex);
  const auto& cvs = content_->marks.cvs;
  const auto there = std::ranges::find(cvs, at, &CVMark::at);
  if (there != cvs.end()) {
    Q_EMIT cvClicked(there->number);
    return;
  }
  // As a click there.
  const CameraView now = view();
  const Pointed pointed = pointedAt(now.project(content_->wanted->point(at.vertex)), false);
  if (pointed.target == Pointed::Target::Path) {
    Q_EMIT pathClicked(pointed.number, at);
  } else {
    Q_EMIT surfacePicked(at);
  }
}

}  // namespace graftsman
