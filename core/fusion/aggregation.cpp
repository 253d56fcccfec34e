#include "core/fusion/aggregation.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace graftsman {
namespace {

/// A connection is strong if its weight is at least this share of its row's greatest one. Weak ones do not
/// carry smooth errors across, and keeping them only fills the coarse levels.
constexpr double kStrong = 0.12;

/// Damping of the Jacobi step: 4/3 over the bound 2 of the spectrum of D⁻¹A.
constexpr double kDamping = 2.0 / 3;

/// Per matrix entry, whether it is strong; a positive off-diagonal entry never is.
std::vector<char> findStrong(const SparseRows& a) {
  std::vector<char> strong(a.columns.size());
  for (std::size_t r = 0; r < a.rows(); ++r) {
    const auto begin = static_cast<std::size_t>(a.offsets[r]);
    const auto end = static_cast<std::size_t>(a.offsets[r + 1]);
    double least = 0;
    for (std::size_t k = begin; k < end; ++k) {
      least = std::min(least, a.values[k]);
    }
    for (std::size_t k = begin; k < end; ++k) {
      strong[k] = a.values[k] < 0 && a.values[k] <= kStrong * least;
    }
  }
  return strong;
}

/// The group of each unknown. First every unknown whose strong neighbours are all free becomes a group with
/// them, then each other one joins the group it hangs on most; an unknown without strong neighbours stays
/// alone.
std::vector<Index> group(const SparseRows& a, const std::vector<char>& strong, Index& count) {
  constexpr Index kNone = -1;
  const auto rows = static_cast<Index>(a.rows());
  std::vector<Index> groups(a.rows(), kNone);
  count = 0;
  const auto begin = [&](Index r) {
    return static_cast<std::size_t>(a.offsets[static_cast<std::size_t>(r)]);
  };
  for (Index r = 0; r < rows; ++r) {
    bool isFree = groups[static_cast<std::size_t>(r)] == kNone;
    for (std::size_t k = begin(r); isFree && k < begin(r + 1); ++k) {
      isFree = !strong[k] || groups[static_cast<std::size_t>(a.columns[k])] == kNone;
    }
    if (!isFree) {
      continue;
    }
    groups[static_cast<std::size_t>(r)] = count;
    for (std::size_t k = begin(r); k < begin(r + 1); ++k) {
      if (strong[k]) {
        groups[static_cast<std::size_t>(a.columns[k])] = count;
      }
    }
    ++count;
  }
  const std::vector<Index> seeds = groups;
  for (Index r = 0; r < rows; ++r) {
    if (seeds[static_cast<std::size_t>(r)] != kNone) {
      continue;
    }
    double strongest = 0;
    for (std::size_t k = begin(r); k < begin(r + 1); ++k) {
      const Index other = seeds[static_cast<std::size_t>(a.columns[k])];
      if (strong[k] && other != kNone && a.values[k] < strongest) {
        strongest = a.values[k];
        groups[static_cast<std::size_t>(r)] = other;
      }
    }
    if (groups[static_cast<std::size_t>(r)] == kNone) {
      groups[static_cast<std::size_t>(r)] = count++;
    }
  }
  return groups;
}

/// Adds up the rows of a sparse product, one after the other.
class Rows {
 public:
  explicit Rows(Index columnCount) : places_(static_cast<std::size_t>(columnCount), -1) {}

  /// Begins a row to which add() will be called at most `most` times.
  void begin(std::size_t most) {
    start_ = filled_;
    if (columns_.size() < filled_ + most) {
      columns_.resize(std::max(2 * columns_.size(), filled_ + most));
      values_.resize(columns_.size());
    }
  }

  void add(Index column, double value) {
    std::ptrdiff_t& place = places_[static_cast<std::size_t>(column)];
    if (place < static_cast<std::ptrdiff_t>(start_)) {
      place = static_cast<std::ptrdiff_t>(filled_);
      columns_[filled_] = column;
      values_[filled_] = value;
      ++filled_;
    } else {
      values_[static_cast<std::size_t>(place)] += value;
    }
  }

  /// Takes the column out of the row and returns its value; 0 if it has none.
  double take(Index column) {
    const std::ptrdiff_t place = std::exchange(places_[static_cast<std::size_t>(column)], -1);
    if (place < static_cast<std::ptrdiff_t>(start_)) {
      return 0;
    }
    const double value = values_[static_cast<std::size_t>(place)];
    --filled_;
    if (place != static_cast<std::ptrdiff_t>(filled_)) {  // the last entry fills the gap
      columns_[static_cast<std::size_t>(place)] = columns_[filled_];
      values_[static_cast<std::size_t>(place)] = values_[filled_];
      places_[static_cast<std::size_t>(columns_[filled_])] = place;
    }
    return value;
  }

  [[nodiscard]] Index filled() const { return static_cast<Index>(filled_); }

  void moveTo(std::vector<Index>& columns, std::vector<double>& values) {
    columns_.resize(filled_);
    values_.resize(filled_);
    columns = std::move(columns_);
    values = std::move(values_);
  }

