#include "core/fusion/seam_merge.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "core/fusion/halfedge_twins.h"
#include "core/fusion/overlay_predicates.h"
#include "core/fusion/seam_snap.h"

namespace graftsman::overlay_detail {
namespace {

/// The common boundary, and where each boundary vertex of one embedding is in it.
struct Seam {
  std::vector<BoundaryPosition> positions;
  std::vector<Index> ofPart;
  std::vector<Index> ofBase;
};

Seam mergePositions(const std::vector<BoundaryPosition>& part, const std::vector<BoundaryPosition>& base) {
  Seam seam;
  seam.ofPart.reserve(part.size());
  seam.ofBase.reserve(base.size());
  auto p = part.begin();
  auto b = base.begin();
  while (p != part.end() || b != base.end()) {
    const bool takesPart = b == base.end() || (p != part.end() && *p <= *b);
    const bool takesBase = p == part.end() || (b != base.end() && *b <= *p);
    const auto k = static_cast<Index>(seam.positions.size());
    seam.positions.push_back(takesPart ? *p : *b);
    if (takesPart) {
      seam.ofPart.push_back(k);
      ++p;
    }
    if (takesBase) {
      seam.ofBase.push_back(k);
      ++b;
    }
  }
  return seam;
}

tl::unexpected<Error> failTooFine(Side side, const BoundaryPosition& where, Index sides) {
  const int from = where.side;
  const int to = (where.side + 1) % sides;
  Error error{ErrorCode::CombinedTileTooFine,
              std::string("The tiles cannot be combined: between CV ") + std::to_string(from) + " and CV " +
                  std::to_string(to) + ", triangles of the " + name(side) +
                  " are too thin to be divided in double precision. Move one of these CVs, or add a pair "
                  "between them."};
  error.side = side;
  error.cvs = {from, to};
  error.paths = {from};
  return fail(std::move(error));
}

// Seam vertices of one side must follow each other along it, so that the polygon is simple.
bool advances(const std::vector<BoundaryPosition>& seam, const std::vector<Point2>& uv, std::size_t k,
              Index sides) {
  const Point2 along =
      boundaryPoint(sides, {(seam[k].side + 1) % sides, 0}) - boundaryPoint(sides, {seam[k].side, 0});
  return (uv[(k + 1) % seam.size()] - uv[k]).dot(along) > 0;
}

/// Makes one layer.
class LayerBuilder {
 public:
  LayerBuilder(const Embedding& embedding, const std::vector<BoundaryPosition>& ownBoundary,
               const std::vector<BoundaryPosition>& seam, const std::vector<Index>& seamOfBoundary)
      : embedding_(embedding), own_(ownBoundary), seam_(seam), seamOfBoundary_(seamOfBoundary) {}

  Layer build() {
    layer_.embedding = &embedding_;
    placeSeam();
    placeVertices();
    divideFaces();
    layer_.twins = pairHalfedges(layer_.faces, layer_.vertexCount());
    layer_.boundaryHalfedges.assign(seam_.size(), -1);
    for (Index h = 0; h < layer_.halfedgeCount(); ++h) {
      if (layer_.twin(h) < 0) {
        assert(layer_.from(h) < layer_.seamSize());
        layer_.boundaryHalfedges[static_cast<std::size_t>(layer_.from(h))] = h;
      }
    }
    return std::move(layer_);
  }

 private:
  void placeSeam() {
    layer_.seam.resize(seam_.size());
    for (std::size_t i = 0; i < own_.size(); ++i) {
      const std::size_t begin = static_cast<std::size_t>(seamOfBoundary_[i]);
      const std::size_t end =
          i + 1 < own_.size() ? static_cast<std::size_t>(seamOfBoundary_[i + 1]) : seam_.size();
      const double from = own_[i].t;
      const double to = i + 1 < own_.size() && own_[i + 1].side == own_[i].side ? own_[i + 1].t : 1;
      layer_.seam[begin] = {static_cast<Index>(i), 0};
      for (std::size_t k = begin + 1; k < end; ++k) {
        // Between the two vertices, and so it must stay where the quotient is rounded.
        const double t = std::clamp((seam_[k].t - from) / (to - from), std::numeric_limits<double>::min(),
                                    std::nextafter(1.0, 0.0));
        layer_.seam[k] = {static_cast<Index>(i), t};
      }
    }
  }

  void placeVertices() {
    const std::size_t boundary = own_.size();
    layer_.uv.reserve(embedding_.uv.size() + seam_.size() - boundary);
    for (const BoundaryPosition& position : seam_) {
      layer_.uv.push_back(boundaryPoint(embedding_.sides, position));
    }
    layer_.uv.insert(layer_.uv.end(), embedding_.uv.begin() + static_cast<std::ptrdiff_t>(boundary),
                     embedding_.uv.end());
  }

