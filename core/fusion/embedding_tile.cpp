#include "core/fusion/embedding_tile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace graftsman {
namespace {

struct TileChord {
  std::array<Index, 2> ends;  // ascending
  Index halfedge = 0;         // 3f + k

  friend bool operator<(const TileChord& a, const TileChord& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.halfedge < b.halfedge;
  }
};

bool isBoundaryEdge(Index a, Index b, Index boundarySize) {
  return (a + 1 == boundarySize ? 0 : a + 1) == b;
}

std::vector<TileChord> findChords(std::span<const Face> faces, Index boundarySize) {
  std::vector<TileChord> chords;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = faces[f][k];
      const Index b = faces[f][(k + 1) % 3];
      if (a < boundarySize && b < boundarySize && !isBoundaryEdge(a, b, boundarySize)) {
        chords.push_back({{std::min(a, b), std::max(a, b)}, static_cast<Index>(3 * f + k)});
      }
    }
  }
  std::sort(chords.begin(), chords.end());
  return chords;
}

/// A vertex for every pair of chord halfedges; returns, sorted by halfedge, which vertex divides which.
std::vector<std::pair<Index, Index>> divideChords(std::span<const Face> faces,
                                                  const std::vector<TileChord>& chords, EmbeddingTile& tile) {
  std::vector<std::pair<Index, Index>> dividers;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const auto& [ends, halfedge] = chords[i];
    if (i == 0 || chords[i - 1].ends != ends) {
      const auto opposite = faces[static_cast<std::size_t>(halfedge / 3)][(halfedge + 2) % 3U];
      tile.added.push_back({{ends[0], ends[1], opposite}, {0.5, 0.5, 0}});
      const Point& a = tile.points[static_cast<std::size_t>(ends[0])];
      const Point& b = tile.points[static_cast<std::size_t>(ends[1])];
      tile.points.emplace_back((a + b) / 2);
    }
    dividers.emplace_back(halfedge, static_cast<Index>(tile.points.size()) - 1);
  }
  std::sort(dividers.begin(), dividers.end());
  return dividers;
}

/// Appends the pieces of a face whose edge k (from corner k) is divided by middles[k], or not if that is −1.
void appendPieces(const Face& face, const std::array<Index, 3>& middles, std::vector<Face>& out) {
  const auto count = std::count_if(middles.begin(), middles.end(), [](Index m) { return m >= 0; });
  if (count == 0) {
    out.push_back(face);
    return;
  }
  std::size_t k = 0;  // turned so that edge k is divided, and with two, edge k + 1 as well
  while (middles[k] < 0 || (count == 2 && middles[(k + 1) % 3] < 0)) {
    ++k;
  }
  const Index a = face[k];
  const Index b = face[(k + 1) % 3];
  const Index c = face[(k + 2) % 3];
  const Index ab = middles[k];
  const Index bc = middles[(k + 1) % 3];
  const Index ca = middles[(k + 2) % 3];
  if (count == 1) {
    out.insert(out.end(), {Face{a, ab, c}, Face{ab, b, c}});
  } else if (count == 2) {
    out.insert(out.end(), {Face{ab, b, bc}, Face{a, ab, bc}, Face{a, bc, c}});
  } else {
    out.insert(out.end(), {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}});
  }
}

void divideSingleTriangle(const Face& face, EmbeddingTile& tile) {
  const auto [a, b, c] = face;
  const auto point = [&](Index v) { return tile.points[static_cast<std::size_t>(v)]; };
  const auto centre = static_cast<Index>(tile.points.size());
  tile.added.push_back({face, Eigen::Vector3d::Constant(1.0 / 3)});
  tile.points.emplace_back((point(a) + point(b) + point(c)) / 3);
  tile.faces = {{a, b, centre}, {b, c, centre}, {c, a, centre}};
  tile.parents = {0, 0, 0};
}

/// The points times a power of two, so that the greatest extent is about 1 and no bit is lost.
std::vector<Point> scaled(std::span<const Point> points) {
  Point low = points.front();
  Point high = points.front();
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  int exponent = 0;
  std::frexp((high / 2 - low / 2).maxCoeff(), &exponent);
  const double scale = std::ldexp(1.0, std::clamp(-exponent - 1, -1000, 1000));
  std::vector<Point> out(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    out[i] = scale * points[i];
  }
  return out;
}

