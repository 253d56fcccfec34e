#include "core/fusion/tile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/fusion/divided_mesh.h"

namespace graftsman {
namespace {

constexpr std::size_t kFacesPerReport = 1 << 14;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The faces on one side of the loop, and what they amount to.
struct Region {
  explicit Region(const DividedMesh& mesh) : faces(mesh.faceCount()), interior(mesh.vertexCount()) {}

  IndexSet faces;
  Index faceCount = 0;
  bool complete = false;  // false where the flood was cancelled, or stopped by its limit of area
  bool cancelled = false;
  Index border = -1;  // the smallest vertex at an edge that is not the loop's and has nothing beyond
  // counted when complete:
  IndexSet interior;  // vertices that are not on the loop
  Index interiorCount = 0;
  Index singular = -1;  // the smallest singular vertex
  Index singularCount = 0;
};

class TileGatherer {
 public:
  TileGatherer(const TriangleMesh& mesh, const Cut& cut, Side side, const TileOptions& options,
               const Progress& progress)
      : mesh_(mesh),
        cut_(cut),
        side_(side),
        options_(options),
        progress_(progress),
        divided_(mesh, cut),
        loop_(divided_.vertexCount()),
        walls_(3 * divided_.faceCount()) {}

  Result<Tile> run() {
    if (auto error = findSides()) {
      return fail(std::move(*error));
    }
    const Region tile = flood(left_, kNoLimit, progress_.span(0, 0.6));
    if (tile.cancelled) {
      return fail(cancelled());
    }
    if (auto error = checkDisk(tile)) {
      return fail(std::move(*error));
    }
    if (side_ == Side::Base && !options_.allowLargeTile) {
      const double tileArea = area(tile);
      const Region rest = flood(right_, tileArea, progress_.span(0.6, 0.9));
      if (rest.cancelled) {
        return fail(cancelled());
      }
      const double restArea = isOtherDisk(rest) ? area(rest) : tileArea;
      if (restArea < tileArea) {
        return fail(clockwise(tileArea / (tileArea + restArea)));
      }
    }
    return build(tile);
  }

 private:
  [[nodiscard]] Error error(ErrorCode code, std::string message) const {
    return {code, std::move(message), side_};
  }
  [[nodiscard]] Error cancelled() const { return error(ErrorCode::Cancelled, "Cancelled."); }
  [[nodiscard]] std::string loopName() const { return std::string("The loop on the ") + name(side_); }

  // The faces beside the loop, and its edges as walls that no flood passes.
  std::optional<Error> findSides() {
    const std::size_t size = cut_.boundary.size();
    for (const Index v : cut_.boundary) {
      loop_.insert(v);
      if (v < mesh_.vertexCount() && mesh_.singular(v)) {
        return error(
            ErrorCode::TileNotManifold,
            loopName() + " passes vertex " + std::to_string(v) +
                ", where the mesh is not manifold. Repair the mesh there, or lead the loop past it.");
      }
    }
    for (std::size_t i = 0; i < size; ++i) {
      const Index a = cut_.boundary[i];
      const Index b = cut_.boundary[i + 1 < size ? i + 1 : 0];
      const Index ahead = divided_.halfedgeBetween(a, b);
      const Index back = divided_.halfedgeBetween(b, a);
      assert(ahead >= 0 || back >= 0);
      if (ahead < 0) {
        return nothingLeft(static_cast<Index>(i));
      }
      walls_.insert(ahead);
      left_.push_back(ahead / 3);
      if (back >= 0) {
        walls_.insert(back);
        right_.push_back(back / 3);
      }
    }
    return {};
  }

  [[nodiscard]] Error nothingLeft(Index boundaryEdge) const {
    const auto after = std::upper_bound(cut_.corners.begin(), cut_.corners.end(), boundaryEdge);
    const int path = static_cast<int>(after - cut_.corners.begin()) - 1;
    const int next = (path + 1) % static_cast<int>(cut_.corners.size());
    Error e = error(ErrorCode::TileEmpty,
                    loopName() + " runs along the border of the mesh between CV " + std::to_string(path) +
                        " and CV " + std::to_string(next) +
                        " and has nothing on its left there: it was probably picked clockwise. Reverse it.");
    e.cvs = {path, next};
    e.paths = {path};
    return e;
  }

