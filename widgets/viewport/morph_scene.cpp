#include "widgets/viewport/morph_scene.h"

#include <algorithm>
#include <numeric>

namespace graftsman {
namespace {

constexpr double kRingWidth = 3;
constexpr double kAngleWidth = 5;  // of the seam where its colours are to be read
constexpr double kFaint = 0.3;
// At the very centre a ring has no length: the last that can be seen is shown instead.
constexpr double kLastRing = 0.995;

// The seam from the tile's first vertices.
std::vector<Index> seamEnds(Index size) {
  std::vector<Index> ends;
  for (Index k = 0; k < size; ++k) {
    ends.push_back(k);
    ends.push_back(k + 1 == size ? 0 : k + 1);
  }
  return ends;
}

}  // namespace

MorphScene::MorphScene(vtkRenderer& renderer)
    : rest_(renderer),
      rim_(renderer),
      tile_(renderer),
      partSheet_(renderer),
      seamLine_(renderer),
      ringActor_(renderer) {}

void MorphScene::show(MorphSurface* surface) {
  surface_ = surface;
  colours_.reset();
  if (surface == nullptr) {
    for (SheetActor* sheet : {&rest_, &rim_, &tile_}) {
      sheet->hide();
    }
    seamLine_.hide();
    ringActor_.hide();
    return;
  }
  const Point& centre = surface->centre();
  rest_.show(surface->rest(), centre);
  rim_.show(surface->rim(), centre);
  tile_.show(surface->tile(), centre);
  const MorphSheet tile = surface->tile();
  const Index seamSize = surface->layout().seamSize;
  seamLine_.show(tile.positions, seamSize, seamEnds(seamSize), tile.box, centre);
  colour();
  setRing(ring_);
}

void MorphScene::setCurve(const FCF& curve) {
  if (surface_ == nullptr) {
    return;
  }
  const bool seamMoved = surface_->setCurve(curve);
  tile_.moved();
  if (seamMoved) {
    rest_.normalsChanged();
    rim_.moved();
    seamLine_.moved();
  } else {
    rim_.normalsChanged();  // those of the seam
  }
  colours_->follow(seamMoved);
  showColours();
  if (ring_) {
    showRing();
  }
}

void MorphScene::setLook(const MorphLook& look) {
  const bool recolour = look.colouring != look_.colouring || look.theme.dark != look_.theme.dark;
  look_ = look;
  if (recolour && surface_ != nullptr) {
    colour();
  }
  applyLook();
}

void MorphScene::setRing(std::optional<double> s) {
  ring_ = s;
  if (!s || surface_ == nullptr) {
    ringLine_.clear();
    ringActor_.hide();
    return;
  }
  ringLine_.find(surface_->combined(), std::min(*s, kLastRing));
  showRing();
}

void MorphScene::showRing() {
  const MorphSheet tile = surface_->tile();
  ringLine_.place(tile.positions);
  const auto count = static_cast<Index>(ringLine_.crossings().size());
  ringEnds_.resize(static_cast<std::size_t>(count));
  std::iota(ringEnds_.begin(), ringEnds_.end(), 0);
  ringActor_.show(ringLine_.positions().data(), count, ringEnds_, tile.box, surface_->centre());
}

void MorphScene::setPart(std::optional<StillSheet> part) {
  part_ = std::move(part);
  if (part_) {
    partSheet_.show(part_->sheet(), part_->centre());
  } else {
    partSheet_.hide();
  }
  applyLook();
}

void MorphScene::prepare(const Point& eye) {
  seamLine_.liftTowards(eye);
  ringActor_.liftTowards(eye);
}

void MorphScene::colour() {
  colours_.emplace(*surface_, look_.colouring, look_.theme);
  showColours();
  applyLook();
}

void MorphScene::showColours() {
  rest_.setColours(colours_->rest());
  rim_.setColours(colours_->rim());
  tile_.setColours(colours_->tile());
  seamLine_.setColours(colours_->seam());
}

void MorphScene::applyLook() {
  const Rgba edge = rgba(look_.theme.dark ? QColor(0x38, 0x3B, 0x3F) : QColor(0x78, 0x7D, 0x82));
  for (SheetActor* sheet : {&rest_, &rim_, &tile_, &partSheet_}) {
    sheet->setWireframe(look_.wireframe);
    sheet->setEdges(look_.edges && !look_.wireframe ? look_.ratio : 0, edge);
  }
  tile_.setOpacity(part_ ? kFaint : 1);
  SheetColours partColour;
  partColour.uniform = rgba(look_.theme.part);
  partSheet_.setColours(partColour);
  const bool angles = look_.colouring == Colouring::SeamAngle;
  seamLine_.setColour(rgba(look_.theme.loop));
  seamLine_.setWidth((angles ? kAngleWidth : sizes::kLoopWidth) * look_.ratio);
  seamLine_.setVisible(look_.seam || angles);
  ringActor_.setColour(rgba(look_.theme.selected));
  ringActor_.setWidth(kRingWidth * look_.ratio);
}

}  // namespace graftsman
