#include "core/fusion/multigrid_level.h"
#include "core/mesh/at.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace graftsman {
namespace {

using Two = Pair::Two;

/// The rows by colour, each the least that no neighbour before it has. Beyond kColours colours they repeat:
/// that costs speed, nothing else.
std::vector<Index> colourOrder(const SparseRows& a) {
  constexpr std::size_t kColours = 63;
  constexpr unsigned char kNone = 63;
  std::vector<unsigned char> colours(a.rows(), kNone);
  std::array<Index, kColours + 1> starts = {};
  for (std::size_t r = 0; r < a.rows(); ++r) {
    std::uint64_t taken = 0;
    for (auto k = at(a.offsets[r]); k < at(a.offsets[r + 1]); ++k) {
      taken |= std::uint64_t{1} << colours[at(a.columns[k])];
    }
    const auto colour = std::min(static_cast<std::size_t>(std::countr_one(taken)), kColours - 1);
    colours[r] = static_cast<unsigned char>(colour);
    ++starts[colour + 1];
  }
  for (std::size_t c = 0; c < kColours; ++c) {
    starts[c + 1] += starts[c];
  }
  std::vector<Index> order(a.rows());
  for (std::size_t r = 0; r < a.rows(); ++r) {
    order[at(starts[colours[r]]++)] = static_cast<Index>(r);
  }
  return order;
}

std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    places[at(order[i])] = static_cast<Index>(i);
  }
  return places;
}

}  // namespace

MultigridLevel::MultigridLevel(const SparseRows& a)
    : b(a.rows()), x(a.rows()), order_(colourOrder(a)), middles_(a.rows()), inverseDiagonal_(a.rows()) {
  const std::vector<Index> places = inverse(order_);
  offsets_.resize(a.rows() + 1);
  entries_.resize(a.columns.size());
  Index filled = 0;
  for (std::size_t r = 0; r < a.rows(); ++r) {
    const auto old = at(order_[r]);
    inverseDiagonal_[r] = static_cast<float>(1 / a.diagonal[old]);
    Index last = filled + a.offsets[old + 1] - a.offsets[old];
    offsets_[r + 1] = last;
    for (auto k = at(a.offsets[old]); k < at(a.offsets[old + 1]); ++k) {
      const Index column = places[at(a.columns[k])];
      entries_[at(column < static_cast<Index>(r) ? filled++ : --last)] = {column,
                                                                          static_cast<float>(a.values[k])};
    }
    middles_[r] = filled;
    filled = offsets_[r + 1];
  }
}

void MultigridLevel::connect(const Prolongation& p, const MultigridLevel& coarser) {
  const std::vector<Index> places = inverse(coarser.order());
  coarseOffsets_.assign(rows() + 1, 0);
  coarseEntries_.reserve(p.columns.size());
  for (std::size_t r = 0; r < rows(); ++r) {
    const auto old = at(order_[r]);
    for (auto k = at(p.offsets[old]); k < at(p.offsets[old + 1]); ++k) {
      coarseEntries_.push_back({places[at(p.columns[k])], static_cast<float>(p.values[k])});
    }
    coarseOffsets_[r + 1] = static_cast<Index>(coarseEntries_.size());
  }
}

/// The sum of the entries [begin, end) times x.
Two MultigridLevel::product(Index begin, Index end) const {
  Two sum = {0, 0};
  for (auto k = at(begin); k < at(end); ++k) {
    const Entry& entry = entries_[k];
    sum += entry.value * x[at(entry.column)].value;
  }
  return sum;
}

void MultigridLevel::sweepFromZero() {
  for (std::size_t r = 0; r < rows(); ++r) {
    x[r].value = inverseDiagonal_[r] * (b[r].value - product(offsets_[r], middles_[r]));
  }
}

void MultigridLevel::relax(std::size_t r) {
  x[r].value = inverseDiagonal_[r] * (b[r].value - product(offsets_[r], offsets_[r + 1]));
}

void MultigridLevel::sweepForward() {
  for (std::size_t r = 0; r < rows(); ++r) {
    relax(r);
  }
}

void MultigridLevel::sweepBackward() {
  for (std::size_t r = rows(); r-- > 0;) {
    relax(r);
  }
}

void MultigridLevel::restrictTo(std::vector<Pair>& coarse) const {
  std::fill(coarse.begin(), coarse.end(), Pair{});
  for (std::size_t r = 0; r < rows(); ++r) {
    // The sweep left a row's residual to what later rows changed afterwards: its upper half.
    const Two residual = -product(middles_[r], offsets_[r + 1]);
    for (auto k = at(coarseOffsets_[r]); k < at(coarseOffsets_[r + 1]); ++k) {
      coarse[at(coarseEntries_[k].column)].value += coarseEntries_[k].value * residual;
    }
  }
}

void MultigridLevel::addFrom(const std::vector<Pair>& coarse) {
  for (std::size_t r = 0; r < rows(); ++r) {
    Two sum = x[r].value;
    for (auto k = at(coarseOffsets_[r]); k < at(coarseOffsets_[r + 1]); ++k) {
      sum += coarseEntries_[k].value * coarse[at(coarseEntries_[k].column)].value;
    }
    x[r].value = sum;
  }
}

}  // namespace graftsman