  // Gathers what is reached from the seeds without crossing the loop; gives up at more than `limit` of area.
  [[nodiscard]] Region flood(const std::vector<Index>& seeds, double limit, const Progress& progress) const {
    Region region(divided_);
    std::vector<Index> open;
    double reached = 0;
    const auto reach = [&](Index f) {
      if (region.faces.insert(f)) {
        open.push_back(f);
        ++region.faceCount;
        if (limit < kNoLimit) {
          reached += area(f);
        }
      }
    };
    std::for_each(seeds.begin(), seeds.end(), reach);
    for (std::size_t done = 0; !open.empty(); ++done) {
      if (done % kFacesPerReport == 0 &&
          !progress.keepGoing(static_cast<double>(done) / divided_.faceCount())) {
        region.cancelled = true;
        return region;
      }
      if (reached > limit) {
        return region;
      }
      const Index f = open.back();
      open.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (walls_.contains(h)) {
          continue;
        }
        if (const Index t = divided_.twin(h); t >= 0) {
          reach(t / 3);
        } else {
          noteSmallest(region.border, std::min(meshVertex(divided_.from(h)), meshVertex(divided_.to(h))));
        }
      }
    }
    region.complete = true;
    countVertices(region);
    return region;
  }

  // A number that a person can look up: of a new point, an end of its edge.
  [[nodiscard]] Index meshVertex(Index v) const {
    const Index point = v - mesh_.vertexCount();
    return point < 0 ? v : mesh_.from(cut_.where[static_cast<std::size_t>(point)].halfedge);
  }

  void countVertices(Region& region) const {
    region.faces.forEach([&](Index f) {
      for (const Index v : divided_.face(f)) {
        if (loop_.contains(v) || !region.interior.insert(v)) {
          continue;
        }
        ++region.interiorCount;
        if (v < mesh_.vertexCount() && mesh_.singular(v)) {
          ++region.singularCount;
          noteSmallest(region.singular, v);
        }
      }
    });
  }

  static void noteSmallest(Index& smallest, Index v) { smallest = smallest < 0 ? v : std::min(smallest, v); }

  [[nodiscard]] double area(Index f) const {
    const auto& [a, b, c] = divided_.face(f);
    const Point& p = divided_.point(a);
    return (divided_.point(b) - p).cross(divided_.point(c) - p).norm() / 2;
  }

  [[nodiscard]] double area(const Region& region) const {
    double sum = 0;
    region.faces.forEach([&](Index f) { sum += area(f); });
    return sum;
  }

  // The Euler characteristic is 1 − 2 handles for a manifold region whose only border is the loop of B edges:
  // V = B + interior, 2 E = 3 F + B.
  [[nodiscard]] Index handles(const Region& region) const {
    const auto b = static_cast<Index>(cut_.boundary.size());
    const Index twiceEuler = 2 * region.interiorCount + b - region.faceCount;
    return (2 - twiceEuler) / 4;
  }

  // Whether the region right of the loop would be a tile of the reversed loop.
  [[nodiscard]] bool isOtherDisk(const Region& rest) const {
    return right_.size() == cut_.boundary.size() && rest.complete && rest.border < 0 && rest.singular < 0 &&
           handles(rest) == 0;
  }

