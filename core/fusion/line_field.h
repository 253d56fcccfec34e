#pragma once

#include <span>
#include <vector>

#include "core/fusion/boundary_lines.h"

namespace graftsman {

/// The deformation by a field of lines (Kanai et al. 1999, §3.3, Eqs. 4–8): each point goes to the weighted
/// mean of where the lines' own maps take it, with weights (1 + d_i / l_i)^−n.
///
/// Differs: d_i is the distance to the segment between the two CVs, not to the infinite line (as in Beier &
/// Neely 1992, whom the paper follows): a vertex far along the line's extension, beside another part of the
/// loop, is no nearer to it than its end is.
class LineField {
 public:
  /// `lines`: at least one; `size`: a length of the loop's order of magnitude, > 0; `falloff`: n > 0.
  LineField(std::vector<BoundaryLine> lines, double size, double falloff);

  /// Moves the points, in the coordinates of the lines. For n = 1, 2, …, 8 the displacements are computed in
  /// single precision from differences in double: within 1e-6 of the greatest displacement that one of the
  /// lines gives the point. Otherwise in double, at many times the cost. Allocates nothing. Same bits on
  /// every machine for those n, however the points are divided into calls.
  void move(std::span<Point> points) const;

 private:
  /// A BoundaryLine in units of `size_`, as single-precision constants of the inner loop.
  struct FastLine {
    float originHigh[3];  // origin = high + low
    float originLow[3];
    float edge[3];
    float overLength2[3];  // edge / l²
    float length;
    float linear[9];  // BoundaryLine::linear − 1, by rows
    float shift[3];   // image − origin
  };

  /// Points that stay in the nearest cache while all lines pass over them.
  static constexpr std::size_t kBlock = 256;
  struct Block;
  struct Approach;

  void load(const double* coordinates, Block& block) const;
  static void approach(const FastLine& line, const Block& block, Approach& to);
  static void addLine(const FastLine& line, const Approach& from, Block& block, auto power);
  void addLines(Block& block, std::span<const Point> next) const;
  static bool isRight(const Block& block, std::size_t j);
  static bool areRight(const Block& block);
  void store(const Block& block, double* coordinates) const;
  void moveBlock(std::span<Point, kBlock> points, std::span<const Point> next) const;
  [[nodiscard]] Point moved(const Point& point) const;

  std::vector<BoundaryLine> lines_;
  std::vector<FastLine> fastLines_;
  double size_;
  double falloff_;
};

}  // namespace graftsman
