#pragma once

#include <vector>

#include "core/fusion/aggregation.h"

namespace graftsman {

/// The unknowns for u and v, side by side in one register.
struct Pair {
  using Two [[gnu::vector_size(8)]] = float;
  Two value = {0, 0};
};

/// One level of a Multigrid, in single precision. Its rows are sorted by colour, no two rows of one colour
/// being neighbours: Gauss–Seidel then finds them independent, and the processor works on several at once.
class MultigridLevel {
 public:
  explicit MultigridLevel(const SparseRows& a);

  /// Connects the level with the next coarser one. p: from that level's unknowns to this one's, both in the
  /// order of their SparseRows.
  void connect(const Prolongation& p, const MultigridLevel& coarser);

  [[nodiscard]] std::size_t rows() const { return x.size(); }

  /// Which row of the SparseRows each row is.
  [[nodiscard]] const std::vector<Index>& order() const { return order_; }

  /// One forward sweep from x = 0.
  void sweepFromZero();
  void sweepForward();
  void sweepBackward();

  /// Restricts the residual after sweepFromZero().
  void restrictTo(std::vector<Pair>& coarse) const;
  void addFrom(const std::vector<Pair>& coarse);

  std::vector<Pair> b, x;  // right-hand sides and solution

 private:
  struct Entry {
    Index column;
    float value;
  };
  [[nodiscard]] Pair::Two product(Index begin, Index end) const;
  void relax(std::size_t r);

  std::vector<Index> order_;
  std::vector<Index> offsets_;
  std::vector<Index> middles_;  // from here to the end of a row, columns beyond the row's number
  std::vector<Entry> entries_;
  std::vector<float> inverseDiagonal_;
  std::vector<Index> coarseOffsets_;
  std::vector<Entry> coarseEntries_;
};

}  // namespace graftsman
