#include "widgets/viewport/result_pane.h"

#include <QFutureWatcher>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QtConcurrent>
#include <limits>
#include <new>

#include "widgets/theme/theme.h"
#include "widgets/viewport/camera_view.h"
#include "widgets/viewport/colouring_legend.h"
#include "widgets/viewport/morph_rays.h"
#include "widgets/viewport/morph_scene.h"

namespace graftsman {
namespace {

// One answer a frame is as often as it can be seen.
constexpr int kHoverMilliseconds = 16;
constexpr double kElsewhere = -1;

FCF baseAlone() {
  return FCF::through({{0, 0}, {0.3, 0}, {0.7, 0}, {1, 0}}).value();
}

}  // namespace

/// A result made ready to be shown.
struct ResultPane::Shown {
  std::shared_ptr<const FusionResults> results;
  MorphSurface surface;
  SheetRays rest;
  SheetRays rim;
  SheetRays tile;
  bool measured = false;  // whether the rays know where the rim and the tile are now

  Shown(std::shared_ptr<const FusionResults> of, const FCF& curve)
      : results(std::move(of)),
        surface(results->join, results->combined, curve),
        rest(surface.rest()),
        rim(surface.rim()),
        tile(surface.tile()) {
    rest.measure();
  }

  struct Hit {
    float distance;
    double s;  // negative: not on the tile
  };
  std::optional<Hit> cast(const Ray& ray) {
    if (!measured) {
      rim.measure();
      tile.measure();
      measured = true;
    }
    const Eigen::Vector3f origin = (ray.origin - surface.centre()).cast<float>();
    const Eigen::Vector3f direction = ray.direction.cast<float>();
    std::optional<Hit> best;
    float before = std::numeric_limits<float>::max();
    if (const auto hit = tile.nearest(origin, direction, before)) {
      const Face& corners = surface.combined().faces[static_cast<std::size_t>(hit->face)];
      double s = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        s += hit->weights[static_cast<Eigen::Index>(k)] *
             surface.combined().s[static_cast<std::size_t>(corners[k])];
      }
      before = hit->distance;
      best = Hit{before, std::clamp(s, 0.0, 1.0)};
    }
    for (const SheetRays* sheet : {&rim, &rest}) {
      if (const auto hit = sheet->nearest(origin, direction, before)) {
        before = hit->distance;
        best = Hit{before, kElsewhere};
      }
    }
    return best;
  }
};

struct ResultPane::Content {
  explicit Content(vtkRenderer& renderer) : scene(renderer) {}

  FCF curve;
  PartInPlace partInPlace = PartInPlace::Hidden;
  std::shared_ptr<Shown> shown;
  MorphScene scene;  // shows what is in `shown`

  // A large result on its way. Answers that are older than what was set since are thrown away.
  std::shared_ptr<const FusionResults> next;
  QFutureWatcher<std::shared_ptr<Shown>> worker;
  int generation = 0;
  int preparing = 0;  // the generation that the worker is at

  QTimer hoverTimer;
  QPointF pointer;
  double hovered = kElsewhere;
};

ResultPane::ResultPane(QWidget* parent) : Viewport(parent), content_(std::make_unique<Content>(*renderer())) {
  setObjectName(QStringLiteral("resultPane"));
  setAccessibleName(tr("Result"));
  setMouseTracking(true);
  MorphLook look;
  look.theme = themeFor(palette());
  content_->scene.setLook(look);
  content_->hoverTimer.setSingleShot(true);
  content_->hoverTimer.setInterval(kHoverMilliseconds);
  connect(&content_->hoverTimer, &QTimer::timeout, this, &ResultPane::hover);
  connect(&content_->worker, &QFutureWatcherBase::finished, this, [this] {
    const std::shared_ptr<Shown> ready = content_->worker.result();
    if (ready && content_->preparing == content_->generation) {
      present(ready);
    }
    prepareNext();
  });
}

ResultPane::~ResultPane() = default;

void ResultPane::setResults(std::shared_ptr<const FusionResults> results) {
  Content& content = *content_;
  const std::shared_ptr<const Join> join = results && results->fused ? results->join : nullptr;
  const bool sameShape = join && content.shown && content.shown->results->join == join;
  if (!join || sameShape || join->faces.size() <= kManyDrawnFaces) {
    ++content.generation;
    content.next.reset();
  }
  if (!join) {
    content.scene.show(nullptr);
    content.shown.reset();
    showPart();
    tellHovered(kElsewhere);
    renderLater();
    Q_EMIT resultsShown();
    return;
  }
  content.curve = results->inputs.fcf;
  if (sameShape) {
    content.shown->results = std::move(results);
    followCurve();
    Q_EMIT resultsShown();
  } else if (join->faces.size() <= kManyDrawnFaces) {
    present(std::make_shared<Shown>(std::move(results), content.curve));
  } else {
    content.next = std::move(results);
    prepareNext();
  }
}

void ResultPane::prepareNext() {
  Content& content = *content_;
  if (!content.next || content.worker.isRunning()) {
    return;
  }
  content.preparing = content.generation;
  content.worker.setFuture(QtConcurrent::run([results = std::move(content.next), curve = content.curve] {
    try {
      return std::make_shared<Shown>(results, curve);
    } catch (const std::bad_alloc&) {
      return std::shared_ptr<Shown>();  // the pane goes on showing what it has
    }
  }));
  content.next.reset();
}

