#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A set of indices in [0, size), one bit each: small beside the mesh whose parts it marks, and always in
/// order.
class IndexSet {
 public:
  explicit IndexSet(Index size) : words_((static_cast<std::size_t>(size) + 63) / 64, 0) {}

  [[nodiscard]] bool contains(Index i) const { return (words_[word(i)] & bit(i)) != 0; }

  /// True if i was not in the set before.
  bool insert(Index i) {
    std::uint64_t& w = words_[word(i)];
    const bool isNew = (w & bit(i)) == 0;
    w |= bit(i);
    return isNew;
  }

  /// Calls body(i) for every i in the set, ascending.
  template <class Body>
  void forEach(const Body& body) const {
    for (std::size_t k = 0; k < words_.size(); ++k) {
      for (std::uint64_t rest = words_[k]; rest != 0; rest &= rest - 1) {
        body(static_cast<Index>(64 * k) + std::countr_zero(rest));
      }
    }
  }

 private:
  static std::size_t word(Index i) { return static_cast<std::size_t>(i) / 64; }
  static std::uint64_t bit(Index i) { return std::uint64_t{1} << (i % 64); }

  std::vector<std::uint64_t> words_;
};

}  // namespace graftsman