  // A boundary triangle is fanned to the corner opposite to its boundary edge, which is interior.
  void divideFaces() {
    const auto boundary = static_cast<Index>(own_.size());
    const auto seamSize = static_cast<Index>(seam_.size());
    const std::size_t faceCount = embedding_.faces.size() + seam_.size() - own_.size();
    layer_.faces.reserve(faceCount);
    layer_.origins.reserve(faceCount);
    const auto renumbered = [&](Index v) {
      return v < boundary ? seamOfBoundary_[static_cast<std::size_t>(v)] : v - boundary + seamSize;
    };
    for (std::size_t f = 0; f < embedding_.faces.size(); ++f) {
      const Face& face = embedding_.faces[f];
      std::size_t k = 0;
      while (k < 3 && !(face[k] < boundary && face[(k + 1) % 3] == (face[k] + 1) % boundary)) {
        ++k;
      }
      if (k == 3) {
        add({renumbered(face[0]), renumbered(face[1]), renumbered(face[2])}, f);
        continue;
      }
      const Index apex = renumbered(face[(k + 2) % 3]);
      assert(apex >= seamSize);
      const Index begin = renumbered(face[k]);
      const Index end = face[(k + 1) % 3] == 0 ? seamSize : renumbered(face[(k + 1) % 3]);
      for (Index s = begin; s < end; ++s) {
        add({s, (s + 1) % seamSize, apex}, f);
      }
    }
  }

  void add(const Face& face, std::size_t origin) {
    layer_.faces.push_back(face);
    layer_.origins.push_back(static_cast<Index>(origin));
  }

  const Embedding& embedding_;
  const std::vector<BoundaryPosition>& own_;
  const std::vector<BoundaryPosition>& seam_;
  const std::vector<Index>& seamOfBoundary_;
  Layer layer_;
};

/// Mends triangles beside the boundary that dividing made flat or clockwise: positions on a side are rounded,
/// so that an apex may lie within 1e-16 of the side and beyond the new vertices.
class ApexRepair {
 public:
  explicit ApexRepair(Layer& layer) : layer_(layer) {}

  /// Moves the apex of the triangle at boundary halfedge h as little as makes all triangles round it
  /// counter-clockwise. False: found no such position.
  bool mend(Index h) {
    const Index apex = layer_.from(Layer::prev(h));
    if (apex < layer_.seamSize()) {
      return false;
    }
    Point2& position = layer_.uv[static_cast<std::size_t>(apex)];
    const Point2 old = position;
    gatherStar(Layer::prev(h));
    Point2 inside = Point2::Zero();
    for (const Index rim : star_) {
      inside += layer_.at(layer_.to(rim)) / static_cast<double>(star_.size());
    }
    for (int exponent = -50; exponent <= -1; exponent += 2) {
      position = old + std::ldexp(1.0, exponent) * (inside - old);
      if (starIsValid()) {
        return true;
      }
    }
    position = old;
    return false;
  }

 private:
  // The halfedges that leave the vertex from which `first` leaves. It is interior.
  void gatherStar(Index first) {
    star_.clear();
    Index h = first;
    do {
      star_.push_back(h);
      h = layer_.twin(Layer::prev(h));
      assert(h >= 0);
    } while (h != first);
  }

  [[nodiscard]] bool starIsValid() const {
    return std::all_of(star_.begin(), star_.end(),
                       [&](Index h) { return isCounterClockwise(layer_, h / 3); });
  }

 public:
  static bool isCounterClockwise(const Layer& layer, Index f) {
    const auto& [a, b, c] = layer.faces[static_cast<std::size_t>(f)];
    return orient2d(layer.at(a), layer.at(b), layer.at(c)) > 0;
  }

 private:
  Layer& layer_;
  std::vector<Index> star_;
};

/// Checks the triangles at the boundary, and mends them if need be.
Result<void> checkLayer(Layer& layer, Side side, const std::vector<BoundaryPosition>& seam) {
  const Index sides = layer.embedding->sides;
  ApexRepair repair(layer);
  for (std::size_t k = 0; k < seam.size(); ++k) {
    if (!advances(seam, layer.uv, k, sides)) {
      return failTooFine(side, seam[k], sides);
    }
  }
  for (std::size_t k = 0; k < seam.size(); ++k) {
    const Index h = layer.boundaryHalfedges[k];
    if (!ApexRepair::isCounterClockwise(layer, h / 3) && !repair.mend(h)) {
      return failTooFine(side, seam[k], sides);
    }
  }
  return {};
}

}  // namespace

Result<Layers> mergeSeams(const Embedding& part, const Embedding& base) {
  assert(part.sides == base.sides && part.sides >= 3);
  const std::vector<BoundaryPosition> partBoundary = snapBoundary(part, base);
  const Seam seam = mergePositions(partBoundary, base.boundary);
  Layers layers{LayerBuilder(part, partBoundary, seam.positions, seam.ofPart).build(),
                LayerBuilder(base, base.boundary, seam.positions, seam.ofBase).build()};
  if (auto checked = checkLayer(layers.part, Side::Part, seam.positions); !checked) {
    return tl::unexpected(checked.error());
  }
  if (auto checked = checkLayer(layers.base, Side::Base, seam.positions); !checked) {
    return tl::unexpected(checked.error());
  }
  return layers;
}

}  // namespace graftsman::overlay_detail