void ResultPane::present(std::shared_ptr<Shown> shown) {
  Content& content = *content_;
  const bool first = !content.shown;
  content.scene.show(&shown->surface);
  content.shown = std::move(shown);
  showPart();
  if (first) {
    keepFramed();
  }
  Q_EMIT resultsShown();
}

void ResultPane::setCurve(const FCF& curve) {
  content_->curve = curve;
  followCurve();
}

// Below the part in place lies the base as it was.
void ResultPane::followCurve() {
  Content& content = *content_;
  if (!content.shown) {
    return;
  }
  const FCF& curve = content.partInPlace == PartInPlace::Hidden ? content.curve : baseAlone();
  if (curve == content.shown->surface.curve()) {
    return;
  }
  content.scene.setCurve(curve);
  content.shown->measured = false;
  renderLater();
}

template <class Change>
void ResultPane::changeLook(const Change& change) {
  MorphLook look = content_->scene.look();
  change(look);
  content_->scene.setLook(look);
  const SurfaceColours* const colours = content_->scene.colours();
  setAccessibleDescription(colours != nullptr ? legendOf(*colours, look.theme).text() : QString());
  renderLater();
}

void ResultPane::setColouring(Colouring colouring) {
  changeLook([colouring](MorphLook& look) { look.colouring = colouring; });
}

void ResultPane::setEdgesShown(bool shown) {
  changeLook([shown](MorphLook& look) { look.edges = shown; });
}

void ResultPane::setWireframe(bool wireframe) {
  changeLook([wireframe](MorphLook& look) { look.wireframe = wireframe; });
}

void ResultPane::setSeamShown(bool shown) {
  changeLook([shown](MorphLook& look) { look.seam = shown; });
}

void ResultPane::applyTheme(const Theme& theme) {
  changeLook([&theme](MorphLook& look) { look.theme = theme; });
}

void ResultPane::resizeGL(int width, int height) {
  Viewport::resizeGL(width, height);
  if (content_->scene.look().ratio != devicePixelRatioF()) {
    changeLook([this](MorphLook& look) { look.ratio = devicePixelRatioF(); });
  }
}

void ResultPane::setRing(std::optional<double> s) {
  content_->scene.setRing(s);
  renderLater();
}

void ResultPane::setPartInPlace(PartInPlace shown) {
  if (shown != content_->partInPlace) {
    content_->partInPlace = shown;
    showPart();
  }
}

void ResultPane::showPart() {
  Content& content = *content_;
  std::optional<StillSheet> part;
  if (content.shown && content.partInPlace != PartInPlace::Hidden) {
    const FusionResults& results = *content.shown->results;
    if (content.partInPlace == PartInPlace::Before) {
      part.emplace(results.part.tile->points, results.part.tile->faces);
    } else {
      part.emplace(results.fitted->points, results.fitted->faces);
    }
  }
  content.scene.setPart(std::move(part));
  followCurve();
  changeLook([](MorphLook&) {});
}

std::optional<Point> ResultPane::surfaceAt(const QPointF& position) const {
  if (!content_->shown) {
    return {};
  }
  const Ray ray = view().rayThrough(position);
  const auto hit = content_->shown->cast(ray);
  return hit ? std::optional<Point>(ray.origin + static_cast<double>(hit->distance) * ray.direction)
             : std::nullopt;
}

std::vector<StandIn*> ResultPane::standIns() const {
  return content_->scene.standIns();
}

void ResultPane::prepareFrame(const CameraView& view) {
  content_->scene.prepare(view.camera.position);
}

void ResultPane::paintOver(QPainter& painter, const CameraView& view) {
  if (const SurfaceColours* const colours = content_->scene.colours()) {
    painter.setFont(font());
    paintLegend(painter, legendOf(*colours, content_->scene.look().theme), QRectF(QPointF(), view.size),
                palette());
  }
}

void ResultPane::mouseMoveEvent(QMouseEvent* event) {
  Viewport::mouseMoveEvent(event);
  content_->pointer = event->position();
  if (event->isAccepted()) {  // the camera moves
    tellHovered(kElsewhere);
  } else if (!content_->hoverTimer.isActive()) {
    content_->hoverTimer.start();
  }
}

void ResultPane::leaveEvent(QEvent* event) {
  Viewport::leaveEvent(event);
  content_->hoverTimer.stop();
  tellHovered(kElsewhere);
}

void ResultPane::hover() {
  Content& content = *content_;
  if (!content.shown || content.partInPlace != PartInPlace::Hidden) {
    tellHovered(kElsewhere);
    return;
  }
  const auto hit = content.shown->cast(view().rayThrough(content.pointer));
  tellHovered(hit ? hit->s : kElsewhere);
}

void ResultPane::tellHovered(double s) {
  if (s != content_->hovered) {
    content_->hovered = s;
    Q_EMIT sHovered(s);
  }
}

}  // namespace graftsman

#include "moc_result_pane.cpp"  // NOLINT(bugprone-suspicious-include)
