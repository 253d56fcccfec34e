#include "core/fusion/embedding_mend.h"

#include <algorithm>

#include "core/fusion/embedding_check.h"

namespace graftsman {
namespace {

/// Bad faces that count as few: more mean that the weights were wrong, not a place here and there.
constexpr std::size_t kFewFaces = 16;
constexpr std::size_t kFewPerMille = 5;

/// Rounds over the bad faces. Every third widens the neighbourhood that may move by one ring.
constexpr int kRounds = 18;
constexpr int kRoundsPerRing = 3;

using Polygon = std::vector<Point2>;

/// The part of a convex polygon to the left of a → b.
Polygon clipped(const Polygon& polygon, const Point2& a, const Point2& b) {
  const auto height = [&](const Point2& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  };
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    const double hp = height(p);
    const double hq = height(q);
    if (hp >= 0) {
      out.push_back(p);
    }
    if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) {
      out.emplace_back(p + hp / (hp - hq) * (q - p));
    }
  }
  return out;
}

Point2 mean(const Polygon& polygon) {
  Point2 sum = Point2::Zero();
  for (const Point2& p : polygon) {
    sum += p;
  }
  return sum / static_cast<double>(polygon.size());
}

Index badFacesRound(const EmbeddingTile& tile, const Stars& stars, std::size_t row,
                    const std::vector<Point2>& uv) {
  Index count = 0;
  for (Index slot = stars.offsets[row]; slot < stars.offsets[row + 1]; ++slot) {
    count += !isGoodFace(tile, uv, stars.halfedges[static_cast<std::size_t>(slot)] / 3);
  }
  return count;
}

/// Moves the row's vertex if some face round it is bad and fewer are afterwards, or as many where the star
/// has no kernel yet: a later move of a neighbour may then find one.
void improve(const EmbeddingTile& tile, const Stars& stars, std::size_t row, std::vector<Point2>& uv) {
  const Index before = badFacesRound(tile, stars, row, uv);
  if (before == 0) {
    return;
  }
  Polygon ring;
  for (Index slot = stars.offsets[row]; slot < stars.offsets[row + 1]; ++slot) {
    ring.push_back(uv[static_cast<std::size_t>(stars.ring[static_cast<std::size_t>(slot)])]);
  }
  Point2 low = ring[0];
  Point2 high = ring[0];
  for (const Point2& p : ring) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Polygon kernel = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (std::size_t i = 0; i < ring.size() && !kernel.empty(); ++i) {
    kernel = clipped(kernel, ring[i], ring[(i + 1) % ring.size()]);
  }
  Point2& position = uv[row + static_cast<std::size_t>(tile.boundarySize)];
  const Point2 old = position;
  position = mean(kernel.empty() ? ring : kernel);
  const Index after = badFacesRound(tile, stars, row, uv);
  if (after > before || (after == before && !kernel.empty())) {
    position = old;
  }
}

/// The interior vertices of the faces and `rings` rings round them, as rows, ascending.
std::vector<std::size_t> rowsNear(const EmbeddingTile& tile, const Stars& stars,
                                  const std::vector<Index>& faces, int rings) {
  std::vector<std::size_t> rows;
  const auto add = [&](Index v) {
    if (v >= tile.boundarySize) {
      rows.push_back(static_cast<std::size_t>(v - tile.boundarySize));
    }
  };
  for (const Index f : faces) {
    for (const Index v : tile.faces[static_cast<std::size_t>(f)]) {
      add(v);
    }
  }
  for (int i = 0;; ++i) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (i == rings) {
      return rows;
    }
    const std::size_t known = rows.size();
    for (std::size_t r = 0; r < known; ++r) {
      for (Index slot = stars.offsets[rows[r]]; slot < stars.offsets[rows[r] + 1]; ++slot) {
        add(stars.ring[static_cast<std::size_t>(slot)]);
      }
    }
  }
}

/// The bad ones among the faces round the rows, ascending.
std::vector<Index> badFacesNear(const EmbeddingTile& tile, const Stars& stars,
                                const std::vector<std::size_t>& rows, const std::vector<Point2>& uv) {
  std::vector<Index> bad;
  for (const std::size_t row : rows) {
    for (Index slot = stars.offsets[row]; slot < stars.offsets[row + 1]; ++slot) {
      const Index face = stars.halfedges[static_cast<std::size_t>(slot)] / 3;
      if (!isGoodFace(tile, uv, face)) {
        bad.push_back(face);
      }
    }
  }
  std::sort(bad.begin(), bad.end());
  bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
  return bad;
}

}  // namespace

bool mendLayout(const EmbeddingTile& tile, const Stars& stars, const std::vector<Index>& badFaces,
                std::vector<Point2>& uv) {
  if (badFaces.size() > kFewFaces + kFewPerMille * tile.faces.size() / 1000) {
    return false;
  }
  const std::vector<Point2> original = uv;
  std::vector<Index> bad = badFaces;
  for (int round = 0; round < kRounds && !bad.empty(); ++round) {
    const std::vector<std::size_t> rows = rowsNear(tile, stars, bad, round / kRoundsPerRing);
    for (const std::size_t row : rows) {
      improve(tile, stars, row, uv);
    }
    bad = badFacesNear(tile, stars, rows, uv);
  }
  if (!bad.empty()) {
    uv = original;
  }
  return bad.empty();
}

}  // namespace graftsman