 private:
  std::vector<std::ptrdiff_t> places_;  // of each column's latest entry
  std::vector<Index> columns_;
  std::vector<double> values_;
  std::size_t start_ = 0;
  std::size_t filled_ = 0;
};

/// A P, in the shape of a Prolongation.
Prolongation product(const SparseRows& a, const Prolongation& p) {
  Prolongation out;
  out.coarseCount = p.coarseCount;
  out.offsets.reserve(a.rows() + 1);
  out.offsets.push_back(0);
  const auto begin = [&](Index r) {
    return static_cast<std::size_t>(p.offsets[static_cast<std::size_t>(r)]);
  };
  Rows rows(p.coarseCount);
  for (std::size_t r = 0; r < a.rows(); ++r) {
    const auto first = static_cast<std::size_t>(a.offsets[r]);
    const auto last = static_cast<std::size_t>(a.offsets[r + 1]);
    const auto own = static_cast<Index>(r);
    std::size_t most = begin(own + 1) - begin(own);
    for (std::size_t k = first; k < last; ++k) {
      most += begin(a.columns[k] + 1) - begin(a.columns[k]);
    }
    rows.begin(most);
    for (std::size_t m = begin(own); m < begin(own + 1); ++m) {
      rows.add(p.columns[m], a.diagonal[r] * p.values[m]);
    }
    for (std::size_t k = first; k < last; ++k) {
      for (std::size_t m = begin(a.columns[k]); m < begin(a.columns[k] + 1); ++m) {
        rows.add(p.columns[m], a.values[k] * p.values[m]);
      }
    }
    out.offsets.push_back(rows.filled());
  }
  rows.moveTo(out.columns, out.values);
  return out;
}

/// Pᵀ, with the numbers of the fine rows as columns.
Prolongation transposed(const Prolongation& p) {
  Prolongation out;
  out.offsets.assign(static_cast<std::size_t>(p.coarseCount) + 1, 0);
  for (const Index column : p.columns) {
    ++out.offsets[static_cast<std::size_t>(column) + 1];
  }
  for (std::size_t c = 1; c < out.offsets.size(); ++c) {
    out.offsets[c] += out.offsets[c - 1];
  }
  std::vector<Index> filled(out.offsets.begin(), out.offsets.end() - 1);
  out.columns.resize(p.columns.size());
  out.values.resize(p.columns.size());
  for (std::size_t r = 0; r + 1 < p.offsets.size(); ++r) {
    for (auto k = static_cast<std::size_t>(p.offsets[r]); k < static_cast<std::size_t>(p.offsets[r + 1]);
         ++k) {
      const auto place = static_cast<std::size_t>(filled[static_cast<std::size_t>(p.columns[k])]++);
      out.columns[place] = static_cast<Index>(r);
      out.values[place] = p.values[k];
    }
  }
  return out;
}

}  // namespace

Prolongation aggregate(const SparseRows& a, Interpolation interpolation) {
  const std::vector<char> strong = findStrong(a);
  Prolongation p;
  const std::vector<Index> groups = group(a, strong, p.coarseCount);
  if (interpolation == Interpolation::Constant) {
    p.offsets.resize(a.rows() + 1);
    std::iota(p.offsets.begin(), p.offsets.end(), 0);
    p.columns = groups;
    p.values.assign(a.rows(), 1);
    return p;
  }
  p.offsets.reserve(a.rows() + 1);
  p.offsets.push_back(0);
  p.columns.reserve(3 * a.rows());
  p.values.reserve(3 * a.rows());
  for (std::size_t r = 0; r < a.rows(); ++r) {
    const auto begin = static_cast<std::size_t>(a.offsets[r]);
    const auto end = static_cast<std::size_t>(a.offsets[r + 1]);
    double strongSum = 0;
    double filtered = a.diagonal[r];
    for (std::size_t k = begin; k < end; ++k) {
      (strong[k] ? strongSum : filtered) += strong[k] ? -a.values[k] : a.values[k];
    }
    filtered = std::max(filtered, strongSum);
    const auto start = static_cast<std::size_t>(p.offsets.back());
    p.columns.push_back(groups[r]);
    p.values.push_back(1 - kDamping);
    for (std::size_t k = begin; k < end && strongSum > 0; ++k) {
      if (!strong[k]) {
        continue;
      }
      const Index column = groups[static_cast<std::size_t>(a.columns[k])];
      std::size_t place = start;
      while (place < p.columns.size() && p.columns[place] != column) {
        ++place;
      }
      if (place == p.columns.size()) {
        p.columns.push_back(column);
        p.values.push_back(0);
      }
      p.values[place] -= kDamping * a.values[k] / filtered;
    }
    p.offsets.push_back(static_cast<Index>(p.columns.size()));
  }
  return p;
}

SparseRows coarseMatrix(const SparseRows& a, const Prolongation& p) {
  const Prolongation ap = product(a, p);
  const Prolongation pt = transposed(p);
  SparseRows out;
  out.offsets.reserve(pt.offsets.size());
  out.offsets.push_back(0);
  out.diagonal.reserve(pt.offsets.size() - 1);
  const auto begin = [&](Index fine) {
    return static_cast<std::size_t>(ap.offsets[static_cast<std::size_t>(fine)]);
  };
  Rows rows(p.coarseCount);
  for (Index row = 0; row < p.coarseCount; ++row) {
    const auto first = static_cast<std::size_t>(pt.offsets[static_cast<std::size_t>(row)]);
    const auto last = static_cast<std::size_t>(pt.offsets[static_cast<std::size_t>(row) + 1]);
    std::size_t most = 0;
    for (std::size_t k = first; k < last; ++k) {
      most += begin(pt.columns[k] + 1) - begin(pt.columns[k]);
    }
    rows.begin(most);
    for (std::size_t k = first; k < last; ++k) {
      for (std::size_t m = begin(pt.columns[k]); m < begin(pt.columns[k] + 1); ++m) {
        rows.add(ap.columns[m], pt.values[k] * ap.values[m]);
      }
    }
    out.diagonal.push_back(rows.take(row));
    out.offsets.push_back(rows.filled());
  }
  rows.moveTo(out.columns, out.values);
  return out;
}

}  // namespace graftsman
