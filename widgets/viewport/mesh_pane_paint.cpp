// What a MeshPane paints over its scene: CVs with their numbers, the vertex under the pointer, a flash.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/viewport/mesh_pane_content.h"

namespace graftsman {
namespace {

constexpr double kHiddenOpacity = 0.3;  // of marks on the far side

/// Paints a picture with its middle at a place, on whole device pixels so that it stays sharp.
void paintAt(QPainter& painter, const QPointF& position, const QImage& image, double ratio) {
  const QPointF corner = position * ratio + QPointF(0.5, 0.5) - QPointF(image.width(), image.height()) / 2;
  painter.drawImage(QPointF(std::round(corner.x()), std::round(corner.y())) / ratio, image);
}

/// Where a CV's number is painted: right above it, or left where the pane ends.
QPointF labelPosition(const QPointF& mark, const QSizeF& label, const QSizeF& pane) {
  constexpr double kRight = 6;
  constexpr double kUp = 3;
  const double dx = kRight + label.width() / 2;
  const bool fits = mark.x() + dx + label.width() / 2 < pane.width();
  return {mark.x() + (fits ? dx : -dx), std::max(mark.y() - kUp - label.height() / 2, label.height() / 2)};
}

}  // namespace

void MeshPane::paintOver(QPainter& painter, const CameraView& view) {
  if (!content_->ready()) {
    return;
  }
  content_->pictures.prepare(themeFor(palette()), font(), view.ratio);
  paintProblemPaths(painter, view);
  paintCVs(painter, view);
  paintPointed(painter, view);
}

void MeshPane::paintProblemPaths(QPainter& painter, const CameraView& view) {
  for (const PathMark& path : content_->marks.paths) {
    if (!path.problem || path.points.empty()) {
      continue;
    }
    const Point& middle = path.points[path.points.size() / 2];
    if (content_->shown->isVisible(middle, view)) {
      paintAt(painter, view.project(middle), content_->pictures.problemSign(), view.ratio);
    }
  }
}

void MeshPane::paintCVs(QPainter& painter, const CameraView& view) {
  struct Seen {
    QPointF position;
    MarkLook look;
  };
  MarkPictures& pictures = content_->pictures;
  std::vector<Seen> inSight;
  const Pointed& pointed = content_->hovered;
  for (const CVMark& cv : content_->marks.cvs) {
    const auto place = content_->shown->place(cv.at);
    if (!place || view.depth(*place) <= 0) {
      continue;
    }
    const bool hovered = pointed.target == Pointed::Target::CV && pointed.number == cv.number;
    const Seen seen{view.project(*place), {cv.number, cv.hollow, cv.selected, cv.problem, hovered}};
    if (content_->shown->isVisible(*place, view)) {
      inSight.push_back(seen);
      continue;
    }
    painter.setOpacity(kHiddenOpacity);
    paintAt(painter, seen.position, pictures.sphere(seen.look), view.ratio);
    painter.setOpacity(1);
  }
  for (const Seen& seen : inSight) {
    paintAt(painter, seen.position, pictures.sphere(seen.look), view.ratio);
    if (content_->flash.state() == QAbstractAnimation::Running && seen.look.number == content_->flashed) {
      const double t = content_->flash.currentValue().toDouble();
      paintAt(painter, seen.position, pictures.ring(sizes::kCVSphere + 20 * t, 1 - t), view.ratio);
    }
  }
  // All numbers after all spheres: none is hidden by one.
  for (const Seen& seen : inSight) {
    const QImage label = pictures.label(seen.look);
    paintAt(painter, labelPosition(seen.position, label.deviceIndependentSize(), view.size), label,
            view.ratio);
  }
}

void MeshPane::paintPointed(QPainter& painter, const CameraView& view) {
  const SurfacePoint* at = nullptr;
  if (content_->drag) {
    at = &content_->drag->at;
  } else if (content_->hovered.onSurface()) {
    at = &content_->hovered.at;
  }
  // Not on a CV that has just been picked there: a hollow one would look full.
  if (at && !content_->drag &&
      std::ranges::find(content_->marks.cvs, *at, &CVMark::at) != content_->marks.cvs.end()) {
    at = nullptr;
  }
  const auto place = at ? content_->shown->place(*at) : std::nullopt;
  if (place && view.depth(*place) > 0) {
    paintAt(painter, view.project(*place), content_->pictures.dot(content_->byKeyboard), view.ratio);
  }
}

}  // namespace graftsman