  [[nodiscard]] std::optional<Error> checkDisk(const Region& tile) const {
    const auto reached = [&](Index f) { return tile.faces.contains(f); };
    if (std::any_of(right_.begin(), right_.end(), reached)) {
      return error(ErrorCode::TileNotSeparated,
                   loopName() +
                       " does not divide the surface: it runs round a handle, so that its right side is "
                       "reached from its left. Let it run round the region that is meant.");
    }
    if (tile.singular >= 0) {
      const Index others = tile.singularCount - 1;
      return error(ErrorCode::TileNotManifold,
                   loopName() + " encloses vertex " + std::to_string(tile.singular) +
                       (others > 0 ? " and " + std::to_string(others) + " more" : "") +
                       ", where the mesh is not manifold. " +
                       remedy("Repair the mesh there, or lead the loop past it."));
    }
    if (tile.border >= 0) {
      return error(ErrorCode::TileHasHole, loopName() +
                                               " encloses a hole of the mesh: its border passes vertex " +
                                               std::to_string(tile.border) + ". " +
                                               remedy("Close the hole, or lead the loop past it."));
    }
    if (const Index count = handles(tile); count != 0) {
      return error(ErrorCode::TileHasHandle,
                   loopName() + " encloses " +
                       (count == 1 ? "a handle" : std::to_string(count) + " handles") +
                       ", and a tile must be a disk. " + remedy("Lead the loop so that it leaves them out."));
    }
    return {};
  }

  // What to do about a region that is no tile: if the other side is one, the loop runs the wrong way round.
  [[nodiscard]] std::string remedy(const std::string& otherwise) const {
    if (isOtherDisk(flood(right_, kNoLimit, progress_.span(0.6, 0.9)))) {
      return "The other side has no such fault: the loop was probably picked clockwise. Reverse it.";
    }
    return otherwise;
  }

  [[nodiscard]] Error clockwise(double fraction) const {
    const double tenths = std::min(std::floor(1000 * fraction), 999.0);  // never shows 100 %
    std::string percent = std::to_string(static_cast<int>(tenths) / 10);
    if (tenths >= 990) {
      percent += "." + std::to_string(static_cast<int>(tenths) % 10);
    }
    return error(ErrorCode::TileClockwise,
                 loopName() + " encloses " + percent +
                     " % of a closed mesh: it was probably picked clockwise. Reverse it, or allow a "
                     "large tile.");
  }

  [[nodiscard]] Tile build(const Region& region) const {
    Tile tile;
    tile.boundarySize = static_cast<Index>(cut_.boundary.size());
    tile.corners = cut_.corners;
    tile.vertices.reserve(cut_.boundary.size() + static_cast<std::size_t>(region.interiorCount));
    tile.vertices = cut_.boundary;
    region.interior.forEach([&](Index v) { tile.vertices.push_back(v); });
    // Only entries of the tile's vertices are ever written or read.
    const auto local =
        std::make_unique_for_overwrite<Index[]>(static_cast<std::size_t>(divided_.vertexCount()));
    tile.points.reserve(tile.vertices.size());
    for (const Index v : tile.vertices) {
      local[static_cast<std::size_t>(v)] = static_cast<Index>(tile.points.size());
      tile.points.push_back(divided_.point(v));
    }
    tile.faces.reserve(static_cast<std::size_t>(region.faceCount));
    region.faces.forEach([&](Index f) {
      const auto& [a, b, c] = divided_.face(f);
      tile.faces.push_back({local[static_cast<std::size_t>(a)], local[static_cast<std::size_t>(b)],
                            local[static_cast<std::size_t>(c)]});
      if (f < mesh_.faceCount()) {
        tile.wholeFaces.push_back(f);
      } else {
        tile.pieces.push_back(f - mesh_.faceCount());
      }
    });
    return tile;
  }

  const TriangleMesh& mesh_;
  const Cut& cut_;
  const Side side_;
  const TileOptions& options_;
  const Progress& progress_;
  const DividedMesh divided_;
  IndexSet loop_;             // the loop's vertices
  IndexSet walls_;            // halfedges along the loop, on both sides
  std::vector<Index> left_;   // the face left of each boundary edge
  std::vector<Index> right_;  // those right of it, where there is one
};

}  // namespace

Result<Tile> gatherTile(const TriangleMesh& mesh, const Cut& cut, Side side, const TileOptions& options,
                        const Progress& progress) {
  return TileGatherer(mesh, cut, side, options, progress).run();
}

}  // namespace graftsman
