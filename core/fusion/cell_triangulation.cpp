#include "core/fusion/cell_triangulation.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace graftsman::overlay_detail {
namespace {

// Shapes worse than this are not told apart, as squared lengths do not hold more; keeps the cost of a flat
// triangle finite.
constexpr double kWorstShape = 1e-12;

/// A cell's corners on one surface: their squared distances, from which the triangles' shapes follow.
class Corners {
 public:
  Corners(std::span<const Index> corners, std::span<const Point> points) {
    for (std::size_t j = 1; j < corners.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        squared_[i][j] =
            (points[static_cast<std::size_t>(corners[j])] - points[static_cast<std::size_t>(corners[i])])
                .squaredNorm();
      }
    }
  }

  // 1 / shape for i < j < k, where the shape is 1 for an equilateral triangle, 0 for a flat one, of any size.
  [[nodiscard]] double badness(std::size_t i, std::size_t j, std::size_t k) const {
    const double a = squared_[i][j];
    const double b = squared_[j][k];
    const double c = squared_[i][k];
    const double lengths = a + b + c;
    const double worst = lengths * lengths;
    const double flat = a + b - c;
    const double area = std::max(0.0, 4 * a * b - flat * flat);  // (4 · area)², by Heron
    return worst > 0 ? worst / (3 * area + kWorstShape * worst) : 1 / kWorstShape;
  }

 private:
  std::array<std::array<double, kMostCorners>, kMostCorners> squared_;  // [i][j] for i < j
};

/// The corners on both surfaces.
struct Cell {
  std::span<const Index> corners;
  Corners part;
  Corners base;

  [[nodiscard]] double cost(std::size_t i, std::size_t j, std::size_t k) const {
    return part.badness(i, j, k) + base.badness(i, j, k);
  }
  [[nodiscard]] Face face(std::size_t i, std::size_t j, std::size_t k) const {
    return {corners[i], corners[j], corners[k]};
  }
};

void triangulateQuad(const Cell& cell, std::vector<Face>& out) {
  if (cell.cost(0, 1, 2) + cell.cost(0, 2, 3) <= cell.cost(0, 1, 3) + cell.cost(1, 2, 3)) {
    out.push_back(cell.face(0, 1, 2));
    out.push_back(cell.face(0, 2, 3));
  } else {
    out.push_back(cell.face(0, 1, 3));
    out.push_back(cell.face(1, 2, 3));
  }
}

// The least total cost by dynamic programming over the chords i–j that cut off corners i … j.
void triangulateByTable(const Cell& cell, std::vector<Face>& out) {
  const std::size_t n = cell.corners.size();
  std::array<std::array<double, kMostCorners>, kMostCorners> best = {};
  std::array<std::array<std::size_t, kMostCorners>, kMostCorners> middle;
  for (std::size_t length = 2; length < n; ++length) {
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double cost = best[i][k] + best[k][j] + cell.cost(i, k, j);
        if (k == i + 1 || cost < best[i][j]) {
          best[i][j] = cost;
          middle[i][j] = k;
        }
      }
    }
  }
  std::array<std::array<std::size_t, 2>, kMostCorners> open = {{{0, n - 1}}};
  for (std::size_t size = 1; size > 0;) {
    const auto [i, j] = open[--size];
    const std::size_t k = middle[i][j];
    out.push_back(cell.face(i, k, j));
    if (k - i > 1) {
      open[size++] = {i, k};
    }
    if (j - k > 1) {
      open[size++] = {k, j};
    }
  }
}

}  // namespace

void triangulateCell(std::span<const Index> corners, std::span<const Point> part, std::span<const Point> base,
                     std::vector<Face>& out) {
  assert(corners.size() >= 3 && corners.size() <= kMostCorners);
  if (corners.size() == 3) {
    out.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const Cell cell{corners, {corners, part}, {corners, base}};
  if (corners.size() == 4) {
    triangulateQuad(cell, out);
  } else {
    triangulateByTable(cell, out);
  }
}

}  // namespace graftsman::overlay_detail