std::vector<double> areaShares(const EmbeddingTile& tile) {
  std::vector<double> areas(tile.faces.size());
  double sum = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const auto [a, b, c] = tile.faces[f];
    const Point& origin = tile.points[static_cast<std::size_t>(a)];
    const Point ab = tile.points[static_cast<std::size_t>(b)] - origin;
    const Point ac = tile.points[static_cast<std::size_t>(c)] - origin;
    areas[f] = ab.cross(ac).norm();
    sum += areas[f];
  }
  const double uniform = 1 / static_cast<double>(areas.size());
  for (double& area : areas) {
    area = sum > 0 ? area / sum : uniform;
  }
  return areas;
}

/// Turns the slots of one row so that each starts where the one before it ends.
void orderRing(const EmbeddingTile& tile, Index begin, Index end, Stars& stars) {
  const auto last = [&](Index slot) {  // the vertex at which the slot's face ends the ring's edge
    const Index h = stars.halfedges[static_cast<std::size_t>(slot)];
    return (&tile.faces[0][0])[h % 3 == 0 ? h + 2 : h - 1];
  };
  for (Index slot = begin; slot + 1 < end; ++slot) {
    const Index wanted = last(slot);
    Index found = slot + 1;
    while (found < end && stars.ring[static_cast<std::size_t>(found)] != wanted) {
      ++found;
    }
    assert(found < end && "the faces round an interior vertex form one closed fan");
    if (found == end) {
      return;
    }
    const auto next = static_cast<std::size_t>(slot) + 1;
    std::swap(stars.ring[next], stars.ring[static_cast<std::size_t>(found)]);
    std::swap(stars.halfedges[next], stars.halfedges[static_cast<std::size_t>(found)]);
  }
}

}  // namespace

EmbeddingTile prepareTile(std::span<const Point> points, std::span<const Face> faces, Index boundarySize) {
  EmbeddingTile tile;
  tile.boundarySize = boundarySize;
  tile.points = scaled(points);
  const std::vector<TileChord> chords = findChords(faces, boundarySize);
  if (faces.size() == 1) {
    divideSingleTriangle(faces[0], tile);
  } else {
    const auto dividers = divideChords(faces, chords, tile);
    tile.faces.reserve(faces.size() + dividers.size());
    tile.parents.reserve(faces.size() + dividers.size());
    auto divider = dividers.begin();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      std::array<Index, 3> middles = {-1, -1, -1};
      for (; divider != dividers.end() && divider->first / 3 == static_cast<Index>(f); ++divider) {
        middles[divider->first % 3U] = divider->second;
      }
      appendPieces(faces[f], middles, tile.faces);
      tile.parents.resize(tile.faces.size(), static_cast<Index>(f));
    }
  }
  tile.areas = areaShares(tile);
  return tile;
}

Stars gatherStars(const EmbeddingTile& tile) {
  const Index boundary = tile.boundarySize;
  const auto rows = static_cast<std::size_t>(tile.interiorCount());
  const Index* corners = &tile.faces[0][0];
  const auto cornerCount = static_cast<Index>(3 * tile.faces.size());
  Stars stars;
  stars.offsets.assign(rows + 1, 0);
  for (Index h = 0; h < cornerCount; ++h) {
    if (corners[h] >= boundary) {
      ++stars.offsets[static_cast<std::size_t>(corners[h] - boundary) + 1];
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    stars.offsets[r + 1] += stars.offsets[r];
  }
  stars.ring.resize(static_cast<std::size_t>(stars.offsets[rows]));
  stars.halfedges.resize(stars.ring.size());
  std::vector<Index> filled(stars.offsets.begin(), stars.offsets.end() - 1);
  for (Index h = 0; h < cornerCount; ++h) {
    if (corners[h] >= boundary) {
      const auto slot = static_cast<std::size_t>(filled[static_cast<std::size_t>(corners[h] - boundary)]++);
      stars.ring[slot] = corners[h % 3 == 2 ? h - 2 : h + 1];
      stars.halfedges[slot] = h;
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    orderRing(tile, stars.offsets[r], stars.offsets[r + 1], stars);
  }
  return stars;
}

}  // namespace graftsman
