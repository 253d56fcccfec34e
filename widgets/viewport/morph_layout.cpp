#include "widgets/viewport/morph_layout.h"

#include <algorithm>
#include <cstdint>

namespace graftsman {
namespace {

// What a vertex of the join is; of two that apply the later one.
enum class Kind : std::uint8_t { Unused, Far, Ring, Seam };

bool touchesSeam(const Face& face, const std::vector<Kind>& kinds) {
  bool touches = false;
  for (const Index v : face) {
    touches |= kinds[static_cast<std::size_t>(v)] == Kind::Seam;
  }
  return touches;
}

std::vector<Kind> kindsOf(const Join& join, const CombinedTile& combined) {
  std::vector<Kind> kinds(join.points.size(), Kind::Unused);
  for (std::size_t k = 0; k < static_cast<std::size_t>(combined.seamSize); ++k) {
    kinds[static_cast<std::size_t>(join.tileVertices[k])] = Kind::Seam;
  }
  for (Index f = 0; f < join.restFaces; ++f) {
    const Face& face = join.faces[static_cast<std::size_t>(f)];
    const Kind here = touchesSeam(face, kinds) ? Kind::Ring : Kind::Far;
    for (const Index v : face) {
      Kind& kind = kinds[static_cast<std::size_t>(v)];
      kind = std::max(kind, here);
    }
  }
  return kinds;
}

}  // namespace

MorphLayout layOut(const Join& join, const CombinedTile& combined) {
  MorphLayout layout;
  layout.seamSize = combined.seamSize;
  layout.tileSize = static_cast<Index>(combined.s.size());

  const std::vector<Kind> kinds = kindsOf(join, combined);
  std::vector<Index> numbers(join.points.size(), -1);
  layout.restVertices.reserve(join.points.size());
  for (const Kind wanted : {Kind::Far, Kind::Ring}) {
    for (std::size_t v = 0; v < kinds.size(); ++v) {
      if (kinds[v] == wanted) {
        numbers[v] = static_cast<Index>(layout.restVertices.size());
        layout.restVertices.push_back(static_cast<Index>(v));
      }
    }
    if (wanted == Kind::Far) {
      layout.farCount = static_cast<Index>(layout.restVertices.size());
    }
  }
  layout.ringCount = static_cast<Index>(layout.restVertices.size()) - layout.farCount;
  for (Index k = 0; k < layout.seamSize; ++k) {
    numbers[static_cast<std::size_t>(join.tileVertices[static_cast<std::size_t>(k)])] =
        layout.seamCopiesBegin() + k;
  }

  layout.restFaces.reserve(static_cast<std::size_t>(join.restFaces));
  for (Index f = 0; f < join.restFaces; ++f) {
    const Face& face = join.faces[static_cast<std::size_t>(f)];
    const bool rim = touchesSeam(face, kinds);
    const Index first = rim ? layout.ringBegin() : 0;
    Face moved;
    for (std::size_t k = 0; k < 3; ++k) {
      moved[k] = numbers[static_cast<std::size_t>(face[k])] - first;
    }
    (rim ? layout.rimFaces : layout.restFaces).push_back(moved);
  }
  return layout;
}

std::vector<SeamEdge> findSeamEdges(const MorphLayout& layout, const CombinedTile& combined) {
  const Index size = layout.seamSize;
  std::vector<SeamEdge> edges(static_cast<std::size_t>(size));
  const auto after = [size](Index k) { return k + 1 == size ? 0 : k + 1; };
  for (std::size_t f = 0; f < combined.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = combined.faces[f][k];
      if (from < size && combined.faces[f][(k + 1) % 3] == after(from)) {
        edges[static_cast<std::size_t>(from)].tileFace = static_cast<Index>(f);
      }
    }
  }
  for (std::size_t f = 0; f < layout.rimFaces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = layout.rimFaces[f][k] - layout.ringCount;
      const Index to = layout.rimFaces[f][(k + 1) % 3] - layout.ringCount;
      if (from >= 0 && to >= 0 && from == after(to)) {
        edges[static_cast<std::size_t>(to)].rimFace = static_cast<Index>(f);
      }
    }
  }
  return edges;
}

}  // namespace graftsman
