#include "core/fusion/overlay_vertices.h"

#include <algorithm>
#include <cmath>

#include "core/base/large_array.h"
#include "core/base/parallel.h"
#include "core/fusion/layer_locations.h"
#include "core/fusion/overlay_predicates.h"

namespace graftsman::overlay_detail {
namespace {

constexpr std::size_t kVertexGrain = 16384;  // vertices a thread takes at a time

/// Where along both of its edges a crossing lies: fractions of `Crossing::base` and `Crossing::part`.
struct Fractions {
  double onBase;
  double onPart;
};

double ratio(double a, double b) {
  a = std::max(a, 0.0);
  b = std::max(b, 0.0);
  return a + b > 0 ? a / (a + b) : 0.5;
}

// From areas: differences of the exact coordinates, so that tiny triangles keep their relative accuracy.
Fractions fractionsOf(const Layers& layers, const Crossing& crossing) {
  const Point2& a = layers.base.at(layers.base.from(crossing.base));
  const Point2& b = layers.base.at(layers.base.to(crossing.base));
  const Point2& right = layers.part.at(layers.part.from(crossing.part));
  const Point2& left = layers.part.at(layers.part.to(crossing.part));
  return {ratio(doubleArea(right, left, a), -doubleArea(right, left, b)),
          ratio(-doubleArea(a, b, right), doubleArea(a, b, left))};
}

// The part's vertices that lie exactly on a vertex of the base take its number. By the shift, a base vertex
// on a part vertex lies in one of the faces round it.
void findCommonVertices(const Layers& layers, const Trace& trace, VertexNumbers& numbers) {
  const Layer& part = layers.part;
  const Layer& base = layers.base;
  for (Index v = base.seamSize(); v < base.vertexCount(); ++v) {
    const Index face = trace.baseInPart[static_cast<std::size_t>(v)];
    Place& place = numbers.baseOnPart[static_cast<std::size_t>(v)];
    place = {Place::Kind::InFace, face};
    for (const Index w : part.faces[static_cast<std::size_t>(face)]) {
      if (w >= part.seamSize() && part.at(w) == base.at(v)) {
        place = {Place::Kind::OnVertex, w};
        numbers.ofPart[static_cast<std::size_t>(w)] = v;
      }
    }
  }
}

// A crossing at a vertex says that this vertex lies on the other layer's edge, if not on its vertex.
void noteOnEdge(Place& place, Index halfedge) {
  if (place.kind == Place::Kind::InFace) {
    place = {Place::Kind::OnEdge, halfedge};
  }
}

}  // namespace

VertexNumbers numberVertices(const Layers& layers, Trace& trace) {
  const Layer& part = layers.part;
  const Layer& base = layers.base;
  const Index seam = base.seamSize();
  VertexNumbers numbers;
  numbers.baseOnPart.resize(static_cast<std::size_t>(base.vertexCount()));
  numbers.partOnBase.resize(static_cast<std::size_t>(part.vertexCount()));
  numbers.ofPart.assign(static_cast<std::size_t>(part.vertexCount()), -1);
  findCommonVertices(layers, trace, numbers);
  numbers.count = base.vertexCount();
  for (Index w = 0; w < part.vertexCount(); ++w) {
    Index& number = numbers.ofPart[static_cast<std::size_t>(w)];
    Place& place = numbers.partOnBase[static_cast<std::size_t>(w)];
    if (w < seam) {
      number = w;
    } else if (number >= 0) {
      place = {Place::Kind::OnVertex, number};
    } else {
      number = numbers.count++;
      place = {Place::Kind::InFace, trace.partInBase[static_cast<std::size_t>(w)]};
    }
  }
  numbers.firstCrossing = numbers.count;
  for (Crossing& crossing : trace.crossings) {
    if (crossing.vertex < 0) {
      crossing.vertex = numbers.count++;
    } else if (crossing.vertex < base.vertexCount()) {
      noteOnEdge(numbers.baseOnPart[static_cast<std::size_t>(crossing.vertex)], crossing.part);
    } else {
      const auto w =
          static_cast<std::size_t>(crossing.vertex) - static_cast<std::size_t>(base.vertexCount() - seam);
      noteOnEdge(numbers.partOnBase[w], crossing.base);
      crossing.vertex = numbers.ofPart[w];
    }
  }
  return numbers;
}

namespace {

/// Writes the combined tile's vertices.
class VertexWriter {
 public:
  VertexWriter(const EmbeddedTile& part, const EmbeddedTile& base, const Layers& layers, const Trace& trace,
               const VertexNumbers& numbers, CombinedTile& combined)
      : layers_(layers),
        trace_(trace),
        numbers_(numbers),
        partLocations_(layers.part, part.points),
        baseLocations_(layers.base, base.points),
        combined_(combined) {
    const auto count = static_cast<std::size_t>(numbers.count);
    const auto baseCount = static_cast<std::size_t>(layers.base.vertexCount());
    const auto seam = static_cast<std::size_t>(layers.base.seamSize());
    gatherDividing();
    reserveLarge(combined.uv, count);
    reserveLarge(combined.part, count);
    reserveLarge(combined.base, count);
    combined.uv.resize(count);
    combined.onPart = TileLocations(count, baseCount - seam + dividingPart_.size());
    combined.onBase = TileLocations(
        count, static_cast<std::size_t>(numbers.firstCrossing) - baseCount + dividingBase_.size());
    combined.part.resize(count);
    combined.base.resize(count);
  }

