#include "core/fusion/cell_triangulation.h"

#include <Eigen/Core>
#include <array>
#include <cassert>

namespace graftsman::overlay_detail {
namespace {

// Shapes worse than this are not told apart, as squared lengths do not hold more; keeps the cost of a flat
// triangle finite.
constexpr double kWorstShape = 1e-12;

/// A number of the part's surface, and one of the base's: they go through the arithmetic together.
using Both = Eigen::Array2d;

/// A cell's corners, and their squared distances on both surfaces, from which the triangles' shapes follow.
class Cell {
 public:
  Cell(std::span<const Index> corners, std::span<const Point> part, std::span<const Point> base)
      : corners_(corners) {
    for (std::size_t j = 1; j < corners.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        const auto a = static_cast<std::size_t>(corners[i]);
        const auto b = static_cast<std::size_t>(corners[j]);
        const Both x(part[b].x() - part[a].x(), base[b].x() - base[a].x());
        const Both y(part[b].y() - part[a].y(), base[b].y() - base[a].y());
        const Both z(part[b].z() - part[a].z(), base[b].z() - base[a].z());
        squared_[i][j] = x * x + y * y + z * z;
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] Face face(std::size_t i, std::size_t j, std::size_t k) const {
    return {corners_[i], corners_[j], corners_[k]};
  }

  // Of a triangle i < j < k, 1 / shape on both surfaces together, where the shape is 1 for an equilateral
  // triangle, 0 for a flat one, of any size.
  [[nodiscard]] double cost(std::size_t i, std::size_t j, std::size_t k) const {
    const Both& a = squared_[i][j];
    const Both& b = squared_[j][k];
    const Both& c = squared_[i][k];
    const Both lengths = a + b + c;
    const Both worst = lengths * lengths;
    const Both flat = a + b - c;
    const Both area = (4 * a * b - flat * flat).max(0);  // (4 · area)², by Heron
    const Both badness = worst / (3 * area + kWorstShape * worst);
    return (worst[0] > 0 ? badness[0] : 1 / kWorstShape) + (worst[1] > 0 ? badness[1] : 1 / kWorstShape);
  }

 private:
  std::span<const Index> corners_;
  std::array<std::array<Both, kMostCorners>, kMostCorners> squared_;  // [i][j] for i < j
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
  const std::size_t n = cell.size();
  std::array<std::array<double, kMostCorners>, kMostCorners> best;
  std::array<std::array<std::size_t, kMostCorners>, kMostCorners> middle;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    best[i][i + 1] = 0;
  }
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
  const Cell cell(corners, part, base);
  if (corners.size() == 4) {
    triangulateQuad(cell, out);
  } else {
    triangulateByTable(cell, out);
  }
}

}  // namespace graftsman::overlay_detail
