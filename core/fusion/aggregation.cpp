#include "core/fusion/aggregation.h"

#include <algorithm>
#include <numeric>

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

/// Adds up one row of a sparse product.
class RowSum {
 public:
  explicit RowSum(Index columns) : place_(static_cast<std::size_t>(columns), -1) {}

  void add(Index column, double value) {
    Index& place = place_[static_cast<std::size_t>(column)];
    if (place < 0) {
      place = static_cast<Index>(columns_.size());
      columns_.push_back(column);
      values_.push_back(value);
    } else {
      values_[static_cast<std::size_t>(place)] += value;
    }
  }

  [[nodiscard]] const std::vector<Index>& columns() const { return columns_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

  void clear() {
    for (const Index column : columns_) {
      place_[static_cast<std::size_t>(column)] = -1;
    }
    columns_.clear();
    values_.clear();
  }

 private:
  std::vector<Index> place_;
  std::vector<Index> columns_;
  std::vector<double> values_;
};

/// A P, in the shape of a Prolongation.
Prolongation product(const SparseRows& a, const Prolongation& p) {
  Prolongation out;
  out.coarseCount = p.coarseCount;
  out.offsets.reserve(a.rows() + 1);
  out.offsets.push_back(0);
  out.columns.reserve(2 * p.columns.size());
  out.values.reserve(2 * p.columns.size());
  RowSum sum(p.coarseCount);
  const auto addRow = [&](Index row, double factor) {
    const auto r = static_cast<std::size_t>(row);
    for (auto k = static_cast<std::size_t>(p.offsets[r]); k < static_cast<std::size_t>(p.offsets[r + 1]);
         ++k) {
      sum.add(p.columns[k], factor * p.values[k]);
    }
  };
  for (std::size_t r = 0; r < a.rows(); ++r) {
    addRow(static_cast<Index>(r), a.diagonal[r]);
    for (auto k = static_cast<std::size_t>(a.offsets[r]); k < static_cast<std::size_t>(a.offsets[r + 1]);
         ++k) {
      addRow(a.columns[k], a.values[k]);
    }
    out.columns.insert(out.columns.end(), sum.columns().begin(), sum.columns().end());
    out.values.insert(out.values.end(), sum.values().begin(), sum.values().end());
    out.offsets.push_back(static_cast<Index>(out.columns.size()));
    sum.clear();
  }
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

void appendRow(Index row, const RowSum& sum, SparseRows& out) {
  double diagonal = 0;
  for (const bool upper : {false, true}) {
    for (std::size_t k = 0; k < sum.columns().size(); ++k) {
      const Index column = sum.columns()[k];
      if (column == row) {
        diagonal = sum.values()[k];
      } else if ((column > row) == upper) {
        out.columns.push_back(column);
        out.values.push_back(sum.values()[k]);
      }
    }
    if (!upper) {
      out.middles.push_back(static_cast<Index>(out.columns.size()));
    }
  }
  out.offsets.push_back(static_cast<Index>(out.columns.size()));
  out.diagonal.push_back(diagonal);
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
  out.offsets.push_back(0);
  RowSum sum(p.coarseCount);
  for (Index row = 0; row < p.coarseCount; ++row) {
    const auto r = static_cast<std::size_t>(row);
    for (auto k = static_cast<std::size_t>(pt.offsets[r]); k < static_cast<std::size_t>(pt.offsets[r + 1]);
         ++k) {
      const auto fine = static_cast<std::size_t>(pt.columns[k]);
      for (auto m = static_cast<std::size_t>(ap.offsets[fine]);
           m < static_cast<std::size_t>(ap.offsets[fine + 1]); ++m) {
        sum.add(ap.columns[m], pt.values[k] * ap.values[m]);
      }
    }
    appendRow(row, sum, out);
    sum.clear();
  }
  return out;
}

}  // namespace graftsman