  void writeLayers() {
    parallelRanges(static_cast<std::size_t>(layers_.base.vertexCount()), kVertexGrain,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t v = begin; v < end; ++v) {
                       writeBaseVertex(static_cast<Index>(v));
                     }
                   });
    parallelRanges(static_cast<std::size_t>(layers_.part.vertexCount()), kVertexGrain,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t w = begin; w < end; ++w) {
                       if (numbers_.ofPart[w] >= layers_.base.vertexCount()) {
                         writePartVertex(static_cast<Index>(w));
                       }
                     }
                   });
  }

  void writeCrossings() {
    const std::vector<Crossing>& crossings = trace_.crossings;
    fractions_.resize(crossings.size());
    parallelRanges(crossings.size(), kVertexGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        fractions_[c] = fractionsOf(layers_, crossings[c]);
      }
    });
    orderFractions();
    parallelRanges(crossings.size(), kVertexGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        if (crossings[c].vertex >= numbers_.firstCrossing) {
          writeCrossing(c);
        }
      }
    });
    writeDividing();
  }

 private:
  void writeBaseVertex(Index v) {
    const auto i = static_cast<std::size_t>(v);
    const Place& place = numbers_.baseOnPart[i];
    const Point2& uv = layers_.base.at(v);
    write(i, uv, v < layers_.base.seamSize() ? partLocations_.atVertex(v) : locate(partLocations_, place, uv),
          baseLocations_.atVertex(v));
  }

  void writePartVertex(Index w) {
    const auto i = static_cast<std::size_t>(numbers_.ofPart[static_cast<std::size_t>(w)]);
    const Place& place = numbers_.partOnBase[static_cast<std::size_t>(w)];
    const Point2& uv = layers_.part.at(w);
    write(i, uv, partLocations_.atVertex(w), locate(baseLocations_, place, uv));
  }

  // Which crossings lie on an edge of a layer that divides a face of its embedding, and so in that face. Such
  // an edge leaves a vertex of the seam that the other embedding brought.
  void gatherDividing() {
    const auto divides = [](const Layer& layer, Index h) {
      return layer.seam[static_cast<std::size_t>(layer.from(h))].t != 0;
    };
    const auto add = [&](std::vector<Index>& dividing, Index c) {
      if (trace_.crossings[static_cast<std::size_t>(c)].vertex >= numbers_.firstCrossing) {
        dividing.push_back(c);
      }
    };
    for (const SeamFans::Spoke& spoke : trace_.fans.spokes) {
      const Index h = spoke.halfedge;
      if (spoke.ofPart && divides(layers_.part, h)) {
        for (Index c = trace_.firstOnPart[static_cast<std::size_t>(h)]; c >= 0;
             c = trace_.afterOnPart(c, h)) {
          add(dividingPart_, c);
        }
      } else if (!spoke.ofPart && divides(layers_.base, h)) {
        for (Index c = trace_.firstOnBase[static_cast<std::size_t>(h)]; c >= 0;
             c = trace_.afterOnBase(c, h)) {
          add(dividingBase_, c);
        }
      }
    }
  }

  void writeDividing() {
    const auto at = [&](Index c) -> const Crossing& { return trace_.crossings[static_cast<std::size_t>(c)]; };
    auto slot = static_cast<std::size_t>(layers_.base.vertexCount() - layers_.base.seamSize());
    for (const Index c : dividingPart_) {
      const double t = fractions_[static_cast<std::size_t>(c)].onPart;
      combined_.onPart.set(static_cast<std::size_t>(at(c).vertex), partLocations_.onEdge(at(c).part, t),
                           slot++);
    }
    slot = static_cast<std::size_t>(numbers_.firstCrossing - layers_.base.vertexCount());
    for (const Index c : dividingBase_) {
      const double t = fractions_[static_cast<std::size_t>(c)].onBase;
      combined_.onBase.set(static_cast<std::size_t>(at(c).vertex), baseLocations_.onEdge(at(c).base, t),
                           slot++);
    }
  }

  void writeCrossing(std::size_t c) {
    const Crossing& crossing = trace_.crossings[c];
    const Fractions& fractions = fractions_[c];
    const Point2& a = layers_.base.at(layers_.base.from(crossing.base));
    const Point2& b = layers_.base.at(layers_.base.to(crossing.base));
    write(static_cast<std::size_t>(crossing.vertex), a + fractions.onBase * (b - a),
          partLocations_.onEdge(crossing.part, fractions.onPart),
          baseLocations_.onEdge(crossing.base, fractions.onBase));
  }

  // Rounding must not turn the order of the crossings of one edge round.
  void orderFractions() {
    const std::vector<Crossing>& crossings = trace_.crossings;
    for (std::size_t c = 1; c < crossings.size(); ++c) {
      if (crossings[c].base == crossings[c - 1].base) {
        fractions_[c].onBase = std::max(fractions_[c].onBase, fractions_[c - 1].onBase);
      }
    }
    for (std::size_t c = 0; c < crossings.size(); ++c) {
      const Index next = crossings[c].partNext;
      if (next >= 0 && fractionAlong(next, crossings[c].part) < fractions_[c].onPart) {
        orderPartEdge(crossings[c].part);
      }
    }
  }

  // The fraction of the part's halfedge h at which crossing c lies.
  [[nodiscard]] double fractionAlong(Index c, Index h) const {
    const double t = fractions_[static_cast<std::size_t>(c)].onPart;
    return trace_.crossings[static_cast<std::size_t>(c)].part == h ? t : 1 - t;
  }

  void orderPartEdge(Index h) {
    double reached = 0;
    for (Index c = trace_.firstOnPart[static_cast<std::size_t>(h)]; c >= 0;) {
      const Crossing& crossing = trace_.crossings[static_cast<std::size_t>(c)];
      const bool along = crossing.part == h;
      reached = std::max(reached, fractionAlong(c, h));
      fractions_[static_cast<std::size_t>(c)].onPart = along ? reached : 1 - reached;
      c = along ? crossing.partNext : crossing.partPrev;
    }
  }

  static TileLocation locate(const LayerLocations& locations, const Place& place, const Point2& uv) {
    switch (place.kind) {
      case Place::Kind::OnVertex:
        return locations.atVertex(place.index);
      case Place::Kind::OnEdge:
        return locations.onEdge(place.index, locations.fraction(place.index, uv));
      case Place::Kind::InFace:
        break;
    }
    return locations.inFace(place.index, uv);
  }

  void write(std::size_t i, const Point2& uv, const TileLocation& onPart, const TileLocation& onBase) {
    combined_.uv[i] = uv;
    place(combined_.onPart, i, onPart, static_cast<std::size_t>(layers_.base.seamSize()));
    place(combined_.onBase, i, onBase, static_cast<std::size_t>(layers_.base.vertexCount()));
    combined_.part[i] = partLocations_.position(onPart);
    combined_.base[i] = baseLocations_.position(onBase);
  }

  // A layer's own vertices in faces have the first slots; crossings in faces wait for writeDividing().
  void place(TileLocations& locations, std::size_t i, const TileLocation& location, std::size_t firstSlot) {
    if (location.kind != TileLocation::Kind::InFace || i < static_cast<std::size_t>(numbers_.firstCrossing)) {
      locations.set(i, location, i - firstSlot);
    }
  }

  const Layers& layers_;
  const Trace& trace_;
  const VertexNumbers& numbers_;
  std::vector<Index> dividingPart_;  // crossings in faces of the part's embedding; of the base's
  std::vector<Index> dividingBase_;
  const LayerLocations partLocations_;
  const LayerLocations baseLocations_;
  std::vector<Fractions> fractions_;
  CombinedTile& combined_;
};

}  // namespace

void placeVertices(const EmbeddedTile& part, const EmbeddedTile& base, const Layers& layers,
                   const Trace& trace, const VertexNumbers& numbers, CombinedTile& combined) {
  VertexWriter writer(part, base, layers, trace, numbers, combined);
  writer.writeLayers();
  writer.writeCrossings();
  combined.seamSize = layers.base.seamSize();
  combined.seamOnPart = layers.part.seam;
  combined.seamOnBase = layers.base.seam;
}

}  // namespace graftsman::overlay_detail
