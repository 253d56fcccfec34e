#include "widgets/viewport/colouring_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace graftsman {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
// Steps of the scales; more cannot be told apart in 8 bits.
constexpr std::size_t kSteps = 256;

// The sine of the triangle's smallest angle, which lies between its two longest sides.
float smallestSine(const MorphSheet& sheet, const Face& face) {
  const Eigen::Vector3f a = sheet.position(face[0]);
  const Eigen::Vector3f ab = sheet.position(face[1]) - a;
  const Eigen::Vector3f ac = sheet.position(face[2]) - a;
  const float scale = std::max(ab.cwiseAbs().maxCoeff(), ac.cwiseAbs().maxCoeff());
  if (!(scale > 0)) {
    return 0;
  }
  // In its own size, so that tiny triangles stay within floats.
  const Eigen::Vector3f u = ab / scale;
  const Eigen::Vector3f v = ac / scale;
  const float uu = u.squaredNorm();
  const float vv = v.squaredNorm();
  const float ww = (v - u).squaredNorm();
  const float shortest = std::min({uu, vv, ww});
  const float longer = shortest == uu ? vv * ww : (shortest == vv ? uu * ww : uu * vv);
  return longer > 0 ? std::sqrt(u.cross(v).squaredNorm() / longer) : 0;
}

// The scale of smallest angles by their sines in [0, sin 60°].
const std::array<Rgba, kSteps>& qualityTable() {
  static const std::array<Rgba, kSteps> kTable = [] {
    std::array<Rgba, kSteps> table;
    for (std::size_t i = 0; i < kSteps; ++i) {
      table[i] = SurfaceColours::ofSmallestAngle(std::asin(static_cast<double>(i) / (kSteps - 1)) * kDegrees);
    }
    return table;
  }();
  return kTable;
}

// Colours the sheet's faces; returns the smallest sine, 1 without faces.
float colourQuality(const MorphSheet& sheet, std::vector<Rgba>& colours) {
  const std::array<Rgba, kSteps>& table = qualityTable();
  float smallest = 1;
  for (std::size_t f = 0; f < sheet.faces.size(); ++f) {
    const float sine = std::min(smallestSine(sheet, sheet.faces[f]), 1.0F);
    smallest = std::min(smallest, sine);
    colours[f] = table[static_cast<std::size_t>(std::lround(sine * (kSteps - 1)))];
  }
  return smallest;
}

}  // namespace

Rgba SurfaceColours::ofSeamAngle(double degrees) {
  return sequentialColour(1 - degrees / kGreatestSeamAngle);
}

Rgba SurfaceColours::ofSmallestAngle(double degrees) {
  return sequentialColour(degrees / kGreatestSmallestAngle);
}

SurfaceColours::Origin SurfaceColours::originOf(const CombinedTile& combined, Index vertex) {
  const auto v = static_cast<std::size_t>(vertex);
  const bool ofBase = combined.onBase[v].kind == TileLocation::Kind::OnVertex;
  const bool ofPart = combined.onPart[v].kind == TileLocation::Kind::OnVertex;
  if (ofBase == ofPart) {
    return Origin::Both;
  }
  return ofBase ? Origin::Base : Origin::Part;
}

Rgba SurfaceColours::ofOrigin(Origin origin, const Theme& theme) {
  switch (origin) {
    case Origin::Base:
      return rgba(theme.base);
    case Origin::Part:
      return rgba(theme.part);
    case Origin::Both:
      break;
  }
  return rgba(QColor(theme.dark ? "#F3E9A8" : "#FFF3B0"));
}

SurfaceColours::SurfaceColours(const MorphSurface& surface, Colouring colouring, const Theme& theme)
    : surface_(surface), colouring_(colouring), theme_(theme) {
  using Per = SheetColours::Per;
  const Rgba plain = rgba(theme.mesh);
  for (SheetColours* sheet : {&rest_, &rim_, &tile_}) {
    sheet->uniform = plain;
  }
  const auto perFace = [plain](SheetColours& colours, const MorphSheet& sheet) {
    colours.per = Per::EachFace;
    colours.each.assign(sheet.faces.size(), plain);
  };
  switch (colouring) {
    case Colouring::Plain:
      break;
    case Colouring::FusionCurve:
      rest_.uniform = rim_.uniform = rgba(theme.base);
      tile_.per = Per::EachVertex;
      tile_.each.resize(surface.weights().size());
      break;
    case Colouring::Origin:
      perFace(tile_, surface.tile());
      colourOrigins();
      break;
    case Colouring::SeamAngle:
      perFace(rim_, surface.rim());
      perFace(tile_, surface.tile());
      seam_.resize(surface.seamEdges().size());
      byAngle_.resize(surface.seamEdges().size());
      break;
    case Colouring::Quality:
      perFace(rest_, surface.rest());
      perFace(rim_, surface.rim());
      perFace(tile_, surface.tile());
      restSine_ = colourQuality(surface.rest(), rest_.each);
      break;
  }
  follow(true);
}

void SurfaceColours::follow(bool seamMoved) {
  switch (colouring_) {
    case Colouring::Plain:
    case Colouring::Origin:
      break;
    case Colouring::FusionCurve:
      colourWeights();
      break;
    case Colouring::SeamAngle:
      colourSeam();
      break;
    case Colouring::Quality:
      if (seamMoved) {
        rimSine_ = colourQuality(surface_.rim(), rim_.each);
      }
      const double tileSine = colourQuality(surface_.tile(), tile_.each);
      numbers_.smallestAngle = std::asin(std::min({restSine_, rimSine_, tileSine})) * kDegrees;
      break;
  }
}

void SurfaceColours::colourWeights() {
  const Rgba base = rgba(theme_.base);
  const Rgba part = rgba(theme_.part);
  const std::span<const float> weights = surface_.weights();
  for (std::size_t k = 0; k < weights.size(); ++k) {
    tile_.each[k] = mixed(base, part, weights[k]);
  }
}

// A face's colour is the mean of its vertices': where one mesh is the finer one, its colour prevails.
void SurfaceColours::colourOrigins() {
  const CombinedTile& combined = surface_.combined();
  std::vector<Rgba> ofVertex;
  ofVertex.reserve(combined.s.size());
  for (Index v = 0; v < static_cast<Index>(combined.s.size()); ++v) {
    const Origin origin = originOf(combined, v);
    ofVertex.push_back(ofOrigin(origin, theme_));
    ++(origin == Origin::Base   ? numbers_.baseVertices
       : origin == Origin::Part ? numbers_.partVertices
                                : numbers_.commonVertices);
  }
  for (std::size_t f = 0; f < combined.faces.size(); ++f) {
    const auto& [a, b, c] = combined.faces[f];
    const Rgba& x = ofVertex[static_cast<std::size_t>(a)];
    const Rgba& y = ofVertex[static_cast<std::size_t>(b)];
    const Rgba& z = ofVertex[static_cast<std::size_t>(c)];
    tile_.each[f] = mixed(mixed(x, y, 0.5F), z, 1.0F / 3);
  }
}

void SurfaceColours::colourSeam() {
  measureSeamAngles(surface_, angles_);
  numbers_.meanSeamAngle = angles_.mean;
  numbers_.greatestSeamAngle = angles_.greatest;
  const std::vector<SeamEdge>& edges = surface_.seamEdges();
  // Ascending: a face with two edges on the seam shows the greater angle.
  std::iota(byAngle_.begin(), byAngle_.end(), 0);
  std::sort(byAngle_.begin(), byAngle_.end(), [this](std::size_t i, std::size_t j) {
    return std::tie(angles_.degrees[i], i) < std::tie(angles_.degrees[j], j);
  });
  for (const std::size_t i : byAngle_) {
    seam_[i] = angles_.degrees[i] < 0 ? rgba(theme_.mesh) : ofSeamAngle(angles_.degrees[i]);
    if (edges[i].tileFace >= 0) {
      tile_.each[static_cast<std::size_t>(edges[i].tileFace)] = seam_[i];
    }
    if (edges[i].rimFace >= 0) {
      rim_.each[static_cast<std::size_t>(edges[i].rimFace)] = seam_[i];
    }
  }
}

}  // namespace graftsman
